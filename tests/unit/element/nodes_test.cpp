#include "element/nodes.hpp"

#include "core/error.hpp"
#include "element/line.hpp"
#include "element/table.hpp"
#include "shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace blockfsi::element;

namespace
{

double distance(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Largest sum of the magnitudes of the Lagrange functions over a fine lattice.
double lebesgue(Shape shape, int order, NodeKind kind)
{
  const std::vector<Point> points = equispaced_nodes(shape, dimension(shape) == 2 ? 60 : 24);
  const CellTable table = tabulate(shape, order, points, 0, kind);
  double largest = 0.0;
  for (int q = 0; q < table.point_count; ++q)
  {
    double sum = 0.0;
    for (int n = 0; n < table.node_count; ++n)
      sum += std::abs(table.value[q * table.node_count + n]);
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace

TEST_CASE("nodes at the corners of a cell are its corners")
{
  for (const Shape shape : all_shapes)
    for (int order = 1; order <= 8; ++order)
    {
      const std::vector<Point> at = nodes(shape, order);
      for (const Point& corner : corners(shape))
      {
        const LatticePoint point = {static_cast<int>(corner[0]) * order, static_cast<int>(corner[1]) * order,
                                    static_cast<int>(corner[2]) * order};
        CHECK(at[lattice_index(shape, order, point)] == corner);
      }
    }
}

TEST_CASE("edges carry Gauss-Lobatto points and sides the nodes of their own shape")
{
  for (const Shape shape : all_shapes)
    for (int order = 1; order <= 8; ++order)
    {
      const std::vector<Point> at = nodes(shape, order);
      const std::vector<double> line = lobatto(order);
      for (std::size_t e = 0; e < edges(shape).size(); ++e)
      {
        const std::vector<std::int32_t> on = edge_lattice(shape, order, static_cast<int>(e));
        const Point& a = corners(shape)[edges(shape)[e][0]];
        const Point& b = corners(shape)[edges(shape)[e][1]];
        for (int k = 0; k <= order; ++k)
          for (int d = 0; d < 3; ++d)
            CHECK(std::abs(at[on[k]][d] - (a[d] + line[k] * (b[d] - a[d]))) < 3e-16);
      }
      for (int side = 0; side < static_cast<int>(sides(shape).size()); ++side)
      {
        const std::vector<std::int32_t> on = side_lattice(shape, order, side);
        const std::vector<Point> of_side = nodes(sides(shape)[side].shape, order);
        for (std::size_t k = 0; k < on.size(); ++k)
          CHECK(distance(at[on[k]], on_side(shape, side, of_side[k])) < 5e-16);
      }
    }
}

TEST_CASE("no permutation of the corners moves the nodes of a triangle or a tetrahedron")
{
  for (const Shape shape : {Shape::triangle, Shape::tetrahedron})
    for (int order = 1; order <= 8; ++order)
    {
      const int count = corner_count(shape);
      const std::vector<Point> at = nodes(shape, order);
      const std::vector<LatticePoint> lattice = lattice_points(shape, order);
      const auto barycentric = [&](std::size_t m) {
        return std::array<double, 4>{1.0 - at[m][0] - at[m][1] - at[m][2], at[m][0], at[m][1], at[m][2]};
      };
      std::array<int, 4> turn = {0, 1, 2, 3};
      do
        for (std::size_t m = 0; m < lattice.size(); ++m)
        {
          const auto [i, j, k] = lattice[m];
          const std::array<int, 4> steps = {order - i - j - k, i, j, k};
          const std::size_t image =
              lattice_index(shape, order, {steps[turn[1]], steps[turn[2]], count == 4 ? steps[turn[3]] : 0});
          for (int c = 0; c < count; ++c)
            CHECK(std::abs(barycentric(image)[c] - barycentric(m)[turn[c]]) < 3e-16);
        }
      while (std::next_permutation(turn.begin(), turn.begin() + count));
    }
}

TEST_CASE("no symmetry of the base moves the nodes of a pyramid")
{
  for (int order = 1; order <= 8; ++order)
  {
    const std::vector<Point> at = nodes(Shape::pyramid, order);
    const std::vector<LatticePoint> lattice = lattice_points(Shape::pyramid, order);
    for (std::size_t m = 0; m < lattice.size(); ++m)
    {
      const auto [i, j, k] = lattice[m];
      const auto [x, y, z] = at[m];
      const Point& turned = at[lattice_index(Shape::pyramid, order, {order - k - j, i, k})];
      const Point& mirrored = at[lattice_index(Shape::pyramid, order, {j, i, k})];
      CHECK(distance(turned, {1.0 - z - y, x, z}) < 5e-16);
      CHECK(distance(mirrored, {y, x, z}) < 5e-16);
    }
  }
}

TEST_CASE("interpolation at the nodes stays well conditioned up to order 8")
{
  // Bounds just above what was measured: 5.08, 11.67, 4.15, 8.43, 10.34 and 10.08. Isaac 2020 finds these
  // nodes nearly as good as warp and blend nodes on triangles, and better on tetrahedra above order 6.
  CHECK(lebesgue(Shape::triangle, 8, NodeKind::warped) < 5.1);
  CHECK(lebesgue(Shape::tetrahedron, 8, NodeKind::warped) < 12.5);
  CHECK(lebesgue(Shape::quadrilateral, 8, NodeKind::warped) < 4.2);
  CHECK(lebesgue(Shape::hexahedron, 8, NodeKind::warped) < 8.6);
  CHECK(lebesgue(Shape::prism, 8, NodeKind::warped) < 10.5);
  CHECK(lebesgue(Shape::pyramid, 8, NodeKind::warped) < 10.5);
  for (const Shape shape : all_shapes)
    if (shape != Shape::segment)
      CHECK(lebesgue(shape, 8, NodeKind::warped) < 0.3 * lebesgue(shape, 8, NodeKind::equispaced));
}

TEST_CASE("equispaced nodes are the points of the lattice")
{
  CHECK(equispaced_nodes(Shape::pyramid, 3)[lattice_index(Shape::pyramid, 3, {1, 0, 2})] ==
        Point{1.0 / 3.0, 0.0, 2.0 / 3.0});
}

TEST_CASE("an order that no table is made for is refused")
{
  CHECK_THROWS_AS(nodes(Shape::prism, 0), blockfsi::Error);
  CHECK_THROWS_AS(nodes(Shape::prism, 9), blockfsi::Error);
}
