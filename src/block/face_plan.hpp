#pragma once

#include "block/connect.hpp"
#include "block/plan.hpp"
#include "block/reference.hpp"

namespace blockfsi::block
{

/// Graded parameters of the nodes of a face's edges, in their directions in the face.
EdgeParameters edge_parameters(const Skeleton& skeleton, const PlacedFace& face);

/// How the inner nodes of a face sit between its edges: with skeleton numbers for all nodes, so that `blend`
/// places them among those of the skeleton, or moves them where it is given displacements.
BlockPlan face_plan(const Skeleton& skeleton, const PlacedFace& face);

}  // namespace blockfsi::block
