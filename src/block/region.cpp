#include "block/region.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

namespace blockfsi::block
{

namespace
{

double center_x(const Layout& layout, int block)
{
  double sum = 0.0;
  for (const int point : layout.blocks[block].points)
    sum += layout.points[point].x[0];
  return sum / static_cast<double>(layout.blocks[block].points.size());
}

std::vector<int> sorted_blocks(const Layout& layout, std::string_view region)
{
  std::vector<int> blocks;
  std::set<std::string> regions;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
  {
    regions.insert(layout.blocks[b].region);
    if (region.empty() || layout.blocks[b].region == region)
      blocks.push_back(static_cast<int>(b));
  }
  if (blocks.empty())
    throw Error(fmt::format("no block belongs to the region '{}'; the regions are {}{}", region,
                            listed(regions), did_you_mean(region, regions)));
  std::stable_sort(blocks.begin(), blocks.end(),
                   [&layout](int a, int b) { return center_x(layout, a) < center_x(layout, b); });
  return blocks;
}

/// The diagonal of a tetrahedron's octahedra (BlockCells) that is shortest where its edges are straight; it
/// stays the same however the block moves.
int shortest_diagonal(const Layout& layout, const Block& block)
{
  if (block.shape != element::Shape::tetrahedron)
    return 0;
  const auto edge = [&](int corner, int c)
  { return layout.points[block.points[corner]].x[c] - layout.points[block.points[0]].x[c]; };
  std::array<double, 3> length{};
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c)
    {
      const double sum = edge(1, c) + edge(2, c) + edge(3, c);
      length[d] += (sum - 2.0 * edge(d + 1, c)) * (sum - 2.0 * edge(d + 1, c));
    }
  return static_cast<int>(std::min_element(length.begin(), length.end()) - length.begin());
}

}  // namespace

RegionCells::RegionCells(const Layout& layout, const Skeleton& skeleton, std::string_view region)
    : skeleton_(skeleton), blocks_(sorted_blocks(layout, region)), lattices_(layout.blocks.size()),
      first_cell_(layout.blocks.size(), -1), first_of_shape_(layout.blocks.size())
{
  std::vector<bool> wanted(layout.blocks.size(), false);
  for (const int block : blocks_)
    wanted[block] = true;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
  {
    const int block = static_cast<int>(b);
    if (wanted[b])
      lattices_[b] = block_lattice(layout, skeleton, block);
    const Grid corners = wanted[b] ? lattices_[b].cells : Grid{layout.blocks[b].shape, {}};
    diagonals_.push_back(shortest_diagonal(layout, layout.blocks[b]));
    cells_.emplace_back(corners, skeleton.order, diagonals_.back());
  }
  for (const int block : blocks_)
  {
    first_cell_[block] = cell_count_;
    cell_count_ += cells_[block].count();
  }
  count_shapes();
}

void RegionCells::count_shapes()
{
  ShapeCounts sum{};
  const auto count = [](const BlockCells& cells, std::size_t shape)
  {
    std::int64_t result = 0;
    for (const CellKind& kind : cells.kinds())
      if (static_cast<std::size_t>(kind.shape) == shape)
        result += cells.count_of(kind);
    return result;
  };
  std::int64_t next = 0;
  for (std::size_t shape = 0; shape < sum.size(); ++shape)
    for (const int block : blocks_)
    {
      first_of_shape_[block][shape] = next;
      next += count(cells_[block], shape);
    }
}

std::int64_t RegionCells::share_begin(int rank, int size) const
{
  return cell_count_ * rank / size;
}

int RegionCells::rank_of_cell(std::int64_t cell, int size) const
{
  // The largest rank whose share begins at or before the cell: floor(n rank / size) <= cell.
  return static_cast<int>(((cell + 1) * size - 1) / cell_count_);
}

std::vector<std::int64_t> RegionCells::lowest_cells() const
{
  std::vector<std::int64_t> lowest(skeleton_.count, cell_count_);
  for (const int block : blocks_)
  {
    const BlockLattice& lattice = lattices_[block];
    for (std::size_t side = 0; side < lattice.sides.size(); ++side)
    {
      const SideFrame frame = side_frame(lattice.nodes, static_cast<int>(side));
      const Grid& grid = lattice.side_grids[side];
      const std::int32_t* node = lattice.sides[side].data();
      for (int t = 0; t < row_count(grid, 0); ++t)
        for (int s = 0; s < row_length(grid, t, 0); ++s, ++node)
          lowest[*node] =
              std::min(lowest[*node], first_cell_[block] + cells_[block].lowest_cell(frame.at(s, t)));
    }
  }
  return lowest;
}

std::int64_t RegionCells::node_count() const
{
  std::vector<bool> used(skeleton_.count, false);
  std::int64_t count = 0;
  for (const int block : blocks_)
  {
    for (const auto& side : lattices_[block].sides)
      for (const std::int32_t node : side)
        used[node] = true;
    count += skeleton_.block_first[block + 1] - skeleton_.block_first[block];
  }
  return count + std::count(used.begin(), used.end(), true);
}

}  // namespace blockfsi::block
