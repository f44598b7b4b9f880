#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"

namespace blockfsi::block
{

/// Name that the mesh gives to the sides between two regions; no boundary may take it.
inline constexpr const char* interface_name = "interface";

/// Sets the boundary of each side of blocks (edges in 2D, faces in 3D, whose edges get the lowest of their
/// faces'). Conditions are tested at all nodes that the skeleton has now, with a tolerance of 1e-8 of the
/// layout's size. A boundary may lie on outer sides and, if it names them one by one, on sides between two
/// regions. Throws Error for a boundary without sides, one within a region, a side in two boundaries and an
/// outer side in none.
void assign_boundaries(const Layout& layout, Skeleton& skeleton);

}  // namespace blockfsi::block
