#include "block/overlaps.hpp"

#include "block/message.hpp"
#include "block/numbering.hpp"
#include "block/tiles.hpp"
#include "block/topology.hpp"
#include "geometry/box_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blockfsi::block
{

namespace
{

using geometry::Box;
using geometry::Point;
using Corners = std::array<std::int8_t, 3>;
using Ends = std::array<std::int8_t, 2>;

constexpr double tolerance = 1e-9;  ///< of the size of the layout

/// The triangles that a tile of a face is made of.
std::span<const Corners> triangles(const Tile& tile)
{
  static constexpr std::array<Corners, 2> all{{{0, 1, 2}, {0, 2, 3}}};
  return std::span(all).first(std::max(0, tile.count - 2));
}

/// Its sides and diagonals.
std::span<const Ends> segments(const Tile& tile)
{
  static constexpr std::array<Ends, 3> of_triangle{{{0, 1}, {1, 2}, {0, 2}}};
  static constexpr std::array<Ends, 6> of_quadrilateral{{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}, {1, 3}}};
  switch (tile.count)
  {
  case 2:
    return std::span(of_triangle).first(1);
  case 3:
    return of_triangle;
  case 4:
    return of_quadrilateral;
  default:
    return {};
  }
}

/// A triangle with its unit normal.
struct Triangle
{
  std::array<Point, 3> x;
  Point normal{};

  explicit Triangle(const std::array<Point, 3>& corners) : x(corners)
  {
    normal = geometry::cross(geometry::subtract(x[1], x[0]), geometry::subtract(x[2], x[0]));
    normal = geometry::scaled(1.0 / geometry::norm(normal), normal);
  }
  double height(const Point& p) const { return geometry::dot(geometry::subtract(p, x[0]), normal); }
  /// Whether a point of its plane lies in it or within a distance of that.
  bool contains(const Point& p, double distance) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point along = geometry::subtract(x[(k + 1) % 3], x[k]);
      const Point to = geometry::subtract(p, x[k]);
      if (!(geometry::dot(geometry::cross(along, to), normal) >= -distance * geometry::norm(along)))
        return false;
    }
    return true;
  }
};

/// Where a segment whose ends lie farther than `margin` on either side of a triangle's plane runs through it.
std::optional<Point> crossing(const Point& a, const Point& b, const Triangle& triangle, double margin,
                              double round_off)
{
  const double from = triangle.height(a);
  const double to = triangle.height(b);
  if (!(from * to < 0.0) || !(std::min(std::abs(from), std::abs(to)) > margin))
    return {};
  const Point x = geometry::combine(to / (to - from), a, -from / (to - from), b);
  if (!triangle.contains(x, round_off))
    return {};
  return x;
}

class Checker
{
public:
  Checker(const Layout& layout, const Skeleton& skeleton)
      : layout_(layout), skeleton_(skeleton), tiles_(make_tiles(layout, skeleton)),
        slack_(tolerance * layout_size(layout))
  {
    for (const Tile& tile : tiles_)
      boxes_.push_back(box(tile, slack_));
  }

  void check()
  {
    if (skeleton_.dim == 3)
      for (const auto& [i, j] : geometry::meeting_pairs(boxes_))
      {
        compare(tiles_[i], tiles_[j]);
        compare(tiles_[j], tiles_[i]);
      }
    check_groups();
  }

private:
  Point at(std::int32_t node) const { return node_position(skeleton_, node); }

  Box box(const Tile& tile, double margin) const
  {
    std::array<Point, 4> x;
    for (int k = 0; k < tile.count; ++k)
      x[k] = at(tile.node[k]);
    return geometry::box_around(std::span(x).first(tile.count), margin);
  }

  /// Whether a point or a segment of one tile meets a triangle of the other.
  void compare(const Tile& tile, const Tile& of_face) const
  {
    for (const Corners& corners : triangles(of_face))
    {
      const std::array<std::int32_t, 3> nodes{of_face.node[corners[0]], of_face.node[corners[1]],
                                              of_face.node[corners[2]]};
      const auto is_corner = [&](std::int32_t node)
      { return std::find(nodes.begin(), nodes.end(), node) != nodes.end(); };
      const Triangle triangle({at(nodes[0]), at(nodes[1]), at(nodes[2])});
      if (tile.count == 1)
      {
        const Point x = at(tile.node[0]);
        if (of_face.curvature <= slack_ && !has_corner(of_face, tile.node[0]) &&
            std::abs(triangle.height(x)) <= slack_ && triangle.contains(x, slack_))
          throw point_on_face(tile.entity, of_face.entity);
        continue;
      }
      const double margin = slack_ + tile.curvature + of_face.curvature;
      for (const auto& [first, second] : segments(tile))
      {
        const std::int32_t a = tile.node[first];
        const std::int32_t b = tile.node[second];
        if (is_corner(a) || is_corner(b))
          continue;
        if (const auto x = crossing(at(a), at(b), triangle, margin, slack_); x && !is_on_border(of_face, *x))
          throw cross_at(text(tile, a, b), block_of(tile), of_face, *x);
      }
    }
  }

