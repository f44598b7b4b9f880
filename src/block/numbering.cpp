#include "block/numbering.hpp"

#include "block/topology.hpp"

#include <algorithm>

namespace blockfsi::block
{

namespace
{

using element::LatticePoint;
using element::Shape;

/// The numbers of an entity as seen from corners in another order: entry (s, t) of `grid` is the point (s, t)
/// of the frame.
std::vector<std::int32_t> reordered(const Grid& grid, const Grid& own, const SideFrame& frame,
                                    const std::vector<std::int32_t>& numbers)
{
  std::vector<std::int32_t> result;
  result.reserve(numbers.size());
  for (int t = 0; t < row_count(grid, 0); ++t)
    for (int s = 0; s < row_length(grid, t, 0); ++s)
      result.push_back(numbers[index(own, frame.at(s, t))]);
  return result;
}

/// Places of some points among others.
std::vector<int> places(std::span<const int> points, const std::vector<int>& among)
{
  std::vector<int> result;
  for (const int point : points)
    result.push_back(static_cast<int>(std::find(among.begin(), among.end(), point) - among.begin()));
  return result;
}

/// Numbers of the nodes of a block's side in the side's own order.
std::vector<std::int32_t> numbers_from(const Skeleton& skeleton, const Block& block, int side, int entity,
                                       const Grid& grid)
{
  const element::SideShape& of = element::sides(block.shape)[side];
  std::vector<int> points;
  for (int c = 0; c < element::corner_count(of.shape); ++c)
    points.push_back(block.points[of.corners[c]]);
  std::vector<std::int32_t> numbers = side_numbers(skeleton, entity);
  if (of.shape == Shape::segment)
  {
    if (skeleton.edges[entity].a != points[0])
      std::reverse(numbers.begin(), numbers.end());
    return numbers;
  }
  const Grid own = face_grid(skeleton.faces[entity], skeleton.order);
  const std::vector<int> at = places(points, side_points(skeleton, entity));
  return reordered(grid, own, frame(own, at[0], at[1], at.back()), numbers);
}

/// Edges of a shape along xi, eta and zeta from its first corner.
std::array<int, 3> axis_edges(Shape shape)
{
  switch (shape)
  {
  case Shape::triangle:
    return {0, 2, -1};
  case Shape::quadrilateral:
    return {0, 3, -1};
  case Shape::tetrahedron:
    return {0, 2, 3};
  case Shape::hexahedron:
    return {0, 3, 8};
  case Shape::prism:
    return {0, 2, 6};
  default:
    return {0, 3, 4};
  }
}

}  // namespace

std::vector<std::int32_t> edge_numbers(const PlacedEdge& edge)
{
  std::vector<std::int32_t> numbers{edge.a};
  for (std::int64_t node = edge.first; node < edge.first + edge.count; ++node)
    numbers.push_back(static_cast<std::int32_t>(node));
  numbers.push_back(edge.b);
  return numbers;
}

Grid face_grid(const PlacedFace& face, int order)
{
  return {face.shape, {face.divisions[0] * order, face.divisions[1] * order, 0}};
}

std::vector<std::int32_t> face_numbers(const Skeleton& skeleton, const PlacedFace& face)
{
  const Grid grid = face_grid(face, skeleton.order);
  std::vector<std::int32_t> numbers(size(grid));
  const auto edges = element::edges(face.shape);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    std::vector<std::int32_t> along = edge_numbers(skeleton.edges[face.edges[e]]);
    if (along.front() != face.points[edges[e][0]])
      std::reverse(along.begin(), along.end());
    const LatticePoint origin = corner_point(grid, edges[e][0]);
    const Way way = way_between(grid, edges[e][0], edges[e][1]);
    for (int s = 0; s <= way.count; ++s)
      numbers[index(grid, {origin[0] + s * way.step[0], origin[1] + s * way.step[1], 0})] = along[s];
  }
  const Grid inner = interior(grid);
  std::int64_t next = face.first;
  for (int j = 0; face.count > 0 && j < row_count(inner, 0); ++j)
    for (int i = 0; i < row_length(inner, j, 0); ++i)
      numbers[index(grid, {i + 1, j + 1, 0})] = static_cast<std::int32_t>(next++);
  return numbers;
}

