#include "output/svg.hpp"
#include "output/svg_style.hpp"

#include "output/encode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockfsi::output
{

namespace
{

constexpr double width = 780.0;
constexpr double left = 66.0;
constexpr double top = 40.0;
constexpr double plot_width = 500.0;
constexpr double plot_height = 300.0;
constexpr double legend_step = 20.0;

/// Points that one curve keeps per unit of its width.
constexpr int bins = 250;

struct Extent
{
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value)
  {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// From a value to its place along an axis, in [0, 1].
struct Axis
{
  double low = 0.0;
  double high = 1.0;
  bool is_logarithmic = false;
  std::vector<double> ticks;

  double transformed(double value) const { return is_logarithmic ? std::log10(value) : value; }
  double operator()(double value) const
  {
    return (transformed(value) - transformed(low)) / (transformed(high) - transformed(low));
  }
  bool shows(double value) const { return std::isfinite(value) && (!is_logarithmic || value > 0.0); }
};

/// A step of 1, 2 or 5 times a power of ten that divides a range into about `count`.
double nice_step(double range, int count)
{
  const double rough = range / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power)
      return factor * power;
  return 10.0 * power;
}

Axis linear_axis(double low, double high, bool keep_low, bool keep_high)
{
  if (!(high > low))
  {
    const double room = low != 0.0 ? 0.1 * std::abs(low) : 1.0;
    low -= keep_low ? 0.0 : room;
    high += room;
  }
  const double step = nice_step(high - low, 6);
  Axis axis;
  axis.low = keep_low ? low : step * std::floor(low / step + 1e-9);
  axis.high = keep_high ? high : step * std::ceil(high / step - 1e-9);
  for (double k = std::ceil(axis.low / step - 1e-9); k * step <= axis.high + 1e-9 * step; ++k)
    axis.ticks.push_back(k == 0.0 ? 0.0 : k * step);
  return axis;
}

Axis logarithmic_axis(double low, double high)
{
  Axis axis;
  axis.is_logarithmic = true;
  const double first = std::floor(std::log10(low) + 1e-9);
  const double last = std::max(first + 1.0, std::ceil(std::log10(high) - 1e-9));
  axis.low = std::pow(10.0, first);
  axis.high = std::pow(10.0, last);
  const double step = std::max(1.0, std::ceil((last - first) / 8.0));
  for (double k = first; k <= last + 1e-9; k += step)
    axis.ticks.push_back(std::pow(10.0, k));
  return axis;
}

struct Axes
{
  Axis x;
  Axis y;
};

Axes axes_of(const Figure& figure)
{
  Extent x;
  Extent y;
  for (const Curve& curve : figure.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      if (std::isfinite(curve.y[i]) && (!figure.is_logarithmic || curve.y[i] > 0.0))
      {
        x.add(curve.x[i]);
        y.add(curve.y[i]);
      }
  if (!(x.high >= x.low))
  {
    x = {0.0, 1.0};
    y = {figure.is_logarithmic ? 0.1 : 0.0, 1.0};
  }
  Axes axes;
  axes.x = linear_axis(x.low, x.high, true, true);
  axes.y = figure.is_logarithmic
               ? logarithmic_axis(figure.y_low.value_or(y.low), figure.y_high.value_or(y.high))
               : linear_axis(figure.y_low.value_or(y.low), figure.y_high.value_or(y.high),
                             figure.y_low.has_value(), figure.y_high.has_value());
  return axes;
}

/// Which points of a curve to draw: all, or the least and greatest of each bin, in their order.
std::vector<std::size_t> kept_points(const Curve& curve, const Axes& axes)
{
  std::vector<std::size_t> kept;
  if (curve.x.size() <= 2 * bins)
  {
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      kept.push_back(i);
    return kept;
  }
  const auto bin = [&](std::size_t i) { return std::floor(axes.x(curve.x[i]) * bins); };
  for (std::size_t i = 0; i < curve.x.size();)
  {
    std::size_t least = i;
    std::size_t greatest = i;
    const double here = bin(i);
    const std::size_t first = i;
    for (; i < curve.x.size() && bin(i) == here; ++i)
    {
      least = curve.y[i] < curve.y[least] ? i : least;
      greatest = curve.y[i] > curve.y[greatest] ? i : greatest;
    }
    std::vector<std::size_t> some = {first, std::min(least, greatest), std::max(least, greatest), i - 1};
    some.erase(std::unique(some.begin(), some.end()), some.end());
    kept.insert(kept.end(), some.begin(), some.end());
  }
  return kept;
}

std::array<double, 2> place(const Axes& axes, double x, double y)
{
  return {left + plot_width * axes.x(x), top + plot_height * (1.0 - axes.y(y))};
}

void add_axes(std::string& out, const Figure& figure, const Axes& axes)
{
  for (const double tick : axes.x.ticks)
  {
    const double at = left + plot_width * axes.x(tick);
    out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {}v{}\"/>", at, top, plot_height);
    out += fmt::format("<text class=\"small\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:.6g}</text>\n",
                       at, top + plot_height + 18.0, tick);
  }
  for (const double tick : axes.y.ticks)
  {
    const double at = top + plot_height * (1.0 - axes.y(tick));
    out += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}h{}\"/>", left, at, plot_width);
    out += fmt::format("<text class=\"small\" x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:.6g}</text>\n",
                       left - 7.0, at + 4.0, tick);
  }
  out += fmt::format("<path class=\"axis\" d=\"M{} {}h{}v{}h-{}z\"/>\n", left, top, plot_width, plot_height,
                     plot_width);
  out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", left + 0.5 * plot_width,
                     top + plot_height + 40.0, escape_xml(figure.x_label));
  out += fmt::format(
      "<text x=\"16\" y=\"{0}\" text-anchor=\"middle\" transform=\"rotate(-90 16 {0})\">{1}</text>\n",
      top + 0.5 * plot_height, escape_xml(figure.y_label));
}

