#pragma once

#include "block/connect.hpp"
#include "block/move.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::motion
{

/// The fluid mesh made anew from the blocks and the moved interface: a linear map of the interface, without
/// memory and without equations to solve.
class Regenerate
{
public:
  /// `interface`: skeleton numbers of the nodes that the solid moves, ascending; may be empty.
  /// The plan must outlive this object.
  Regenerate(const block::Skeleton& skeleton, const block::Plan& plan,
             const std::vector<std::int64_t>& interface, const std::vector<block::Follow>& rules);

  /// Coordinates of all local nodes for a displacement of the interface. Allocates nothing.
  ///   displacement [m], shape (interface count, 2);  x [m], shape (node_count, 2), written.
  void follow(std::span<const double> displacement, std::span<double> x);

private:
  block::SkeletonMotion motion_;
  const block::Plan* plan_;
  std::vector<double> skeleton_x_;
};

}  // namespace blockfsi::motion
