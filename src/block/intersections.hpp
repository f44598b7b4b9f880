#pragma once

#include "block/layout.hpp"
#include "block/topology.hpp"

namespace blockfsi::block
{

/// Throws Error, naming both edges and the place, if two edges of a layout in the plane cross or one crosses
/// itself, or if a point lies on an edge that does not end there. Curves are looked at in pieces, which are
/// halved as long as their distances from their chords, by samples, leave it open whether they cross: those
/// that touch do not. A curve that turns back within an eighth of its length may cross itself unseen.
void check_intersections(const Layout& layout, const Topology& topology);

}  // namespace blockfsi::block
