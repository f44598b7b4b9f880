#pragma once

#include "block/layout.hpp"

#include <string_view>

namespace blockfsi::block
{

/// The same blocks with cells of another order and with `factor` times as many cells along the edges of one
/// region and all edges parallel to them, rounded to whole numbers of at least one. Cells become larger or
/// smaller in proportion: gradings keep their shape, only those towards boundaries and regions keep a smaller
/// first cell. Points, edges and sides of both skeletons have the same numbers, and the same parameter on an
/// edge is the same place. Throws Error where the cells of such an edge are listed one by one and the factor
/// is not 1.
Layout resized(const Layout& layout, std::string_view region, int order, double factor);

}  // namespace blockfsi::block
