#pragma once

#include "block/plan.hpp"
#include "block/region.hpp"
#include "mesh/mesh.hpp"

#include <cstdint>
#include <vector>

namespace blockfsi::block
{

/// The own cells of one block and the local numbers of its nodes.
struct BlockShare
{
  int block = 0;
  std::int64_t begin = 0;  ///< own cells [begin, end), counted within the block
  std::int64_t end = 0;
  bool whole = false;  ///< all cells of the block are own
  /// Local number of the first inner node; the inner nodes of a whole block follow in their order.
  std::int32_t first_inner = 0;
  /// If not whole: local numbers of the inner nodes `low`, `low` + 1, ..., -1 for those of other processes.
  std::int64_t low = 0;
  std::vector<std::int32_t> inner;
  /// Local numbers of the nodes on the sides, -1 for those of other processes.
  std::vector<std::vector<std::int32_t>> sides;

  /// Local numbers of the nodes of a row of the lattice.
  void read_row(const BlockLattice& lattice, int j, int k, std::int32_t* numbers) const;
  /// Runs of own inner nodes.
  std::vector<BlockPlan::Row> rows(const BlockLattice& lattice) const;

private:
  std::int32_t local_inner(std::int64_t index) const;
};

/// Local numbers of the nodes of the skeleton.
struct LocalSkeleton
{
  std::vector<std::int32_t> node;  ///< -1 for those of other processes; shape (skeleton.count)
  std::int64_t count = 0;          ///< of own nodes of the skeleton
  std::int64_t node_count = 0;     ///< of all own nodes
};

/// The blocks of which a process has cells, in the order of the cells.
std::vector<BlockShare> own_shares(const RegionCells& cells, Part part);

/// Adds the number of cells of each shape among the cells [begin, end) of a block.
void add_counts(const BlockCells& cells, std::int64_t begin, std::int64_t end,
                RegionCells::ShapeCounts& counts);

/// Numbers the nodes of the own cells ascending by their numbers in the lattice of all blocks.
LocalSkeleton number_nodes(const Skeleton& skeleton, const RegionCells& cells,
                           std::vector<BlockShare>& shares);

/// Enters the numbers of the own nodes in the lattice of all blocks, and their owners if there are several
/// processes.
void name_nodes(const Skeleton& skeleton, const RegionCells& cells, const std::vector<BlockShare>& shares,
                const LocalSkeleton& local, Part part, mesh::Mesh& mesh);

}  // namespace blockfsi::block
