#include "output/svg_pen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blockfsi::output::svg
{

namespace
{

std::array<long, 2> whole(const Point& point)
{
  return {std::lround(point[0]), std::lround(point[1])};
}

std::string separated(const std::string& number)
{
  return (number[0] == '-' ? "" : " ") + number;
}

/// Whether the control points of a piece lie within a unit of its chord: then a line looks the same.
bool is_straight(std::span<const Point> p)
{
  const Point chord = {p[3][0] - p[0][0], p[3][1] - p[0][1]};
  const double length = std::hypot(chord[0], chord[1]);
  for (int k = 1; k <= 2; ++k)
  {
    const double off = chord[0] * (p[k][1] - p[0][1]) - chord[1] * (p[k][0] - p[0][0]);
    if (std::abs(off) > 0.7 * length)
      return false;
  }
  return true;
}

}  // namespace

EdgeCurve::EdgeCurve(int order) : pieces_((order + 2) / 3), nodes_(order + 1)
{
  std::vector<double> ends;
  for (int k = 0; k <= pieces_; ++k)
    ends.push_back(static_cast<double>(k) / pieces_);
  table_ = element::lagrange(element::lobatto(order), ends);
}

std::vector<Point> EdgeCurve::control(std::span<const Point> nodes) const
{
  std::vector<Point> result(3 * pieces_ + 1);
  for (int k = 0; k <= pieces_; ++k)
  {
    Point at{};
    Point slope{};
    for (int i = 0; i < nodes_; ++i)
      for (int c = 0; c < 2; ++c)
      {
        at[c] += table_.value[k * nodes_ + i] * nodes[i][c];
        slope[c] += table_.first[k * nodes_ + i] * nodes[i][c] / (3.0 * pieces_);
      }
    result[3 * k] = at;
    if (k > 0)
      result[3 * k - 1] = {at[0] - slope[0], at[1] - slope[1]};
    if (k < pieces_)
      result[3 * k + 1] = {at[0] + slope[0], at[1] + slope[1]};
  }
  return result;
}

bool Frame::shows(std::span<const Point> points) const
{
  Point low = points[0];
  Point high = points[0];
  for (const Point& point : points)
    for (int c = 0; c < 2; ++c)
    {
      low[c] = std::min(low[c], point[c]);
      high[c] = std::max(high[c], point[c]);
    }
  return high[0] >= 0.0 && low[0] <= width() && high[1] >= 0.0 && low[1] <= height();
}

void Pen::move(const Point& to)
{
  at_ = whole(to);
  text += "M" + pair(at_[0], at_[1]);
}

void Pen::line(const Point& to)
{
  const std::array<long, 2> next = whole(to);
  text += "l" + step(next);
  at_ = next;
}

void Pen::curve(const Point& a, const Point& b, const Point& to)
{
  const std::array<long, 2> next = whole(to);
  text += "c" + step(whole(a)) + separated(step(whole(b))) + separated(step(next));
  at_ = next;
}

void Pen::trace(std::span<const Point> control)
{
  for (std::size_t k = 0; k + 3 < control.size(); k += 3)
  {
    const std::span<const Point> piece = control.subspan(k, 4);
    if (is_straight(piece))
      line(piece[3]);
    else
      curve(piece[1], piece[2], piece[3]);
  }
}

std::string Pen::pair(long x, long y) const
{
  if (numbers_ == Numbers::in_units)
    return fmt::format("{}", x) + separated(fmt::format("{}", y));
  return fmt::format("{}", static_cast<double>(x) / units) +
         separated(fmt::format("{}", static_cast<double>(y) / units));
}

std::string Pen::step(const std::array<long, 2>& to) const
{
  return pair(to[0] - at_[0], to[1] - at_[1]);
}

}  // namespace blockfsi::output::svg
