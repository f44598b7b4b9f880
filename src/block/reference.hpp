#pragma once

#include "block/connect.hpp"
#include "block/plan.hpp"

#include <vector>

namespace blockfsi::block
{

/// Graded parameters of the nodes on each edge of a shape, from 0 to 1, in the direction and order of
/// element::edges; shapes (steps + 1).
using EdgeParameters = std::vector<std::vector<double>>;

/// Parameters of the nodes of an edge from its end `first` on.
std::vector<double> directed_parameters(const Skeleton& skeleton, const PlacedEdge& edge, int first);

/// Sets the graded coordinates of the nodes of a plan: the fixed point of the blend of the parameters on the
/// edges (formulation.md 3), so that nothing bends that has straight edges. Sets `resampling`, too, where the
/// shape and the order need it.
void set_reference(const EdgeParameters& edges, int order, int diagonal, BlockPlan& plan);

}  // namespace blockfsi::block