geometry::Point node_position(const Skeleton& skeleton, std::int64_t node)
{
  geometry::Point x{};
  std::copy_n(skeleton.x.begin() + node * skeleton.dim, skeleton.dim, x.begin());
  return x;
}

std::vector<std::int32_t> side_numbers(const Skeleton& skeleton, int side)
{
  return skeleton.dim == 2 ? edge_numbers(skeleton.edges[side])
                           : face_numbers(skeleton, skeleton.faces[side]);
}

Grid block_grid(const Block& block, const std::vector<int>& edges, std::span<const PlacedEdge> all, int order)
{
  Grid grid{block.shape, {}};
  const std::array<int, 3> axes = axis_edges(block.shape);
  for (int d = 0; d < element::dimension(block.shape); ++d)
    grid.steps[d] = all[edges[axes[d]]].divisions * order;
  return grid;
}

SideFrame frame(const Grid& grid, int corner, int first, int second)
{
  return {corner_point(grid, corner), way_between(grid, corner, first).step,
          way_between(grid, corner, second).step};
}

SideFrame side_frame(const Grid& grid, int side)
{
  const element::SideShape& of = element::sides(grid.shape)[side];
  if (of.shape == Shape::segment)
    return frame(grid, of.corners[0], of.corners[1], of.corners[0]);
  return frame(grid, of.corners[0], of.corners[1], of.corners[element::corner_count(of.shape) - 1]);
}

BlockLattice::OnSide BlockLattice::find(const LatticePoint& node) const
{
  const auto [i, j, k] = node;
  const auto on = [&](Wall wall, int s, int t) -> OnSide
  {
    const int side = side_at(nodes.shape, wall);
    return {side, side < 0 ? 0 : index(side_grids[side], {s, t, 0})};
  };
  const bool flat = element::dimension(nodes.shape) == 2;
  if (!flat && k == 0)
    return on(Wall::bottom, i, j);
  if (j == 0)
    return on(Wall::front, i, k);
  if (i == 0)
    return flat ? on(Wall::left, j, 0) : on(Wall::left, j, k);
  if (i + 1 == row_length(nodes, j, k))
    return flat ? on(Wall::right, j, 0) : on(Wall::right, j, k);
  if (side_at(nodes.shape, Wall::back) >= 0 && j + 1 == row_count(nodes, k))
    return on(Wall::back, i, k);
  if (side_at(nodes.shape, Wall::top) >= 0 && k + 1 == level_count(nodes))
    return on(Wall::top, i, j);
  return {};
}

std::int64_t BlockLattice::inner_index(const LatticePoint& node) const
{
  const int flat = element::dimension(nodes.shape) == 2 ? 0 : 1;
  return index(inner, {node[0] - 1, node[1] - 1, node[2] - flat});
}

std::int64_t BlockLattice::number(const LatticePoint& node) const
{
  const OnSide at = find(node);
  return at.side < 0 ? first_inner + inner_index(node) : sides[at.side][at.position];
}

BlockLattice block_lattice(const Layout& layout, const Skeleton& skeleton, int b)
{
  const Block& block = layout.blocks[b];
  BlockLattice lattice;
  lattice.order = skeleton.order;
  lattice.nodes = block_grid(block, skeleton.block_edges[b], skeleton.edges, skeleton.order);
  lattice.cells = block_grid(block, skeleton.block_edges[b], skeleton.edges, 1);
  lattice.inner = interior(lattice.nodes);
  lattice.corners.assign(block.points.begin(), block.points.end());
  for (int side = 0; side < static_cast<int>(element::sides(block.shape).size()); ++side)
  {
    lattice.side_grids.push_back(side_grid(lattice.nodes, side));
    lattice.sides.push_back(
        numbers_from(skeleton, block, side, skeleton.block_sides[b][side], lattice.side_grids.back()));
  }
  lattice.first_inner = skeleton.block_first[b];
  return lattice;
}

}  // namespace blockfsi::block
