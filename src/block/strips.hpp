#pragma once

#include "block/layout.hpp"
#include "block/topology.hpp"

#include <vector>

namespace blockfsi::block
{

/// A class of parallel edges: opposite ones of quadrilaterals (also of a pyramid's base), the parallel ones
/// of hexahedra and prisms, across any number of blocks. They share a distribution of cells where nothing
/// else is said. Edges of triangles and tetrahedra are parallel to no other in their block.
struct Strip
{
  std::vector<int> edges;
  std::vector<bool> reversed;  ///< whether the edge runs against the first one; shape of edges
};

/// Sorts all edges into strips.
std::vector<Strip> make_strips(const Layout& layout, const Topology& topology);

/// Number of cells along each edge. Parallel edges have the same number, and so have all edges of a triangle,
/// of a tetrahedron, of a pyramid and of both triangles of a prism. Throws Error if edges that need the same
/// number ask for different ones (naming two such edges and the blocks between), if a number is below 1, or
/// if nobody gives one and there is no default.
std::vector<int> divide(const Layout& layout, const Topology& topology);

}  // namespace blockfsi::block
