#include "block/grid.hpp"

#include <algorithm>
#include <cstdlib>

namespace blockfsi::block
{

namespace
{

using element::LatticePoint;
using element::Shape;

/// n (n + 1) / 2, 0 for n < 0.
std::int64_t triangular(std::int64_t n)
{
  return n < 0 ? 0 : n * (n + 1) / 2;
}

/// Points of a triangle, a tetrahedron and a pyramid with m points along each edge.
std::int64_t triangle_size(std::int64_t m)
{
  return triangular(m);
}

std::int64_t tetrahedron_size(std::int64_t m)
{
  return m < 0 ? 0 : m * (m + 1) * (m + 2) / 6;
}

std::int64_t pyramid_size(std::int64_t m)
{
  return m < 0 ? 0 : m * (m + 1) * (2 * m + 1) / 6;
}

}  // namespace

int side_at(Shape shape, Wall wall)
{
  // bottom, front, right, back, left, top
  constexpr std::array<std::array<std::int8_t, wall_count>, element::shape_count> table{
      {{-1, -1, 1, -1, 0, -1},
       {-1, 0, 1, -1, 2, -1},
       {-1, 0, 1, 2, 3, -1},
       {0, 1, 2, -1, 3, -1},
       {0, 1, 2, 3, 4, 5},
       {0, 1, 2, -1, 3, 4},
       {0, 1, 2, 3, 4, -1}}};
  return table[static_cast<std::size_t>(shape)][static_cast<std::size_t>(wall)];
}

int level_count(const Grid& grid)
{
  return grid.steps[2] + 1;
}

int row_count(const Grid& grid, int k)
{
  const bool shrinks = grid.shape == Shape::tetrahedron || grid.shape == Shape::pyramid;
  return grid.steps[1] + 1 - (shrinks ? k : 0);
}

int row_length(const Grid& grid, int j, int k)
{
  switch (grid.shape)
  {
  case Shape::triangle:
  case Shape::prism:
    return grid.steps[0] + 1 - j;
  case Shape::tetrahedron:
    return grid.steps[0] + 1 - j - k;
  case Shape::pyramid:
    return grid.steps[0] + 1 - k;
  default:
    return grid.steps[0] + 1;
  }
}

std::int64_t size(const Grid& grid)
{
  const std::int64_t a = std::max(grid.steps[0] + 1, 0);
  const std::int64_t b = std::max(grid.steps[1] + 1, 0);
  const std::int64_t c = std::max(grid.steps[2] + 1, 0);
  switch (grid.shape)
  {
  case Shape::triangle:
  case Shape::prism:
    return triangle_size(a) * c;
  case Shape::tetrahedron:
    return tetrahedron_size(a);
  case Shape::pyramid:
    return pyramid_size(a);
  default:
    return a * b * c;
  }
}

std::int64_t index(const Grid& grid, const LatticePoint& point)
{
  const std::int64_t i = point[0];
  const std::int64_t j = point[1];
  const std::int64_t k = point[2];
  const std::int64_t a = grid.steps[0] + 1;
  const std::int64_t b = grid.steps[1] + 1;
  switch (grid.shape)
  {
  case Shape::triangle:
  case Shape::prism:
    return i + j * a - triangular(j - 1) + k * triangle_size(a);
  case Shape::tetrahedron:
    return tetrahedron_size(a) - tetrahedron_size(a - k) + i + j * (a - k) - triangular(j - 1);
  case Shape::pyramid:
    return pyramid_size(a) - pyramid_size(a - k) + i + j * (a - k);
  default:
    return i + a * (j + b * k);
  }
}

Grid interior(const Grid& grid)
{
  Grid inner = grid;
  const int less = grid.shape == Shape::tetrahedron ? 4 : 3;
  switch (grid.shape)
  {
  case Shape::triangle:
    inner.steps = {grid.steps[0] - less, grid.steps[0] - less, 0};
    break;
  case Shape::prism:
    inner.steps = {grid.steps[0] - less, grid.steps[0] - less, grid.steps[2] - 2};
    break;
  case Shape::tetrahedron:
  case Shape::pyramid:
    inner.steps = {grid.steps[0] - less, grid.steps[0] - less, grid.steps[0] - less};
    break;
  default:
    for (int d = 0; d < element::dimension(grid.shape); ++d)
      inner.steps[d] -= 2;
  }
  return inner;
}

LatticePoint corner_point(const Grid& grid, int corner)
{
  const std::array<double, 3>& x = element::corners(grid.shape)[corner];
  return {static_cast<int>(x[0]) * grid.steps[0], static_cast<int>(x[1]) * grid.steps[1],
          static_cast<int>(x[2]) * grid.steps[2]};
}

Way way_between(const Grid& grid, int from, int to)
{
  const LatticePoint a = corner_point(grid, from);
  const LatticePoint b = corner_point(grid, to);
  Way way;
  for (int d = 0; d < 3; ++d)
    way.count = std::max(way.count, std::abs(b[d] - a[d]));
  for (int d = 0; d < 3; ++d)
    way.step[d] = way.count > 0 ? (b[d] - a[d]) / way.count : 0;
  return way;
}

Grid side_grid(const Grid& grid, int side)
{
  const element::SideShape& of = element::sides(grid.shape)[side];
  const int last = of.corners[element::corner_count(of.shape) - 1];
  Grid result{of.shape, {way_between(grid, of.corners[0], of.corners[1]).count, 0, 0}};
  if (of.shape != Shape::segment)
    result.steps[1] = way_between(grid, of.corners[0], last).count;
  return result;
}

}  // namespace blockfsi::block
