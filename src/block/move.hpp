#pragma once

#include "block/connect.hpp"
#include "block/corner_motion.hpp"
#include "block/plan.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// How the skeleton follows the interface: points by the rule of the corners, edges by their ends, faces in
/// space by their edges.
class SkeletonMotion
{
public:
  /// `interface` lists skeleton numbers of the moving nodes, ascending; the corners are those of
  /// corner_motion for the same interface.
  SkeletonMotion(const Skeleton& skeleton, std::span<const std::int64_t> interface, CornerMotion corners);

  /// Skeleton coordinates for a displacement of the interface. Edges between moved points that are not on the
  /// interface follow linearly in their graded parameter: x = X + (1 - w) U_a + w U_b; such faces by the
  /// transfinite map of the displacements of their edges. With a constant rule linear in the displacement,
  /// and allocates nothing.
  ///   displacement [m], shape (interface count, dim);  skeleton_x [m], shape (skeleton.count, dim), written.
  CornerReport move(std::span<const double> displacement, std::span<double> skeleton_x);

  CornerMotion& corners() { return corners_; }
  const CornerMotion& corners() const { return corners_; }

private:
  /// An inner node of an edge that is not on the interface.
  struct Inner
  {
    std::int32_t a;
    std::int32_t b;
    std::int32_t node;
    double parameter;
  };
  int dim_;
  std::vector<double> x_;
  CornerMotion corners_;
  std::vector<std::int64_t> interface_;
  std::size_t point_values_;
  std::vector<Inner> inner_;
  std::vector<BlockPlan> faces_;  ///< those that are not on the interface
  std::vector<double> work_;
};

}  // namespace blockfsi::block
