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
  return sum;
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

}  // namespace

RegionCells::RegionCells(const Layout& layout, const Skeleton& skeleton, std::string_view region)
    : skeleton_(skeleton), blocks_(sorted_blocks(layout, region)), first_cell_(layout.blocks.size(), -1)
{
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
    lattices_.push_back(block_lattice(layout, skeleton, static_cast<int>(b)));
  for (const int block : blocks_)
  {
    first_cell_[block] = cell_count_;
    cell_count_ += lattices_[block].cell_count();
  }
  find_lowest_at_points();
}

void RegionCells::find_lowest_at_points()
{
  lowest_at_point_.assign(skeleton_.point_count, cell_count_);
  for (const int block : blocks_)
    for (int side = 0; side < 4; ++side)
    {
      const BlockLattice& lattice = lattices_[block];
      for (const int k : {0, side % 2 == 0 ? lattice.columns : lattice.rows})
      {
        const auto [i, j] = lattice.on_side(side, k);
        std::int64_t& lowest = lowest_at_point_[lattice.number(i, j)];
        lowest = std::min(lowest, first_cell_[block] + lattice.lowest_cell(i, j));
      }
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

int RegionCells::block_of(std::int64_t node) const
{
  const auto& first = skeleton_.block_first;
  return static_cast<int>(std::upper_bound(first.begin(), first.end(), node) - first.begin()) - 1;
}

std::int64_t RegionCells::lowest_on_edge(std::int64_t node) const
{
  const auto after = std::upper_bound(skeleton_.edges.begin(), skeleton_.edges.end(), node,
                                      [](std::int64_t n, const PlacedEdge& edge) { return n < edge.first; });
  const PlacedEdge& edge = *(after - 1);
  const int along = static_cast<int>(node - edge.first) + 1;
  std::int64_t lowest = cell_count_;
  for (const int block : edge.blocks)
  {
    if (!contains(block))
      continue;
    const BlockLattice& lattice = lattices_[block];
    const auto side = std::find(lattice.edges.begin(), lattice.edges.end(), &edge) - lattice.edges.begin();
    const int k = lattice.forward[side] ? along : static_cast<int>(edge.count) + 1 - along;
    const auto [i, j] = lattice.on_side(static_cast<int>(side), k);
    lowest = std::min(lowest, first_cell_[block] + lattice.lowest_cell(i, j));
  }
  return lowest;
}

std::int64_t RegionCells::lowest_cell(std::int64_t node) const
{
  if (node < skeleton_.point_count)
    return lowest_at_point_[node];
  if (node < skeleton_.count)
    return lowest_on_edge(node);
  const int block = block_of(node);
  const BlockLattice& lattice = lattices_[block];
  const std::int64_t k = node - lattice.first_inner;
  const int i = static_cast<int>(k % (lattice.columns - 1)) + 1;
  const int j = static_cast<int>(k / (lattice.columns - 1)) + 1;
  return first_cell_[block] + lattice.lowest_cell(i, j);
}

std::int64_t RegionCells::node_count() const
{
  std::int64_t count = 0;
  for (const std::int64_t lowest : lowest_at_point_)
    count += lowest < cell_count_ ? 1 : 0;
  for (const PlacedEdge& edge : skeleton_.edges)
    if (std::any_of(edge.blocks.begin(), edge.blocks.end(), [this](int block) { return contains(block); }))
      count += edge.count;
  for (const int block : blocks_)
    count += skeleton_.block_first[block + 1] - skeleton_.block_first[block];
  return count;
}

}  // namespace blockfsi::block
