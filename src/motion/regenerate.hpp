#pragma once

#include "block/connect.hpp"
#include "block/move.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::motion
{

/// The fluid mesh made anew from the blocks and the moved interface. With a constant rule for the corners it
/// is a linear map of the interface, without memory and without equations to solve; with the nonlinear rule a
/// few equations for the corners decide, and what it remembers only shortens their solution.
class Regenerate
{
public:
  /// `interface`: skeleton numbers of the nodes that the solid moves, ascending; may be empty.
  /// The plan must outlive this object.
  Regenerate(const block::Skeleton& skeleton, const block::Plan& plan,
             std::span<const std::int64_t> interface, block::CornerMotion corners);

  /// Coordinates of all local nodes for a displacement of the interface. Allocates nothing with a constant
  /// rule.
  ///   displacement [m], shape (interface count, 2);  x [m], shape (node_count, 2), written.
  block::CornerReport follow(std::span<const double> displacement, std::span<double> x);

  /// What the next mesh may depend on besides the interface, to its tolerance; empty with a constant rule.
  std::vector<double> memory() const { return motion_.corners().memory(); }
  void recall(std::span<const double> memory) { motion_.corners().recall(memory); }

private:
  block::SkeletonMotion motion_;
  const block::Plan* plan_;
  std::vector<double> skeleton_x_;
};

}  // namespace blockfsi::motion