  /// Whether a point of a tile lies on an edge of its face: what meets that need not go farther.
  bool is_on_border(const Tile& tile, const Point& x) const
  {
    const std::int64_t first_in_face = skeleton_.faces[0].first;
    for (int k = 0; k < tile.count; ++k)
    {
      const std::int32_t a = tile.node[k];
      const std::int32_t b = tile.node[(k + 1) % tile.count];
      const Point along = geometry::subtract(at(b), at(a));
      if (std::max(a, b) < first_in_face &&
          geometry::norm(geometry::cross(along, geometry::subtract(x, at(a)))) <=
              2.0 * slack_ * geometry::norm(along))
        return true;
    }
    return false;
  }

  bool has_corner(const Tile& tile, std::int32_t node) const
  {
    return std::find(tile.node.begin(), tile.node.begin() + tile.count, node) !=
           tile.node.begin() + tile.count;
  }

  const Block& block_of(const Tile& tile) const
  {
    const std::vector<int>& blocks =
        tile.of == Tile::Of::edge ? skeleton_.edges[tile.entity].blocks : skeleton_.faces[tile.entity].blocks;
    return layout_.blocks[blocks[0]];
  }

  /// "(x, y, z)" to six digits, also where z is 0.
  std::string place(const Point& x) const
  {
    const auto rounded = [this](double value) { return std::abs(value) <= slack_ ? 0.0 : value; };
    return skeleton_.dim == 2
               ? fmt::format("({:.6g}, {:.6g})", rounded(x[0]), rounded(x[1]))
               : fmt::format("({:.6g}, {:.6g}, {:.6g})", rounded(x[0]), rounded(x[1]), rounded(x[2]));
  }

  /// What a segment between two nodes of a tile is a part of: an edge of blocks, or just a face.
  std::string text(const Tile& tile, std::int32_t a, std::int32_t b) const
  {
    std::vector<int> edges = {tile.entity};
    if (tile.of == Tile::Of::face)
      edges = side_edges(skeleton_, tile.entity);
    for (const int e : edges)
    {
      const PlacedEdge& edge = skeleton_.edges[e];
      const auto is_on = [&](std::int32_t node)
      { return node == edge.a || node == edge.b || (node >= edge.first && node < edge.first + edge.count); };
      if (is_on(a) && is_on(b))
        return "edge " + edge_text(layout_, edge.a, edge.b);
    }
    return side_text(layout_, side_points(skeleton_, tile.entity));
  }

  Error point_on_face(int point, int face) const
  {
    return mistake(
        layout_.points[point].where,
        fmt::format("the point {} lies on the {} of the block '{}', of which it is no corner; divide the "
                    "block there or move the point",
                    point_text(layout_, point), side_text(layout_, side_points(skeleton_, face)),
                    layout_.blocks[skeleton_.faces[face].blocks[0]].name));
  }

  Error cross_at(const std::string& what, const Block& first, const Tile& face, const Point& x) const
  {
    const Block& second = block_of(face);
    const std::string through = side_text(layout_, side_points(skeleton_, face.entity));
    if (what == through)
      return mistake(first.where, fmt::format("the {} of the block '{}' runs through itself at {}; bend it "
                                              "less or divide it",
                                              what, first.name, place(x)));
    // The later one is more likely to be the mistake.
    return mistake(std::max(&first, &second)->where,
                   fmt::format("the {} of the block '{}' runs through the {} of the block '{}' at {}; move "
                               "their points or change their shapes so that blocks meet at whole sides only",
                               what, first.name, through, second.name, place(x)));
  }

  // ---- Groups of blocks that share sides: does one lie within another one?

  /// The first block of each block's group.
  std::vector<int> groups() const
  {
    std::vector<int> parent(layout_.blocks.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](int b)
    {
      while (parent[b] != b)
        b = parent[b] = parent[parent[b]];
      return b;
    };
    for (int side = 0; side < side_count(skeleton_); ++side)
      if (const std::vector<int>& blocks = side_blocks(skeleton_, side); blocks.size() == 2)
      {
        const auto [first, second] = std::minmax({root(blocks[0]), root(blocks[1])});
        parent[second] = first;
      }
    for (int b = 0; b < static_cast<int>(parent.size()); ++b)
      parent[b] = root(b);
    return parent;
  }

