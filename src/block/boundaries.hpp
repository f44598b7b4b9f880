#pragma once

#include "block/layout.hpp"
#include "block/topology.hpp"

namespace blockfsi::block
{

/// Name that the mesh gives to the edges between two regions; no boundary may take it.
inline constexpr const char* interface_name = "interface";

/// Sets the boundary of each edge (whose divisions must be known: conditions are tested at all initial nodes,
/// with a tolerance of 1e-8 of the layout's size). A boundary may lie on outer edges and, if it names them
/// one by one, on edges between two regions. Throws Error for a boundary without edges, one within a region,
/// an edge in two boundaries and an outer edge in none.
void assign_boundaries(const Layout& layout, Topology& topology);

}  // namespace blockfsi::block
