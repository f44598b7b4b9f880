#pragma once

#include "block/cells.hpp"
#include "block/connect.hpp"
#include "block/layout.hpp"
#include "block/numbering.hpp"
#include "core/part.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace blockfsi::block
{

/// The cells of one region in their order and their shares: all that follows by arithmetic, of the size of
/// the skeleton. The cells of a block follow each other in the order of `BlockCells`, so that a share is
/// compact; the numbers of the whole mesh put cells of one shape together (`first_of_shape`).
class RegionCells
{
public:
  /// Number of cells of each shape.
  using ShapeCounts = std::array<std::int64_t, element::shape_count>;

  /// Throws Error if no block has this region; an empty region means all blocks.
  RegionCells(const Layout& layout, const Skeleton& skeleton, std::string_view region);

  /// Blocks of the region in the order of their cells.
  const std::vector<int>& blocks() const { return blocks_; }
  /// Whether it holds all blocks of the layout.
  bool is_whole() const { return blocks_.size() == first_cell_.size(); }
  /// Lattice of a block of the region.
  const BlockLattice& lattice(int block) const { return lattices_[block]; }
  /// Cells of a block of the region.
  const BlockCells& cells(int block) const { return cells_[block]; }
  /// How the octahedra of a tetrahedron are split (BlockCells).
  int diagonal(int block) const { return diagonals_[block]; }
  /// The first cell of a block, or -1 for a block of another region.
  std::int64_t first_cell(int block) const { return first_cell_[block]; }
  /// For each shape the number in the whole mesh of the first cell of this shape in a block.
  const ShapeCounts& first_of_shape(int block) const { return first_of_shape_[block]; }
  std::int64_t cell_count() const { return cell_count_; }
  bool contains(int block) const { return first_cell_[block] >= 0; }

  /// First cell of the share of a process; rank == size gives the number of cells.
  std::int64_t share_begin(int rank, int size) const;
  /// Process whose share holds a cell.
  int rank_of_cell(std::int64_t cell, int size) const;
  /// For each node of the skeleton the lowest cell of the region that has it, or cell_count() if none has;
  /// shape (skeleton.count).
  std::vector<std::int64_t> lowest_cells() const;
  /// Nodes of the whole mesh of the region.
  std::int64_t node_count() const;

private:
  void count_shapes();

  const Skeleton& skeleton_;
  std::vector<int> blocks_;
  std::vector<BlockLattice> lattices_;
  std::vector<BlockCells> cells_;
  std::vector<int> diagonals_;
  std::vector<std::int64_t> first_cell_;
  std::vector<ShapeCounts> first_of_shape_;
  std::int64_t cell_count_ = 0;
};

}  // namespace blockfsi::block
