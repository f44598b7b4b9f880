#pragma once

#include "block/layout.hpp"

#include <string_view>

namespace blockfsi::block
{

/// The point of a name: the full one ("channel x3 y2") or, where only one point has it, the one without its
/// lattice
/// ("x3 y2"). Throws Error with the nearest name if there is none, with all full names if there are several.
int find_point(const Layout& layout, std::string_view name);

}  // namespace blockfsi::block
