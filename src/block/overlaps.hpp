#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"

namespace blockfsi::block
{

/// Throws Error, naming edges, faces and blocks and the place, if blocks lie on each other although each of
/// them is sound:
///   - in space, if the outer sides of blocks run through each other or through themselves, if an edge runs
///     through an outer face, or if a point lies on an outer face of which it is no corner;
///   - if a block lies within blocks with which it shares no side.
/// Blocks that are sound and share sides cover no place twice unless their outer sides cross, or unless one
/// group of blocks lies within another one: so only these are looked at. Sides in the plane are left to
/// check_intersections.
///
/// The nodes of the skeleton stand for sides, 16 pieces a direction at most: flat pieces between them cross
/// if the end of one is on the other side of the other by more than both are curved. So sides that touch, and
/// thin gaps between curved sides, are no crossings; but what reaches through a side by less than the
/// curvature within a piece is not found.
void check_overlaps(const Layout& layout, const Skeleton& skeleton);

}  // namespace blockfsi::block
