#include "block/check.hpp"

#include "block/message.hpp"
#include "block/topology.hpp"
#include "geometry/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <variant>

namespace blockfsi::block
{

namespace
{

using element::Shape;

void check_numbers(const Layout& layout)
{
  if (layout.dim != 2 && layout.dim != 3)
    throw Error(fmt::format("the layout has {} dimensions; only 2 or 3 are possible", layout.dim));
  if (layout.order < 1 || layout.order > 8)
    throw Error(fmt::format("the order of the mesh is {}; it must be 1 to 8", layout.order));
  if (layout.blocks.empty())
    throw Error("the layout has no blocks; draw a lattice or give single blocks");
}

/// The right number of different, existing points.
void check_points_of(const Layout& layout, const Block& block)
{
  if (element::dimension(block.shape) != layout.dim)
    throw mistake(block.where,
                  fmt::format("the block '{}' is a {}, which a layout in {} dimensions cannot hold",
                              block.name, element::name(block.shape), layout.dim));
  if (static_cast<int>(block.points.size()) != element::corner_count(block.shape))
    throw mistake(block.where,
                  fmt::format("the block '{}' has {} points; a {} has {}", block.name, block.points.size(),
                              element::name(block.shape), element::corner_count(block.shape)));
  for (const int point : block.points)
    if (point < 0 || point >= static_cast<int>(layout.points.size()))
      throw mistake(block.where,
                    fmt::format("the block '{}' names point {}; points are numbered from 0 to {}", block.name,
                                point, layout.points.size() - 1));
  for (auto p = block.points.begin(); p != block.points.end(); ++p)
    if (std::find(block.points.begin(), p, *p) != p)
      throw mistake(block.where,
                    fmt::format("the block '{}' is degenerate: the point {} occurs twice among its "
                                "corners; give it {} different ones or another shape",
                                block.name, point_text(layout, *p), element::corner_count(block.shape)));
}

void check_points_used(const Layout& layout)
{
  std::vector<bool> used(layout.points.size(), false);
  for (const Block& block : layout.blocks)
    for (const int point : block.points)
      used[point] = true;
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused == used.end())
    return;
  const int point = static_cast<int>(unused - used.begin());
  throw mistake(
      layout.points[point].where,
      fmt::format("the point {} is used by no block; use it or remove it", point_text(layout, point)));
}

/// Two points at one place would be a crack in the mesh that nobody sees.
void check_points_apart(const Layout& layout)
{
  const double tolerance = 1e-9 * layout_size(layout);
  std::vector<int> order(layout.points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto x = [&](int p) -> const std::array<double, 3>& { return layout.points[p].x; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return x(a)[0] < x(b)[0]; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && x(order[j])[0] - x(order[i])[0] <= tolerance; ++j)
    {
      const auto [first, second] = std::minmax(order[i], order[j]);
      if (std::hypot(x(first)[0] - x(second)[0], x(first)[1] - x(second)[1], x(first)[2] - x(second)[2]) <=
          tolerance)
        throw mistake(layout.points[second].where,
                      fmt::format("the points {} and {} are at the same place; use one of them in all blocks",
                                  point_text(layout, first), point_text(layout, second)));
    }
}

/// The corners next to a corner, so ordered that the edges to them are right-handed in a sound block; the
/// first two in 2D. A pyramid's apex has four and is left out.
std::vector<std::array<std::int8_t, 3>> neighbours(Shape shape)
{
  switch (shape)
  {
  case Shape::triangle:
    return {{1, 2, -1}, {2, 0, -1}, {0, 1, -1}};
  case Shape::quadrilateral:
    return {{1, 3, -1}, {2, 0, -1}, {3, 1, -1}, {0, 2, -1}};
  case Shape::tetrahedron:
    return {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}};
  case Shape::hexahedron:
    return {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  case Shape::prism:
    return {{1, 2, 3}, {2, 0, 4}, {0, 1, 5}, {5, 4, 0}, {3, 5, 1}, {4, 3, 2}};
  case Shape::pyramid:
    return {{1, 3, 4}, {2, 0, 4}, {3, 1, 4}, {0, 2, 4}};
  default:
    return {};
  }
}

using geometry::Point;

/// Directions of curved edges at their ends, by the point that they leave and the one that they lead to.
using Tangents = std::map<std::pair<int, int>, Point>;

/// Corners between curves are called flat below this sine: tangents are known to about 1e-7.
constexpr double flat_sine = 1e-4;

void check_curve(const Layout& layout, const Edge& edge)
{
  try
  {
    geometry::check(edge.curve, layout.points[edge.a].x, layout.points[edge.b].x);
  }
  catch (const Error& error)
  {
    throw mistake(edge.where, error.within("the edge " + edge_text(layout, edge.a, edge.b)).message());
  }
}

/// Throws Error for a curve that does not fit. Entries for edges that no block has are refused later.
Tangents tangents_of(const Layout& layout)
{
  std::set<std::pair<int, int>> edges;
  for (const Block& block : layout.blocks)
    for (const auto& [a, b] : element::edges(block.shape))
      edges.insert(std::minmax(block.points[a], block.points[b]));
  Tangents result;
  for (const Edge& edge : layout.edges)
  {
    if (std::holds_alternative<geometry::Segment>(edge.curve) || !edges.contains(std::minmax(edge.a, edge.b)))
      continue;
    check_curve(layout, edge);
    const geometry::Path path(edge.curve, layout.points[edge.a].x, layout.points[edge.b].x);
    result[{edge.a, edge.b}] = path.derivative(0.0);
    result[{edge.b, edge.a}] = geometry::scaled(-1.0, path.derivative(1.0));
  }
  return result;
}

/// The direction in which an edge leaves a point, of unit length.
Point direction(const Layout& layout, const Tangents& tangents, int from, int to)
{
  const auto curved = tangents.find({from, to});
  if (curved != tangents.end() && geometry::is_finite(curved->second) && geometry::norm(curved->second) > 0.0)
    return geometry::scaled(1.0 / geometry::norm(curved->second), curved->second);
  const Point chord = geometry::subtract(layout.points[to].x, layout.points[from].x);
  return geometry::scaled(1.0 / geometry::norm(chord), chord);
}

/// Area or volume that the unit vectors along the edges at a corner span: positive in a sound block.
double corner_measure(const Layout& layout, const Tangents& tangents, const Block& block, int corner)
{
  const std::array<std::int8_t, 3> next = neighbours(block.shape)[corner];
  const int at = block.points[corner];
  std::array<Point, 3> e{{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
  bool curved = false;
  for (int d = 0; d < layout.dim; ++d)
  {
    const int to = block.points[next[d]];
    e[d] = direction(layout, tangents, at, to);
    curved = curved || tangents.contains({at, to});
  }
  const double measure = geometry::dot(geometry::cross(e[0], e[1]), e[2]);
  return curved && std::abs(measure) < flat_sine ? 0.0 : measure;
}

/// Corners of the mirrored block in the order that makes a sound one.
std::vector<int> mirrored(Shape shape)
{
  switch (shape)
  {
  case Shape::triangle:
    return {0, 2, 1};
  case Shape::quadrilateral:
    return {0, 3, 2, 1};
  case Shape::tetrahedron:
    return {0, 2, 1, 3};
  case Shape::hexahedron:
    return {4, 5, 6, 7, 0, 1, 2, 3};
  case Shape::prism:
    return {3, 4, 5, 0, 1, 2};
  default:
    return {0, 3, 2, 1, 4};
  }
}

Error inside_out(const Layout& layout, const Block& block)
{
  std::string list;
  for (const int corner : mirrored(block.shape))
    list += (list.empty() ? "" : ", ") + point_text(layout, block.points[corner]);
  return mistake(
      block.where,
      layout.dim == 2
          ? fmt::format("the block '{}' is inside out: its points run clockwise; list them "
                        "counter-clockwise, that is {}",
                        block.name, list)
          : fmt::format("the block '{}' is inside out: its points are those of a mirrored {}; list them "
                        "as {}",
                        block.name, element::name(block.shape), list));
}

/// At all corners the edges must be right-handed, else the transfinite map has a Jacobian <= 0 there.
void check_corners(const Layout& layout, const Tangents& tangents, const Block& block)
{
  const int count = static_cast<int>(neighbours(block.shape).size());
  int wrong_count = 0;
  int wrong_corner = 0;
  for (int c = 0; c < count; ++c)
    if (!(corner_measure(layout, tangents, block, c) > 0.0))
    {
      ++wrong_count;
      wrong_corner = c;
    }
  if (wrong_count == count && corner_measure(layout, tangents, block, 0) < 0.0)
    throw inside_out(layout, block);
  if (wrong_count > 0)
    throw mistake(block.where,
                  fmt::format("the block '{}' is inside out at its corner {}: {}; move or reorder its points",
                              block.name, point_text(layout, block.points[wrong_corner]),
                              layout.dim == 2 ? "the angle there must be between 0 and 180 degrees"
                                              : "the edges there must span a positive volume"));
}

}  // namespace

void check_layout(const Layout& layout)
{
  check_numbers(layout);
  for (const Block& block : layout.blocks)
    check_points_of(layout, block);
  check_points_used(layout);
  check_points_apart(layout);
  const Tangents tangents = tangents_of(layout);
  for (const Block& block : layout.blocks)
    check_corners(layout, tangents, block);
}

}  // namespace blockfsi::block
