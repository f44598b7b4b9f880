#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"

#include <array>
#include <cstdint>

namespace blockfsi::block
{

/// The lattice of nodes of one block, numbered by arithmetic: node (i, j), 0 <= i <= columns, 0 <= j <= rows,
/// with i along u (side 0) and j along v (side 3).
struct BlockLattice
{
  int order = 1;
  int columns = 0;                           ///< lattice steps along u: cells times order
  int rows = 0;                              ///< lattice steps along v
  std::array<int, 4> points{};               ///< corners, counter-clockwise
  std::array<const PlacedEdge*, 4> edges{};  ///< edge on each side; lives as long as the skeleton
  std::array<bool, 4> forward{};             ///< whether the edge runs as the side does
  std::int64_t first_inner = 0;              ///< number of node (1, 1)

  int cells_along_u() const { return columns / order; }
  int cells_along_v() const { return rows / order; }
  std::int64_t cell_count() const { return static_cast<std::int64_t>(cells_along_u()) * cells_along_v(); }

  /// Number of node k of a side, 0 <= k <= columns or rows, counted along u or v.
  std::int64_t side_number(int side, int k) const;
  /// Number of node (i, j).
  std::int64_t number(int i, int j) const;
  /// Node (i, j) of node k of a side.
  std::array<int, 2> on_side(int side, int k) const;
  /// Number within the block, u fastest, of the lowest cell that has node (i, j).
  std::int64_t lowest_cell(int i, int j) const;
};

BlockLattice block_lattice(const Layout& layout, const Skeleton& skeleton, int block);

}  // namespace blockfsi::block
