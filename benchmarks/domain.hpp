#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"
#include "block/place.hpp"
#include "core/expression.hpp"
#include "element/shape.hpp"
#include "geometry/curve.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace benchmarks
{

/// A square of side 2 with a hole of radius 0.5 in its middle, as an O-grid of four blocks of cells x cells
/// cells each, graded from the hole outwards. Boundaries "hole", "inlet" (left side) and "outer" (the other
/// three). There are about 4 (cells order)^2 nodes.
inline blockfsi::block::Layout square_with_hole(int order, int cells,
                                                const blockfsi::block::Grading& outwards)
{
  using namespace blockfsi;
  block::Layout layout;
  layout.order = order;
  layout.default_divisions = cells;
  const double c = 0.5 / std::sqrt(2.0);
  const std::array<std::array<double, 2>, 4> directions = {
      {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};
  for (int i = 0; i < 4; ++i)
    layout.points.push_back(
        {"hole " + std::to_string(i), {c * directions[i][0], c * directions[i][1], 0.0}, {}});
  for (int i = 0; i < 4; ++i)
    layout.points.push_back({"outer " + std::to_string(i), {directions[i][0], directions[i][1], 0.0}, {}});
  for (int i = 0; i < 4; ++i)
  {
    const int next = (i + 1) % 4;
    layout.blocks.push_back({"block " + std::to_string(i), "fluid", {i, 4 + i, 4 + next, next}, {}});
    layout.edges.push_back({i, next, geometry::Arc{}, {}, {}, {}});
    layout.edges.push_back({i, 4 + i, geometry::Segment{}, outwards, {}, {}});
  }
  const auto boundary = [&layout](const char* name, const char* condition) {
    layout.boundaries.push_back({name, block::ByCondition{Condition(condition, {})}, {}});
  };
  boundary("hole", "x^2 + y^2 < 0.3");
  boundary("inlet", "x = -1");
  boundary("outer", "x = 1 or y = -1 or y = 1");
  return layout;
}

/// The square whose cells at the hole are 20 times thinner than if all were equal.
inline blockfsi::block::Layout square_with_hole(int order, int cells)
{
  return square_with_hole(order, cells, blockfsi::block::FirstCell{0.05 * (std::sqrt(2.0) - 0.5) / cells});
}

/// Geometric grading whose last cell is `ratio` times as long as the first.
inline blockfsi::block::Grading size_ratio(int cells, double ratio)
{
  return blockfsi::block::Geometric{cells > 1 ? std::pow(ratio, 1.0 / (cells - 1)) : 1.0};
}

/// A quarter of a tube of length 1 between radii 0.5 and 1, one block of cells x cells x cells hexahedra,
/// graded from the inside outwards. Boundary "wall".
inline blockfsi::block::Layout quarter_tube(int order, int cells, const blockfsi::block::Grading& outwards)
{
  using namespace blockfsi;
  block::Layout layout;
  layout.dim = 3;
  layout.order = order;
  layout.default_divisions = cells;
  layout.blocks.push_back({"quarter", "fluid", {0, 1, 2, 3, 4, 5, 6, 7}, {}, element::Shape::hexahedron});
  for (int end = 0; end < 2; ++end)
  {
    const double z = end;
    const int first = 4 * end;
    const std::array<std::array<double, 3>, 4> corners = {
        {{0.5, 0.0, z}, {1.0, 0.0, z}, {0.0, 1.0, z}, {0.0, 0.5, z}}};
    for (int i = 0; i < 4; ++i)
      layout.points.push_back({"point " + std::to_string(first + i), corners[i], {}});
    layout.edges.push_back({first, first + 3, geometry::Arc{{0.0, 0.0, z}}, {}, {}, {}});
    layout.edges.push_back({first + 1, first + 2, geometry::Arc{{0.0, 0.0, z}}, {}, {}, {}});
    layout.edges.push_back({first, first + 1, geometry::Segment{}, outwards, {}, {}});
    layout.edges.push_back({first + 3, first + 2, geometry::Segment{}, outwards, {}, {}});
  }
  layout.boundaries.push_back({"wall", block::ByCondition{Condition("x > -1", {})}, {}});
  return layout;
}

/// The reference cell of a shape as one block, not graded. Boundary "wall".
inline blockfsi::block::Layout one_block(blockfsi::element::Shape shape, int order, int cells)
{
  using namespace blockfsi;
  block::Layout layout;
  layout.dim = element::dimension(shape);
  layout.order = order;
  layout.default_divisions = cells;
  block::Block block{"block", "fluid", {}, {}, shape};
  for (const std::array<double, 3>& corner : element::corners(shape))
  {
    block.points.push_back(static_cast<int>(layout.points.size()));
    layout.points.push_back({"point " + std::to_string(layout.points.size()), corner, {}});
  }
  layout.blocks.push_back(block);
  layout.boundaries.push_back({"wall", block::ByCondition{Condition("x > -9", {})}, {}});
  return layout;
}

/// A mesh of a layout, with the coordinates of its nodes.
struct Domain
{
  explicit Domain(const blockfsi::block::Layout& layout)
      : skeleton(blockfsi::block::make_skeleton(layout)),
        connected(blockfsi::block::connect(layout, skeleton, "", {})),
        x(layout.dim * connected.mesh.node_count())
  {
    blockfsi::block::place(connected.plan, skeleton.x, x);
  }
  Domain(int order, int cells) : Domain(square_with_hole(order, cells)) {}

  const blockfsi::mesh::Mesh& mesh() const { return connected.mesh; }
  std::size_t node_count() const { return connected.mesh.node_count(); }

  blockfsi::block::Skeleton skeleton;
  blockfsi::block::Connected connected;
  std::vector<double> x;  ///< [m], shape (node_count, dim)
};

}  // namespace benchmarks
