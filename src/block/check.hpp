#pragma once

#include "block/layout.hpp"

namespace blockfsi::block
{

/// Whether points and blocks make sense by themselves. Throws Error for impossible dimensions and orders,
/// blocks with wrong or repeated points, a point used by no block, two points at one place, curves that do
/// not fit, and blocks that are inside out or degenerate at a corner, which the tangents of curved edges
/// decide.
void check_layout(const Layout& layout);

}  // namespace blockfsi::block
