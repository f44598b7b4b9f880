#include "block/intersections.hpp"

#include "block/message.hpp"
#include "geometry/box_tree.hpp"
#include "geometry/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace blockfsi::block
{

namespace
{

using geometry::Box;
using geometry::Point;

constexpr int first_pieces = 8;         ///< of a curve
constexpr double tolerance = 1e-9;      ///< of the size of the layout
constexpr double smallest = 1e-7;       ///< piece that is halved, of the size of the layout
constexpr double safety = 1.5;          ///< for curves that bend unevenly
constexpr int most_comparisons = 4000;  ///< of the halves of two pieces
constexpr int most_steps = 30;          ///< of Newton's method

/// A part of an edge between two of its parameters, no farther from its chord than `bend`.
struct Piece
{
  int edge;
  double t0;
  double t1;
  Point x0;
  Point x1;
  double bend = 0.0;

  double length() const { return geometry::distance(x0, x1); }
};

/// Signed distance from the line through a piece, positive on its left.
double height(const Piece& piece, const Point& p)
{
  return ((piece.x1[0] - piece.x0[0]) * (p[1] - piece.x0[1]) -
          (piece.x1[1] - piece.x0[1]) * (p[0] - piece.x0[0])) /
         piece.length();
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
    std::vector<Box> boxes;
    for (const Piece& piece : pieces_)
      boxes.push_back(box(piece));
    for (const Point& x : points_)
      boxes.push_back({x, x});
    const auto pairs = geometry::meeting_pairs(boxes);
    const auto piece_count = static_cast<std::int32_t>(pieces_.size());
    for (const auto& [i, j] : pairs)
      if (i < piece_count && j >= piece_count)
        check_point(pieces_[i], j - piece_count);
    for (const auto& [i, j] : pairs)
      if (j < piece_count)
        compare(pieces_[i], pieces_[j]);
  }

private:
  double slack() const { return tolerance * size_; }
  const PlacedEdge& edge(int e) const { return topology_.edges[e]; }
  bool is_straight(int e) const { return block::is_straight(layout_, topology_, e); }
  Box box(const Piece& piece) const
  {
    return geometry::box_around(std::array{piece.x0, piece.x1}, piece.bend + slack());
  }

  void cut()
  {
    for (const block::Point& point : layout_.points)
      points_.push_back(point.x);
    for (int e = 0; e < static_cast<int>(topology_.edges.size()); ++e)
    {
      paths_.push_back(edge_path(layout_, topology_, e));
      const int count = is_straight(e) ? 1 : first_pieces;
      Point before = paths_[e].evaluate(0.0);
      for (int i = 0; i < count; ++i)
      {
        const double t1 = static_cast<double>(i + 1) / count;
        const Point x = paths_[e].evaluate(t1);
        pieces_.push_back(piece(e, static_cast<double>(i) / count, t1, before, x));
        before = x;
      }
    }
  }

  Piece piece(int e, double t0, double t1, const Point& x0, const Point& x1) const
  {
    Piece result{e, t0, t1, x0, x1};
    if (is_straight(e))
      return result;
    for (const double share : {0.25, 0.5, 0.75})
    {
      const Point x = paths_[e].evaluate(t0 + share * (t1 - t0));
      const double off = result.length() > 0.0 ? std::abs(height(result, x)) : geometry::distance(x, x0);
      result.bend = std::max(result.bend, safety * off);
    }
    return result;
  }

  std::array<Piece, 2> halves(const Piece& whole) const
  {
    const double middle = 0.5 * (whole.t0 + whole.t1);
    const Point x = paths_[whole.edge].evaluate(middle);
    return {piece(whole.edge, whole.t0, middle, whole.x0, x),
            piece(whole.edge, middle, whole.t1, x, whole.x1)};
  }

  /// Newton's method for the nearest point of a piece.
  void check_point(const Piece& piece, int point) const
  {
    if (point == edge(piece.edge).a || point == edge(piece.edge).b)
      return;
    const geometry::Path& path = paths_[piece.edge];
    const Point& x = points_[point];
    double t = 0.5 * (piece.t0 + piece.t1);
    for (int step = 0; step < most_steps; ++step)
    {
      const Point along = path.derivative(t);
      const Point miss = geometry::subtract(x, path.evaluate(t));
      if (geometry::norm(miss) <= slack() && t > 0.0 && t < 1.0)
        throw mistake(place(piece.edge),
                      fmt::format("the point {} lies on the edge {}, which does not end there; divide the "
                                  "blocks at that edge or move the point",
                                  point_text(layout_, point), text(piece.edge)));
      const double change = geometry::dot(miss, along) / geometry::dot(along, along);
      if (!(std::abs(change) > 1e-15))
        return;
      t = std::clamp(t + change, piece.t0, piece.t1);
    }
  }

  void compare(const Piece& a, const Piece& b) const
  {
    const bool follow = a.edge == b.edge && (a.t1 == b.t0 || b.t1 == a.t0);
    if (follow || (is_straight(a.edge) && is_straight(b.edge) && share_end(a.edge, b.edge)))
      return;
    int left = most_comparisons;
    const std::optional<Point> crossing = find(a, b, left);
    if (!crossing)
      return;
    const std::string x = geometry::text(*crossing);
    if (a.edge == b.edge)
      throw mistake(place(a.edge), fmt::format("the edge {} crosses itself at {}; bend it less or divide it",
                                               text(a.edge), x));
    const auto [first, second] = std::minmax({a.edge, b.edge});
    throw mistake(place(second),
                  fmt::format("the edges {} and {} cross at {}; move their points or change their curves",
                              text(first), text(second), x));
  }

  /// Where two pieces cross, by halving the more curved one until their chords tell. Pieces that touch have
  /// no end of it, so the smallest ones and the last of many tell nothing.
  std::optional<Point> find(const Piece& a, const Piece& b, int& left) const
  {
    if (--left < 0 || are_apart(a, b))
      return {};
    if (are_across(a, b) && are_across(b, a))
      return crossing(a, b);
    const bool first = a.bend != b.bend ? a.bend > b.bend : a.length() > b.length();
    const Piece& halved = first ? a : b;
    if (is_straight(halved.edge) || !(halved.length() > smallest * size_))
      return {};
    for (const Piece& half : halves(halved))
      if (const auto found = first ? find(half, b, left) : find(a, half, left))
        return found;
    return {};
  }

  /// Whether no point of one piece can be one of the other.
  bool are_apart(const Piece& a, const Piece& b) const
  {
    if (!box(a).meets(box(b)))
      return true;
    const double width = a.bend + b.bend + slack();
    for (const auto& [line, other] : {std::pair{&a, &b}, {&b, &a}})
    {
      if (!(line->length() > 0.0))
        continue;
      const auto [low, high] = std::minmax({height(*line, other->x0), height(*line, other->x1)});
      if (low > width || high < -width)
        return true;
    }
    return false;
  }

  /// Whether the ends of a piece lie on either side of the other one, whatever the curve between its ends.
  bool are_across(const Piece& line, const Piece& other) const
  {
    const double from = height(line, other.x0);
    const double to = height(line, other.x1);
    return from * to < 0.0 && std::min(std::abs(from), std::abs(to)) > line.bend;
  }

  /// Newton's method from where the chords cross to where the curves do.
  Point crossing(const Piece& a, const Piece& b) const
  {
    const auto share = [](double from, double to) { return from / (from - to); };
    double s = a.t0 + share(height(b, a.x0), height(b, a.x1)) * (a.t1 - a.t0);
    double t = b.t0 + share(height(a, b.x0), height(a, b.x1)) * (b.t1 - b.t0);
    for (int step = 0; step < most_steps; ++step)
    {
      const Point miss = geometry::subtract(paths_[b.edge].evaluate(t), paths_[a.edge].evaluate(s));
      const Point u = paths_[a.edge].derivative(s);
      const Point v = paths_[b.edge].derivative(t);
      const double determinant = u[1] * v[0] - u[0] * v[1];
      if (geometry::norm(miss) < 1e-3 * slack() || determinant == 0.0)
        break;
      s = std::clamp(s + (miss[1] * v[0] - miss[0] * v[1]) / determinant, a.t0, a.t1);
      t = std::clamp(t + (u[0] * miss[1] - u[1] * miss[0]) / determinant, b.t0, b.t1);
    }
    return paths_[a.edge].evaluate(s);
  }

  bool share_end(int a, int b) const
  {
    return edge(a).a == edge(b).a || edge(a).a == edge(b).b || edge(a).b == edge(b).a ||
           edge(a).b == edge(b).b;
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
  std::vector<geometry::Path> paths_;
  std::vector<Piece> pieces_;
  std::vector<Point> points_;
};

}  // namespace

void check_intersections(const Layout& layout, const Topology& topology)
{
  if (layout.dim == 2)
    Checker(layout, topology).check();
}

}  // namespace blockfsi::block