  /// 1 if the nodes of an outer side turn as seen from outside (in the plane: run with the block on their
  /// left), else -1.
  double turn(int side) const
  {
    const int b = side_blocks(skeleton_, side)[0];
    const std::vector<int>& sides = skeleton_.block_sides[b];
    const auto at = std::find(sides.begin(), sides.end(), side) - sides.begin();
    const element::SideShape& of = element::sides(layout_.blocks[b].shape)[at];
    const bool along =
        skeleton_.dim == 3 || skeleton_.edges[side].a == layout_.blocks[b].points[of.corners[0]];
    return along == of.outward ? 1.0 : -1.0;
  }

  /// The part of the angle all round that a tile fills as seen from a point: in the plane of a segment, in
  /// space of its triangles (van Oosterom and Strackee 1983).
  double share_of_view(const Tile& tile, const Point& from) const
  {
    const auto to = [&](int k) { return geometry::subtract(at(tile.node[k]), from); };
    if (tile.count == 2)
    {
      const Point a = to(0);
      const Point b = to(1);
      return std::atan2(a[0] * b[1] - a[1] * b[0], geometry::dot(a, b)) / (2.0 * std::numbers::pi);
    }
    double share = 0.0;
    for (const auto& [i, j, k] : triangles(tile))
    {
      const Point a = to(i), b = to(j), c = to(k);
      const double la = geometry::norm(a), lb = geometry::norm(b), lc = geometry::norm(c);
      const double above = geometry::dot(a, geometry::cross(b, c));
      const double below =
          la * lb * lc + geometry::dot(a, b) * lc + geometry::dot(b, c) * la + geometry::dot(c, a) * lb;
      share += std::atan2(above, below) / (2.0 * std::numbers::pi);
    }
    return share;
  }

  /// Whether a point may be as near to a tile as that is curved.
  bool is_near(const Tile& tile, const Point& x) const
  {
    const double margin = slack_ + 2.0 * tile.curvature;
    if (!box(tile, margin).meets({x, x}))
      return false;
    const std::span<const Corners> flat = triangles(tile);
    return flat.empty() ||
           std::any_of(
               flat.begin(), flat.end(),
               [&](const Corners& c)
               {
                 const Triangle triangle({at(tile.node[c[0]]), at(tile.node[c[1]]), at(tile.node[c[2]])});
                 return std::abs(triangle.height(x)) <= margin;
               });
  }

  /// Whether a point lies within the outer tiles of a group; nothing if it is so near to one of them that the
  /// curvature of this decides.
  std::optional<bool> is_within(const Point& x, const std::vector<int>& outer) const
  {
    double shares = 0.0;
    for (const int t : outer)
    {
      if (is_near(tiles_[t], x))
        return {};
      shares += turn(tiles_[t].entity) * share_of_view(tiles_[t], x);
    }
    return std::abs(shares) > 0.5;
  }

  void check_groups() const
  {
    const std::vector<int> group = groups();
    if (std::count(group.begin(), group.end(), 0) == static_cast<std::ptrdiff_t>(group.size()))
      return;
    const Tile::Of kind = skeleton_.dim == 2 ? Tile::Of::edge : Tile::Of::face;
    std::vector<std::vector<int>> outer(group.size());
    std::vector<Box> around(group.size());
    for (int t = 0; t < static_cast<int>(tiles_.size()); ++t)
      if (tiles_[t].of == kind)
      {
        const int g = group[side_blocks(skeleton_, tiles_[t].entity)[0]];
        around[g] = outer[g].empty() ? boxes_[t] : geometry::joined(around[g], boxes_[t]);
        outer[g].push_back(t);
      }
    for (const auto& [a, b] : geometry::meeting_pairs(around))
      if (!outer[a].empty() && !outer[b].empty())
      {
        check_within(outer[a], outer[b], around[b]);
        check_within(outer[b], outer[a], around[a]);
      }
  }

  /// Looks at one point of a group that is clear of the other one.
  void check_within(const std::vector<int>& inner, const std::vector<int>& outer, const Box& around) const
  {
    for (const int t : inner)
      for (int k = 0; k < tiles_[t].count; ++k)
      {
        const Point x = at(tiles_[t].node[k]);
        const std::optional<bool> within = around.meets({x, x}) ? is_within(x, outer) : false;
        if (!within)
          continue;
        if (!*within)
          return;  // the groups do not cross, so all of it is outside
        throw mistake(block_of(tiles_[t]).where,
                      fmt::format("the block '{}' lies within the block '{}' or its neighbours, at {}; "
                                  "move it, or leave room for it",
                                  block_of(tiles_[t]).name, block_of(tiles_[outer[0]]).name, place(x)));
      }
  }

  const Layout& layout_;
  const Skeleton& skeleton_;
  std::vector<Tile> tiles_;
  std::vector<Box> boxes_;
  double slack_;
};

}  // namespace

void check_overlaps(const Layout& layout, const Skeleton& skeleton)
{
  Checker(layout, skeleton).check();
}

}  // namespace blockfsi::block
