#include "run/measures.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace blockfsi::run
{

output::Window window_around(std::span<const double> points, double room)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  output::Window window{{infinity, infinity}, {-infinity, -infinity}};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    window.low[i % 2] = std::min(window.low[i % 2], points[i]);
    window.high[i % 2] = std::max(window.high[i % 2], points[i]);
  }
  const double margin = room * std::max(window.high[0] - window.low[0], window.high[1] - window.low[1]);
  for (int c = 0; c < 2; ++c)
  {
    window.low[c] -= margin;
    window.high[c] += margin;
  }
  return window;
}

output::Figure figure_of(const Measure& measure, std::string title, std::string x_label,
                         std::vector<output::Curve> curves)
{
  output::Figure figure;
  figure.title = std::move(title);
  figure.x_label = std::move(x_label);
  figure.y_label = std::string(measure.label);
  figure.is_logarithmic = measure.is_logarithmic;
  figure.y_low = measure.low;
  figure.y_high = measure.high;
  figure.curves = std::move(curves);
  for (output::Curve& curve : figure.curves)
    for (double& y : curve.y)
      y = std::clamp(y, measure.low.value_or(y), measure.high.value_or(y));
  return figure;
}

}  // namespace blockfsi::run
