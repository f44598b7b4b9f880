#pragma once

#include "block/plan.hpp"

#include <vector>

namespace blockfsi::block
{

/// `set_reference` for triangles, tetrahedra, prisms and pyramids. Corners of cells sit at the fixed point of
/// the blend, nodes of a cell are affine between its corners, so that straight cells stay straight.
void set_triangular(const std::vector<std::vector<double>>& edges, int order, int diagonal, BlockPlan& plan);

}  // namespace blockfsi::block
