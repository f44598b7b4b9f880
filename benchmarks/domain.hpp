#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"
#include "block/place.hpp"
#include "core/expression.hpp"
#include "geometry/curve.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace benchmarks
{

/// What all measurements are made on: a square of side 2 with a hole of radius 0.5 in its middle, as an
/// O-grid of four blocks of cells x cells cells each, graded so that those at the hole are 20 times thinner
/// than if all were equal. Boundaries "hole", "inlet" (left side) and "outer" (the other three). There are
/// about 4 (cells order)^2 nodes.
inline blockfsi::block::Layout square_with_hole(int order, int cells)
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
    layout.edges.push_back(
        {i, 4 + i, geometry::Segment{}, block::FirstCell{0.05 * (std::sqrt(2.0) - 0.5) / cells}, {}, {}});
  }
  const auto boundary = [&layout](const char* name, const char* condition) {
    layout.boundaries.push_back({name, block::ByCondition{Condition(condition, {})}, {}});
  };
  boundary("hole", "x^2 + y^2 < 0.3");
  boundary("inlet", "x = -1");
  boundary("outer", "x = 1 or y = -1 or y = 1");
  return layout;
}

/// The mesh of it, with the coordinates of its nodes.
struct Domain
{
  explicit Domain(const blockfsi::block::Layout& layout)
      : skeleton(blockfsi::block::make_skeleton(layout)),
        connected(blockfsi::block::connect(layout, skeleton, "fluid", {})), x(2 * connected.mesh.node_count())
  {
    blockfsi::block::place(connected.plan, skeleton.x, x);
  }
  Domain(int order, int cells) : Domain(square_with_hole(order, cells)) {}

  const blockfsi::mesh::Mesh& mesh() const { return connected.mesh; }
  std::size_t node_count() const { return connected.mesh.node_count(); }

  blockfsi::block::Skeleton skeleton;
  blockfsi::block::Connected connected;
  std::vector<double> x;  ///< [m], shape (node_count, 2)
};

}  // namespace benchmarks
