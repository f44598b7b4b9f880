#include "block/check.hpp"

#include "block/message.hpp"
#include "block/topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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

/// Area or volume that the edges at a corner span: positive in a sound block.
double corner_measure(const Layout& layout, const Block& block, int corner)
{
  const std::array<std::int8_t, 3> next = neighbours(block.shape)[corner];
  const auto& at = layout.points[block.points[corner]].x;
  std::array<std::array<double, 3>, 3> e{{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
  for (int d = 0; d < layout.dim; ++d)
    for (int c = 0; c < 3; ++c)
      e[d][c] = layout.points[block.points[next[d]]].x[c] - at[c];
  if (layout.dim == 2)
    return e[0][0] * e[1][1] - e[0][1] * e[1][0];
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
         e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
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
void check_corners(const Layout& layout, const Block& block)
{
  const int count = static_cast<int>(neighbours(block.shape).size());
  int wrong_count = 0;
  int wrong_corner = 0;
  for (int c = 0; c < count; ++c)
    if (!(corner_measure(layout, block, c) > 0.0))
    {
      ++wrong_count;
      wrong_corner = c;
    }
  if (wrong_count == count && corner_measure(layout, block, 0) < 0.0)
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
  for (const Block& block : layout.blocks)
    check_corners(layout, block);
}

}  // namespace blockfsi::block
