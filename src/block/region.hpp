#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"
#include "block/numbering.hpp"
#include "core/part.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace blockfsi::block
{

/// The cells of one region in their numbering and their shares: all that follows by arithmetic, of the size
/// of the skeleton's edges and points.
class RegionCells
{
public:
  /// Throws Error if no block has this region; an empty region means all blocks.
  RegionCells(const Layout& layout, const Skeleton& skeleton, std::string_view region);

  /// Blocks of the region in the order of their cells.
  const std::vector<int>& blocks() const { return blocks_; }
  /// Lattice of a block of the layout.
  const BlockLattice& lattice(int block) const { return lattices_[block]; }
  /// Number of the first cell of a block, or -1 for a block of another region.
  std::int64_t first_cell(int block) const { return first_cell_[block]; }
  std::int64_t cell_count() const { return cell_count_; }
  bool contains(int block) const { return first_cell_[block] >= 0; }

  /// First cell of the share of a process; rank == size gives the number of cells.
  std::int64_t share_begin(int rank, int size) const;
  /// Process whose share holds a cell.
  int rank_of_cell(std::int64_t cell, int size) const;
  /// Lowest cell of the region that has a node of the lattice.
  std::int64_t lowest_cell(std::int64_t node) const;
  /// Block of the layout that a node within a block belongs to.
  int block_of(std::int64_t node) const;
  /// Nodes of the whole mesh of the region.
  std::int64_t node_count() const;

private:
  void find_lowest_at_points();
  std::int64_t lowest_on_edge(std::int64_t node) const;

  const Skeleton& skeleton_;
  std::vector<int> blocks_;
  std::vector<BlockLattice> lattices_;
  std::vector<std::int64_t> first_cell_;
  std::vector<std::int64_t> lowest_at_point_;  ///< cell_count_: no cell of the region is there
  std::int64_t cell_count_ = 0;
};

}  // namespace blockfsi::block
