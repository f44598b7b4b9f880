#pragma once

#include "block/connect.hpp"
#include "block/corner_motion.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// How the skeleton follows the interface: points by the rule of the corners, edges by their ends.
class SkeletonMotion
{
public:
  /// `interface` lists skeleton numbers of the moving nodes, ascending; the corners are those of
  /// corner_motion for the same interface.
  SkeletonMotion(const Skeleton& skeleton, std::span<const std::int64_t> interface, CornerMotion corners);

  /// Skeleton coordinates for a displacement of the interface. Edges between moved points that are not on the
  /// interface follow linearly in their graded parameter: x = X + (1 - w) U_a + w U_b. With a constant rule
  /// linear in the displacement, and allocates nothing.
  ///   displacement [m], shape (interface count, dim);  skeleton_x [m], shape (skeleton.count, dim), written.
  CornerReport move(std::span<const double> displacement, std::span<double> skeleton_x);

  CornerMotion& corners() { return corners_; }
  const CornerMotion& corners() const { return corners_; }

private:
  /// An inner node of an edge.
  struct Inner
  {
    std::int32_t a;
    std::int32_t b;
    double parameter;
    std::int32_t interface_index;  ///< -1: not on the interface
  };
  int dim_;
  std::vector<double> x_;
  CornerMotion corners_;
  std::vector<double> U_;     ///< shape (point count, dim)
  std::vector<Inner> inner_;  ///< shape (skeleton count - point count)
};

}  // namespace blockfsi::block