void add_curve(std::string& out, const Curve& curve, const Axes& axes, int number)
{
  std::string path;
  bool down = false;
  std::array<double, 2> last = {NAN, NAN};
  for (const std::size_t i : kept_points(curve, axes))
  {
    const bool shown = axes.y.shows(curve.y[i]) && std::isfinite(curve.x[i]);
    if (shown)
    {
      last = place(axes, curve.x[i], curve.y[i]);
      path += fmt::format("{}{:.1f} {:.1f}", down ? "L" : "M", last[0], last[1]);
    }
    down = shown;
  }
  const int style = number % svg::colour_count;
  if (path.empty())
    return;
  out += fmt::format("<path class=\"line c{}\" clip-path=\"url(#plot)\" d=\"{}\"/>\n", style, path);
  if (curve.is_cut_short)
    out += fmt::format("<path class=\"end c{}\" stroke-dasharray=\"none\" style=\"stroke-dasharray:none\" "
                       "d=\"M{:.1f} {:.1f}l10 10m0 -10l-10 10\"/>\n",
                       style, last[0] - 5.0, last[1] - 5.0);
}

}  // namespace

std::string draw(const Figure& figure)
{
  const Axes axes = axes_of(figure);
  const double height = std::max(top + plot_height + 56.0,
                                 top + legend_step * static_cast<double>(figure.curves.size()) + 20.0);
  std::string out =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
                  "height=\"{1}\" role=\"img\">\n<title>{2}</title>\n",
                  width, height, escape_xml(figure.title));
  out += svg::style;
  out +=
      fmt::format("\n<clipPath id=\"plot\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n",
                  left - 1.0, top - 1.0, plot_width + 2.0, plot_height + 2.0);
  out += fmt::format("<rect class=\"page\" width=\"{}\" height=\"{}\"/>\n", width, height);
  out += fmt::format("<text class=\"title\" x=\"{}\" y=\"24\">{}</text>\n", left, escape_xml(figure.title));
  add_axes(out, figure, axes);
  for (std::size_t k = 0; k < figure.curves.size(); ++k)
  {
    add_curve(out, figure.curves[k], axes, static_cast<int>(k));
    const double y = top + 10.0 + legend_step * static_cast<double>(k);
    out += fmt::format("<path class=\"line c{}\" d=\"M{} {}h34\"/>", k % svg::colour_count,
                       left + plot_width + 16.0, y);
    out += fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>\n", left + plot_width + 56.0,
                       y + 4.0, escape_xml(figure.curves[k].name));
  }
  return out + "</svg>\n";
}

}  // namespace blockfsi::output
