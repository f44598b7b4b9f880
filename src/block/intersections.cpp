#include "block/intersections.hpp"

#include "block/message.hpp"
#include "geometry/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace blockfsi::block
{

namespace
{

using geometry::Point;

constexpr int pieces_of_curve = 32;
constexpr double tolerance = 1e-9;  ///< of the size of the layout
constexpr int most_steps = 30;      ///< of Newton's method for a crossing of curves

/// A straight piece of an edge between two of its parameters.
struct Piece
{
  int edge;
  double t0;
  double t1;
  Point x0;
  Point x1;

  double low(int c) const { return std::min(x0[c], x1[c]); }
  double high(int c) const { return std::max(x0[c], x1[c]); }
};

/// Twice the area of a triangle, positive if it runs counter-clockwise.
double turn(const Point& a, const Point& b, const Point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

class Checker
{
public:
  Checker(const Layout& layout, const Topology& topology)
      : layout_(layout), topology_(topology), size_(layout_size(layout))
  {
  }

  void check()
  {
    cut();
    std::sort(pieces_.begin(), pieces_.end(),
              [](const Piece& a, const Piece& b) { return a.low(0) < b.low(0); });
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      for (std::size_t j = i + 1; j < pieces_.size() && pieces_[j].low(0) <= pieces_[i].high(0) + slack();
           ++j)
        if (pieces_[j].low(1) <= pieces_[i].high(1) + slack() &&
            pieces_[i].low(1) <= pieces_[j].high(1) + slack())
          compare(pieces_[i], pieces_[j]);
  }

private:
  double slack() const { return tolerance * size_; }
  const PlacedEdge& edge(int e) const { return topology_.edges[e]; }
  bool is_straight(int e) const { return block::is_straight(layout_, topology_, e); }

  void cut()
  {
    for (std::size_t e = 0; e < topology_.edges.size(); ++e)
    {
      const geometry::Path path = edge_path(layout_, topology_, static_cast<int>(e));
      const int count = is_straight(static_cast<int>(e)) ? 1 : pieces_of_curve;
      Point before = path.evaluate(0.0);
      for (int i = 0; i < count; ++i)
      {
        const double t1 = static_cast<double>(i + 1) / count;
        const Point x = path.evaluate(t1);
        pieces_.push_back({static_cast<int>(e), static_cast<double>(i) / count, t1, before, x});
        before = x;
      }
    }
  }

  void compare(const Piece& a, const Piece& b) const
  {
    // A curve that crosses itself has an own loop: pieces next to each other share a point and never do.
    const bool straight = is_straight(a.edge) && is_straight(b.edge);
    if (straight)
      for (const auto& [line, other] : {std::pair{&a, &b}, {&b, &a}})
        for (const int point : {edge(other->edge).a, edge(other->edge).b})
          if (touches(*line, point))
            throw mistake(
                place(line->edge),
                fmt::format("the point {} lies on the edge {}, which does not end there; divide the "
                            "blocks at that edge or move the point",
                            point_text(layout_, point), text(line->edge)));
    if (straight && share_end(a.edge, b.edge))
      return;
    const double a0 = turn(b.x0, b.x1, a.x0);
    const double a1 = turn(b.x0, b.x1, a.x1);
    const double b0 = turn(a.x0, a.x1, b.x0);
    const double b1 = turn(a.x0, a.x1, b.x1);
    if (!(a0 * a1 < 0.0) || !(b0 * b1 < 0.0))
      return;
    double s = a.t0 + a0 / (a0 - a1) * (a.t1 - a.t0);
    double t = b.t0 + b0 / (b0 - b1) * (b.t1 - b.t0);
    if (!straight && !meet(a.edge, b.edge, s, t))
      return;
    const Point x = edge_path(layout_, topology_, a.edge).evaluate(s);
    if (a.edge == b.edge)
      throw mistake(place(a.edge), fmt::format("the edge {} crosses itself at {}; bend it less or divide it",
                                               text(a.edge), geometry::text(x)));
    const int first = std::min(a.edge, b.edge);
    const int second = std::max(a.edge, b.edge);
    throw mistake(place(second),
                  fmt::format("the edges {} and {} cross at {}; move their points or change their curves",
                              text(first), text(second), geometry::text(x)));
  }

  /// Whether a point lies on a straight edge, apart from its ends.
  bool touches(const Piece& line, int point) const
  {
    if (point == edge(line.edge).a || point == edge(line.edge).b)
      return false;
    const Point along = geometry::subtract(line.x1, line.x0);
    const Point& x = layout_.points[point].x;
    const double share = geometry::dot(geometry::subtract(x, line.x0), along) / geometry::dot(along, along);
    return share > 0.0 && share < 1.0 &&
           std::abs(turn(line.x0, line.x1, x)) < slack() * geometry::norm(along);
  }

  /// Newton's method from where pieces cross to where the curves do, apart from a point that both have.
  bool meet(int a, int b, double& s, double& t) const
  {
    const geometry::Path path_a = edge_path(layout_, topology_, a);
    const geometry::Path path_b = edge_path(layout_, topology_, b);
    for (int step = 0; step < most_steps; ++step)
    {
      const Point miss = geometry::subtract(path_b.evaluate(t), path_a.evaluate(s));
      const Point u = path_a.derivative(s);
      const Point v = path_b.derivative(t);
      const double determinant = u[1] * v[0] - u[0] * v[1];
      if (geometry::norm(miss) < slack())
        return !is_common_end(a, b, path_a.evaluate(s)) && (a != b || std::abs(s - t) > tolerance);
      if (determinant == 0.0)
        return false;
      s = std::clamp(s + (miss[1] * v[0] - miss[0] * v[1]) / determinant, 0.0, 1.0);
      t = std::clamp(t + (u[0] * miss[1] - u[1] * miss[0]) / determinant, 0.0, 1.0);
    }
    return false;
  }

  bool share_end(int a, int b) const
  {
    return edge(a).a == edge(b).a || edge(a).a == edge(b).b || edge(a).b == edge(b).a ||
           edge(a).b == edge(b).b;
  }

  bool is_common_end(int a, int b, const Point& x) const
  {
    for (const int point : {edge(a).a, edge(a).b})
      if ((point == edge(b).a || point == edge(b).b) &&
          geometry::distance(layout_.points[point].x, x) < 1e-6 * size_)
        return true;
    return false;
  }

  std::string text(int e) const { return edge_text(layout_, edge(e).a, edge(e).b); }
  const Location& place(int e) const
  {
    const int info = topology_.info[e];
    return info >= 0 ? layout_.edges[info].where : layout_.blocks[edge(e).blocks[0]].where;
  }

  const Layout& layout_;
  const Topology& topology_;
  double size_ = 0.0;
  std::vector<Piece> pieces_;
};

}  // namespace

void check_intersections(const Layout& layout, const Topology& topology)
{
  if (layout.dim == 2)
    Checker(layout, topology).check();
}

}  // namespace blockfsi::block
