#include "element/lattice.hpp"

namespace blockfsi::element
{

namespace
{

std::int64_t triangular(std::int64_t n)
{
  return n * (n + 1) / 2;
}

/// Points of the row (j, k), counted along i.
int row_length(Shape shape, int n, int j, int k)
{
  switch (shape)
  {
  case Shape::triangle:
  case Shape::prism:
    return n - j + 1;
  case Shape::tetrahedron:
    return n - j - k + 1;
  case Shape::pyramid:
    return n - k + 1;
  default:
    return n + 1;
  }
}

/// Rows of the level k.
int row_count(Shape shape, int n, int k)
{
  switch (shape)
  {
  case Shape::segment:
    return 1;
  case Shape::tetrahedron:
  case Shape::pyramid:
    return n - k + 1;
  default:
    return n + 1;
  }
}

/// Corner of a cell as a point of its lattice.
LatticePoint corner_point(Shape shape, int n, int corner)
{
  const std::array<double, 3>& x = corners(shape)[corner];
  return {static_cast<int>(x[0]) * n, static_cast<int>(x[1]) * n, static_cast<int>(x[2]) * n};
}

/// a + (s (b - a) + t (c - a)) / n for points of which the differences are multiples of n.
LatticePoint between(int n, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, int s, int t)
{
  LatticePoint point{};
  for (int d = 0; d < 3; ++d)
    point[d] = a[d] + s * ((b[d] - a[d]) / n) + t * ((c[d] - a[d]) / n);
  return point;
}

}  // namespace

std::int64_t lattice_size(Shape shape, int n)
{
  const std::int64_t m = n + 1;
  switch (shape)
  {
  case Shape::segment:
    return m;
  case Shape::triangle:
    return triangular(m);
  case Shape::quadrilateral:
    return m * m;
  case Shape::tetrahedron:
    return m * (m + 1) * (m + 2) / 6;
  case Shape::hexahedron:
    return m * m * m;
  case Shape::prism:
    return triangular(m) * m;
  case Shape::pyramid:
    return m * (m + 1) * (2 * m + 1) / 6;
  }
  return 0;
}

std::int64_t interior_size(Shape shape, int n)
{
  const std::int64_t inner = n < 1 ? 0 : n - 1;
  switch (shape)
  {
  case Shape::segment:
    return inner;
  case Shape::triangle:
    return n < 3 ? 0 : triangular(n - 2);
  case Shape::quadrilateral:
    return inner * inner;
  case Shape::tetrahedron:
    return n < 4 ? 0 : lattice_size(Shape::tetrahedron, n - 4);
  case Shape::hexahedron:
    return inner * inner * inner;
  case Shape::prism:
    return n < 3 ? 0 : triangular(n - 2) * inner;
  case Shape::pyramid:
    return n < 3 ? 0 : lattice_size(Shape::pyramid, n - 3);
  }
  return 0;
}

std::int64_t lattice_index(Shape shape, int n, LatticePoint point)
{
  const auto [i, j, k] = point;
  const std::int64_t m = n + 1;
  switch (shape)
  {
  case Shape::segment:
    return i;
  case Shape::triangle:
    return i + j * m - triangular(j - 1);
  case Shape::quadrilateral:
    return i + j * m;
  case Shape::tetrahedron:
    return lattice_size(shape, n) - lattice_size(shape, n - k) +
           lattice_index(Shape::triangle, n - k, {i, j, 0});
  case Shape::hexahedron:
    return i + m * (j + m * k);
  case Shape::prism:
    return lattice_index(Shape::triangle, n, {i, j, 0}) + k * triangular(m);
  case Shape::pyramid:
    return lattice_size(shape, n) - lattice_size(shape, n - k) + i + j * (m - k);
  }
  return 0;
}

std::vector<LatticePoint> lattice_points(Shape shape, int n)
{
  std::vector<LatticePoint> points;
  points.reserve(lattice_size(shape, n));
  const int levels = dimension(shape) == 3 ? n : 0;
  for (int k = 0; k <= levels; ++k)
    for (int j = 0; j < row_count(shape, n, k); ++j)
      for (int i = 0; i < row_length(shape, n, j, k); ++i)
        points.push_back({i, j, k});
  return points;
}

std::vector<std::int32_t> side_lattice(Shape shape, int n, int side)
{
  const SideShape& of = sides(shape)[side];
  const LatticePoint origin = corner_point(shape, n, of.corners[0]);
  const LatticePoint first = corner_point(shape, n, of.corners[1]);
  const LatticePoint second =
      of.shape == Shape::segment ? origin : corner_point(shape, n, of.corners[corner_count(of.shape) - 1]);
  std::vector<std::int32_t> indices;
  indices.reserve(lattice_size(of.shape, n));
  for (const LatticePoint& point : lattice_points(of.shape, n))
    indices.push_back(static_cast<std::int32_t>(
        lattice_index(shape, n, between(n, origin, first, second, point[0], point[1]))));
  return indices;
}

std::vector<std::int32_t> edge_lattice(Shape shape, int n, int edge)
{
  const LatticePoint a = corner_point(shape, n, edges(shape)[edge][0]);
  const LatticePoint b = corner_point(shape, n, edges(shape)[edge][1]);
  std::vector<std::int32_t> indices;
  indices.reserve(n + 1);
  for (int s = 0; s <= n; ++s)
    indices.push_back(static_cast<std::int32_t>(lattice_index(shape, n, between(n, a, b, a, s, 0))));
  return indices;
}

}  // namespace blockfsi::element
