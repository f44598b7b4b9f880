#pragma once

#include "block/connect.hpp"
#include "block/plan.hpp"

namespace blockfsi::block
{

/// How the inner nodes of a face sit between its edges: with skeleton numbers for all nodes, so that `blend`
/// places them among those of the skeleton, or moves them where it is given displacements.
BlockPlan face_plan(const Skeleton& skeleton, const PlacedFace& face);

}  // namespace blockfsi::block
