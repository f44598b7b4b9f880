#pragma once

#include "block/connect.hpp"

#include <span>
#include <vector>

namespace blockfsi::block
{

/// Coordinates of all local nodes from those of the skeleton, by the transfinite map of Gordon & Hall 1973
/// with graded coordinates: linear in the skeleton. Allocates nothing.
///   skeleton_x [m], shape (skeleton.count, dim);  x [m], shape (node_count, dim), written.
void place(const Plan& plan, std::span<const double> skeleton_x, std::span<double> x);

/// Coordinates of all local nodes of the first mesh [m], shape (node_count, dim).
std::vector<double> initial_nodes(const Connected& connected, const Skeleton& skeleton);

}  // namespace blockfsi::block
