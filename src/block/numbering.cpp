#include "block/numbering.hpp"

#include "block/topology.hpp"

#include <algorithm>

namespace blockfsi::block
{

std::int64_t BlockLattice::side_number(int side, int k) const
{
  const PlacedEdge& edge = *edges[side];
  const std::int64_t along = forward[side] ? k : edge.count + 1 - k;
  if (along == 0)
    return edge.a;
  return along == edge.count + 1 ? edge.b : edge.first + along - 1;
}

std::int64_t BlockLattice::number(int i, int j) const
{
  if (j == 0)
    return side_number(0, i);
  if (i == columns)
    return side_number(1, j);
  if (j == rows)
    return side_number(2, i);
  if (i == 0)
    return side_number(3, j);
  return first_inner + (i - 1) + static_cast<std::int64_t>(j - 1) * (columns - 1);
}

std::array<int, 2> BlockLattice::on_side(int side, int k) const
{
  if (side == 0 || side == 2)
    return {k, side == 0 ? 0 : rows};
  return {side == 3 ? 0 : columns, k};
}

std::int64_t BlockLattice::lowest_cell(int i, int j) const
{
  const int column = i == 0 ? 0 : (i - 1) / order;
  const int row = j == 0 ? 0 : (j - 1) / order;
  return column + static_cast<std::int64_t>(row) * cells_along_u();
}

BlockLattice block_lattice(const Layout& layout, const Skeleton& skeleton, int block)
{
  BlockLattice lattice;
  lattice.order = skeleton.order;
  std::copy_n(layout.blocks[block].points.begin(), 4, lattice.points.begin());
  for (int side = 0; side < 4; ++side)
  {
    lattice.edges[side] = &skeleton.edges[skeleton.block_edges[block][side]];
    lattice.forward[side] = lattice.edges[side]->a == side_ends(layout.blocks[block], side)[0];
  }
  lattice.columns = lattice.edges[0]->divisions * skeleton.order;
  lattice.rows = lattice.edges[3]->divisions * skeleton.order;
  lattice.first_inner = skeleton.block_first[block];
  return lattice;
}

}  // namespace blockfsi::block
