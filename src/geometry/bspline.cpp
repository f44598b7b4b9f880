#include "geometry/bspline.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace blockfsi::geometry
{

namespace
{

std::string times_text(int times)
{
  return times == 1 ? "once" : fmt::format("{} times", times);
}

void check_order(std::string_view what, int degree, std::span<const double> knots)
{
  for (std::size_t i = 0; i < knots.size(); ++i)
  {
    if (!std::isfinite(knots[i]))
      throw Error(fmt::format("{}: knot {} is {}; it must be finite", what, i + 1, knots[i]));
    if (i > 0 && knots[i] < knots[i - 1])
      throw Error(fmt::format("{}: knot {} is {:.9g}, less than knot {}, {:.9g}; knots must not decrease",
                              what, i + 1, knots[i], i, knots[i - 1]));
  }
  // Runs of equal knots.
  for (std::size_t i = 0; i < knots.size();)
  {
    std::size_t end = i + 1;
    while (end < knots.size() && knots[end] == knots[i])
      ++end;
    const auto times = static_cast<int>(end - i);
    const bool outer = i == 0 || end == knots.size();
    if (outer && times != degree + 1)
      throw Error(fmt::format("{}: the {} knot, {:.9g}, is listed {}; degree {} needs it {} times, so that "
                              "the curve ends at its control point",
                              what, i == 0 ? "first" : "last", knots[i], times_text(times), degree,
                              degree + 1));
    if (!outer && times > degree)
      throw Error(fmt::format("{}: knot {}, {:.9g}, is listed {}; degree {} allows that {}, else the "
                              "curve is torn there",
                              what, i + 1, knots[i], times_text(times), degree, times_text(degree)));
    i = end;
  }
}

}  // namespace

void check_knots(std::string_view what, int degree, std::span<const double> knots, std::size_t point_count)
{
  if (degree < 1 || degree > max_degree)
    throw Error(fmt::format("{}: the degree is {}; it must be from 1 to {}", what, degree, max_degree));
  if (point_count < static_cast<std::size_t>(degree) + 1)
    throw Error(fmt::format("{}: found {} control points; degree {} needs at least {}", what, point_count,
                            degree, degree + 1));
  const std::size_t needed = point_count + degree + 1;
  if (knots.size() != needed)
    throw Error(fmt::format("{}: found {} knots; {} control points of degree {} need {}", what, knots.size(),
                            point_count, degree, needed));
  check_order(what, degree, knots);
}

std::vector<double> clamped_knots(int degree, std::size_t point_count)
{
  const auto spans = static_cast<int>(point_count) - degree;
  std::vector<double> knots(degree, 0.0);
  for (int i = 0; i <= spans; ++i)
    knots.push_back(static_cast<double>(i) / spans);
  knots.insert(knots.end(), degree, 1.0);
  return knots;
}

}  // namespace blockfsi::geometry
