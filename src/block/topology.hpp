#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"

#include <array>
#include <vector>

namespace blockfsi::block
{

/// Who touches whom in a layout, before anything is divided.
struct Topology
{
  /// Ends and blocks of each edge; the direction is the user's where he speaks of the edge, else that of the
  /// side of its first block.
  std::vector<PlacedEdge> edges;
  std::vector<std::array<int, 4>> block_edges;  ///< edge on each side, shape (block_count, 4)
  std::vector<int> info;  ///< entry of Layout::edges that speaks of the edge, -1: none; shape (edge_count)
};

/// First and last point of a side of a block in the direction of u or v.
std::array<int, 2> side_ends(const Block& block, int side);

/// The edge between two points in either direction, or -1.
int find_edge(const Topology& topology, int a, int b);

/// Finds the edges of all blocks and what the user says of them. Throws Error for an order outside 1..8, a
/// point used by no block, a block turned inside out or with a corner of 180 degrees and more, an edge of
/// more than two blocks, blocks on top of each other, two entries for one edge, an entry that is no edge of a
/// block, a curve that does not fit.
Topology make_topology(const Layout& layout);

/// The point of an edge at parameter t.
geometry::Point edge_point(const Layout& layout, const Topology& topology, int edge, double t);

/// Length of an edge [m].
double edge_length(const Layout& layout, const Topology& topology, int edge);

}  // namespace blockfsi::block
