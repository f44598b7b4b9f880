#pragma once

// Private to output/: smooth curves as paths of SVG.

#include "element/line.hpp"
#include "output/svg.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace blockfsi::output::svg
{

using Point = std::array<double, 2>;

/// Units of the coordinates in a drawing per pixel of the page: whole numbers are then fine enough.
inline constexpr double units = 10.0;

/// Cubic Bezier pieces of a polynomial edge: exact up to order 3, above that Hermite interpolation of two or
/// three pieces.
class EdgeCurve
{
public:
  explicit EdgeCurve(int order);

  int pieces() const { return pieces_; }

  /// The 3 pieces + 1 control points of an edge with these nodes.
  std::vector<Point> control(std::span<const Point> nodes) const;

private:
  int pieces_;
  int nodes_;
  element::Table table_;
};

/// From the plane to the units of a drawing, y downwards.
struct Frame
{
  Window window;
  double scale = 1.0;

  Point operator()(double x, double y) const
  {
    return {(x - window.low[0]) * scale, (window.high[1] - y) * scale};
  }
  double width() const { return (window.high[0] - window.low[0]) * scale; }
  double height() const { return (window.high[1] - window.low[1]) * scale; }

  /// Whether the box around some points meets the drawing.
  bool shows(std::span<const Point> points) const;
};

/// How a pen writes the units of a drawing.
enum class Numbers
{
  in_units,  ///< as they are: whole numbers
  in_pixels  ///< as pixels with one decimal
};

/// Writes paths rounded to whole units, relative to where the pen is, which keeps files small.
class Pen
{
public:
  explicit Pen(Numbers numbers = Numbers::in_units) : numbers_(numbers) {}

  void move(const Point& to);
  void line(const Point& to);
  void curve(const Point& a, const Point& b, const Point& to);
  /// Goes along the control points of some pieces from their first, where the pen is; straight ones become
  /// lines.
  void trace(std::span<const Point> control);
  void close() { text += "z"; }

  std::string text;

private:
  std::string pair(long x, long y) const;
  std::string step(const std::array<long, 2>& to) const;

  Numbers numbers_;
  std::array<long, 2> at_{};
};

}  // namespace blockfsi::output::svg
