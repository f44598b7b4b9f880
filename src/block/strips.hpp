#pragma once

#include "block/layout.hpp"
#include "block/topology.hpp"

#include <vector>

namespace blockfsi::block
{

/// A class of opposite edges: a row of blocks crossed from edge to edge. edges[k] and edges[k + 1] are
/// opposite sides of blocks[k]; in a closed strip the last block leads back to the first edge. All edges of a
/// strip have the same number of cells.
struct Strip
{
  std::vector<int> edges;
  std::vector<bool> reversed;  ///< whether the edge runs against the first one; shape of edges
  std::vector<int> blocks;
};

/// Sorts all edges into strips.
std::vector<Strip> make_strips(const Layout& layout, const Topology& topology);

/// Number of cells of each strip. Throws Error if two edges of a strip ask for different numbers (naming both
/// and the blocks between), if a number is below 1, or if nobody gives one and there is no default.
std::vector<int> strip_divisions(const Layout& layout, const Topology& topology,
                                 const std::vector<Strip>& strips);

}  // namespace blockfsi::block
