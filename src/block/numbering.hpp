#pragma once

#include "block/connect.hpp"
#include "block/grid.hpp"
#include "block/layout.hpp"
#include "geometry/point.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// Skeleton numbers of the nodes of an edge from its end a to its end b, shape (count + 2).
std::vector<std::int32_t> edge_numbers(const PlacedEdge& edge);
/// Skeleton numbers of the nodes of a face in the order of its own lattice.
std::vector<std::int32_t> face_numbers(const Skeleton& skeleton, const PlacedFace& face);
/// The same for a side: an edge in 2D, a face in 3D.
std::vector<std::int32_t> side_numbers(const Skeleton& skeleton, int side);

/// Position of a node of the skeleton [m]; z = 0 in two dimensions.
geometry::Point node_position(const Skeleton& skeleton, std::int64_t node);

/// The lattice of nodes of a face.
Grid face_grid(const PlacedFace& face, int order);
/// The lattice of nodes of a block whose edges have these numbers of cells (order 1: of its cells' corners).
Grid block_grid(const Block& block, const std::vector<int>& edges, std::span<const PlacedEdge> all,
                int order);

/// Where points of a side lie in the lattice of the block: the point (s, t) of the side is origin + s first +
/// t second.
struct SideFrame
{
  element::LatticePoint origin{};
  element::LatticePoint first{};
  element::LatticePoint second{};

  element::LatticePoint at(int s, int t) const
  {
    return {origin[0] + s * first[0] + t * second[0], origin[1] + s * first[1] + t * second[1],
            origin[2] + s * first[2] + t * second[2]};
  }
};
/// Frame in a lattice of a side over three of its corners: the first, those at its two ends.
SideFrame frame(const Grid& grid, int corner, int first, int second);
SideFrame side_frame(const Grid& grid, int side);

/// The lattice of nodes of one block, numbered by arithmetic.
struct BlockLattice
{
  int order = 1;
  Grid nodes;
  Grid cells;                                    ///< corners of cells
  Grid inner;                                    ///< interior(nodes)
  std::vector<std::int32_t> corners;             ///< skeleton numbers (points), shape (corner_count)
  std::vector<Grid> side_grids;                  ///< of each side
  std::vector<std::vector<std::int32_t>> sides;  ///< skeleton numbers of the nodes of each side in its order
  std::int64_t first_inner = 0;  ///< number of the first node on no side; they follow in order

  /// Side and position on it of a node, or side -1 for an inner node.
  struct OnSide
  {
    int side = -1;
    std::int64_t position = 0;
  };
  OnSide find(const element::LatticePoint& node) const;
  /// Number of a node.
  std::int64_t number(const element::LatticePoint& node) const;
  /// Position of an inner node among the inner nodes.
  std::int64_t inner_index(const element::LatticePoint& node) const;
};

BlockLattice block_lattice(const Layout& layout, const Skeleton& skeleton, int block);

}  // namespace blockfsi::block
