#pragma once

#include "block/layout.hpp"
#include "block/topology.hpp"

namespace blockfsi::block
{

/// Throws Error, naming both edges and the place, if two edges of a layout in the plane cross, or if a point
/// lies on a straight edge that does not end there. Curved edges are looked at in 32 straight pieces, and
/// crossings of these count if the curves themselves meet there.
void check_intersections(const Layout& layout, const Topology& topology);

}  // namespace blockfsi::block
