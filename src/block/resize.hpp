#pragma once

#include "block/layout.hpp"

namespace blockfsi::block
{

/// The same blocks with cells of another order and with `factor` times as many cells along each edge, rounded
/// to a whole number of at least one; gradings keep their laws and the sizes that they ask for. The points,
/// edges and sides of both skeletons have the same numbers, and the same parameter on an edge is the same
/// place. Throws Error where the cells of an edge are listed one by one and the factor is not 1.
Layout resized(const Layout& layout, int order, double factor);

}  // namespace blockfsi::block
