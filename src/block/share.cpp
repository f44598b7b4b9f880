#include "block/share.hpp"

#include <algorithm>

namespace blockfsi::block
{

namespace
{

using element::LatticePoint;

/// Calls visit(kind, box) for the cells [begin, end) of a block.
template <typename Visit>
void for_each_cell(const BlockCells& cells, std::int64_t begin, std::int64_t end, Visit visit)
{
  for (int k = 0; k < cells.level_count(); ++k)
    for (int j = 0; j < cells.row_count(k); ++j)
    {
      std::int64_t cell = cells.row_begin(j, k);
      if (cells.row_end(j, k) <= begin || cell >= end)
        continue;
      for (int i = 0; i < cells.box_count(j, k); ++i)
        for (const CellKind& kind : cells.kinds())
        {
          if (i >= cells.count_in_row(kind, j, k))
            continue;
          if (cell >= begin && cell < end)
            visit(kind, LatticePoint{i, j, k});
          ++cell;
        }
    }
}

int dimension(const BlockLattice& lattice)
{
  return element::dimension(lattice.nodes.shape);
}

/// Marks the nodes of the own cells of a block that is cut: inner ones in the share, others in the skeleton.
void mark_cut(const RegionCells& cells, BlockShare& share, std::vector<std::int32_t>& skeleton)
{
  const BlockLattice& lattice = cells.lattice(share.block);
  const int order = lattice.order;
  const auto for_each_node = [&](const auto& visit)
  {
    for_each_cell(
        cells.cells(share.block), share.begin, share.end,
        [&](const CellKind& kind, const LatticePoint& box)
        {
          for (const LatticePoint& node : kind.nodes)
            visit(LatticePoint{order * box[0] + node[0], order * box[1] + node[1], order * box[2] + node[2]});
        });
  };
  std::int64_t low = size(lattice.inner);
  std::int64_t high = -1;
  for_each_node(
      [&](const LatticePoint& node)
      {
        const BlockLattice::OnSide at = lattice.find(node);
        if (at.side >= 0)
          skeleton[lattice.sides[at.side][at.position]] = 0;
        else
        {
          const std::int64_t index = lattice.inner_index(node);
          low = std::min(low, index);
          high = std::max(high, index);
        }
      });
  share.low = low;
  share.inner.assign(std::max(high - low + 1, std::int64_t{0}), -1);
  for_each_node(
      [&](const LatticePoint& node)
      {
        if (lattice.find(node).side < 0)
          share.inner[lattice.inner_index(node) - low] = 0;
      });
}

}  // namespace

std::int32_t BlockShare::local_inner(std::int64_t index) const
{
  if (whole)
    return first_inner + static_cast<std::int32_t>(index);
  const std::int64_t at = index - low;
  return at < 0 || at >= static_cast<std::int64_t>(inner.size()) ? -1 : inner[at];
}

void BlockShare::read_row(const BlockLattice& lattice, int j, int k, std::int32_t* numbers) const
{
  const Grid& grid = lattice.nodes;
  const int length = row_length(grid, j, k);
  const bool flat = dimension(lattice) == 2;
  // A row on a side whose first coordinate is i lies there as a whole.
  const auto copy = [&](Wall wall, int t)
  {
    const int side = side_at(grid.shape, wall);
    const std::int32_t* from = sides[side].data() + index(lattice.side_grids[side], {0, t, 0});
    std::copy_n(from, length, numbers);
  };
  const auto at = [&](Wall wall)
  {
    const int side = side_at(grid.shape, wall);
    return flat ? sides[side][j] : sides[side][index(lattice.side_grids[side], {j, k, 0})];
  };
  if (!flat && k == 0)
    return copy(Wall::bottom, j);
  if (j == 0)
    return copy(Wall::front, k);
  if (side_at(grid.shape, Wall::back) >= 0 && j + 1 == row_count(grid, k))
    return copy(Wall::back, k);
  if (side_at(grid.shape, Wall::top) >= 0 && k + 1 == block::level_count(grid))
    return copy(Wall::top, j);
  numbers[0] = at(Wall::left);
  numbers[length - 1] = length > 1 ? at(Wall::right) : numbers[0];
  if (length < 3)
    return;
  const std::int64_t first = lattice.inner_index({1, j, k});
  if (whole)
    for (int i = 1; i + 1 < length; ++i)
      numbers[i] = first_inner + static_cast<std::int32_t>(first) + i - 1;
  else
    for (int i = 1; i + 1 < length; ++i)
      numbers[i] = local_inner(first + i - 1);
}

std::vector<BlockPlan::Row> BlockShare::rows(const BlockLattice& lattice) const
{
  std::vector<BlockPlan::Row> result;
  const Grid& grid = lattice.inner;
  if (size(grid) == 0)
    return result;
  const int flat = dimension(lattice) == 2 ? 0 : 1;
  const int levels = flat == 0 ? 1 : block::level_count(grid);
  std::int64_t at = 0;
  for (int k = 0; k < levels; ++k)
    for (int j = 0; j < row_count(grid, k); ++j)
    {
      const int length = row_length(grid, j, k);
      const bool reached = !whole && at + length > low && at < low + static_cast<std::int64_t>(inner.size());
      if (whole)
        result.push_back({j + 1, k + flat, 1, length + 1, local_inner(at)});
      else
        for (int i = 0; reached && i < length; ++i)
        {
          const std::int32_t node = local_inner(at + i);
          if (node < 0)
            continue;
          if (i > 0 && local_inner(at + i - 1) >= 0)
            ++result.back().end;
          else
            result.push_back({j + 1, k + flat, i + 1, i + 2, node});
        }
      at += length;
    }
  return result;
}

std::vector<BlockShare> own_shares(const RegionCells& cells, Part part)
{
  const std::int64_t begin = cells.share_begin(part.rank, part.size);
  const std::int64_t end = cells.share_begin(part.rank + 1, part.size);
  std::vector<BlockShare> shares;
  for (const int block : cells.blocks())
  {
    const std::int64_t first = cells.first_cell(block);
    const std::int64_t count = cells.cells(block).count();
    BlockShare share;
    share.block = block;
    share.begin = std::max(begin - first, std::int64_t{0});
    share.end = std::min(end - first, count);
    share.whole = share.begin == 0 && share.end == count;
    if (share.begin < share.end)
      shares.push_back(std::move(share));
  }
  return shares;
}

void add_counts(const BlockCells& cells, std::int64_t begin, std::int64_t end,
                RegionCells::ShapeCounts& counts)
{
  if (begin == 0 && end == cells.count())
  {
    for (const CellKind& kind : cells.kinds())
      counts[static_cast<std::size_t>(kind.shape)] += cells.count_of(kind);
    return;
  }
  for_each_cell(cells, begin, end,
                [&](const CellKind& kind, const LatticePoint&)
                { ++counts[static_cast<std::size_t>(kind.shape)]; });
}

LocalSkeleton number_nodes(const Skeleton& skeleton, const RegionCells& cells,
                           std::vector<BlockShare>& shares)
{
  LocalSkeleton local;
  local.node.assign(skeleton.count, -1);
  for (BlockShare& share : shares)
  {
    if (!share.whole)
      mark_cut(cells, share, local.node);
    else
      for (const auto& side : cells.lattice(share.block).sides)
        for (const std::int32_t node : side)
          local.node[node] = 0;
  }
  std::int32_t next = 0;
  for (std::int32_t& node : local.node)
    if (node >= 0)
      node = next++;
  local.count = next;

  std::vector<BlockShare*> ascending;
  for (BlockShare& share : shares)
    ascending.push_back(&share);
  std::sort(ascending.begin(), ascending.end(),
            [](const BlockShare* a, const BlockShare* b) { return a->block < b->block; });
  for (BlockShare* share : ascending)
  {
    share->first_inner = next;
    if (share->whole)
      next += static_cast<std::int32_t>(size(cells.lattice(share->block).inner));
    for (std::int32_t& node : share->inner)
      if (node >= 0)
        node = next++;
    for (const auto& side : cells.lattice(share->block).sides)
    {
      std::vector<std::int32_t>& numbers = share->sides.emplace_back();
      numbers.reserve(side.size());
      for (const std::int32_t node : side)
        numbers.push_back(local.node[node]);
    }
  }
  local.node_count = next;
  return local;
}

void name_nodes(const Skeleton& skeleton, const RegionCells& cells, const std::vector<BlockShare>& shares,
                const LocalSkeleton& local, Part part, mesh::Mesh& mesh)
{
  mesh.lattice.resize(local.node_count);
  const bool shared = part.size > 1;
  std::vector<std::int64_t> lowest;
  if (shared)
  {
    mesh.owner.resize(local.node_count);
    lowest = cells.lowest_cells();
  }
  for (std::int64_t number = 0; number < skeleton.count; ++number)
    if (const std::int32_t node = local.node[number]; node >= 0)
    {
      mesh.lattice[node] = number;
      if (shared)
        mesh.owner[node] = cells.rank_of_cell(lowest[number], part.size);
    }
  for (const BlockShare& share : shares)
  {
    const BlockLattice& lattice = cells.lattice(share.block);
    for (const BlockPlan::Row& row : share.rows(lattice))
      for (int i = row.begin; i < row.end; ++i)
      {
        const LatticePoint point{i, row.j, row.k};
        const std::int32_t node = row.node + i - row.begin;
        mesh.lattice[node] = lattice.number(point);
        if (shared)
          mesh.owner[node] = share.whole ? part.rank
                                         : cells.rank_of_cell(cells.first_cell(share.block) +
                                                                  cells.cells(share.block).lowest_cell(point),
                                                              part.size);
      }
  }
}

}  // namespace blockfsi::block
