#include "mesh/validity.hpp"

#include "cells.hpp"
#include "core/error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace blockfsi;
using element::Point;
using element::Shape;
using mesh::Verdict;

namespace
{

Point same(const Point& x)
{
  return x;
}

/// Points all over a reference cell; on pyramids a lattice of collapsed coordinates, which comes near the
/// apex from all directions.
std::vector<Point> lattice(Shape shape, int n)
{
  std::vector<Point> points =
      element::equispaced_nodes(shape == Shape::pyramid ? Shape::hexahedron : shape, n);
  for (Point& point : points)
    if (shape == Shape::pyramid)
    {
      point[2] = std::min(point[2], 1.0 - 1e-9);
      point[0] *= 1.0 - point[2];
      point[1] *= 1.0 - point[2];
    }
  return points;
}

Verdict of(Shape shape, int order, const std::vector<double>& x)
{
  const mesh::ValidityTables tables(std::array{shape}, order);
  const Verdict alone = mesh::certify(tables, x);
  // The proof for eight cells at once must agree.
  std::vector<Verdict> verdicts(3);
  const SampleMesh sample = separate_cells(shape, order, {x, x, x});
  mesh::certify(tables, sample.mesh, sample.x, verdicts);
  for (const Verdict verdict : verdicts)
    CHECK(verdict == alone);
  return alone;
}

}  // namespace

TEST_CASE("a quadratic triangle with the middle of its long side moved inwards turns invalid at a = 1/4")
{
  const auto moved = [](double a)
  {
    std::vector<double> x = place_nodes(Shape::triangle, 2, same);
    const auto middle = element::lattice_index(Shape::triangle, 2, {1, 1, 0});
    x[2 * middle] -= a;
    x[2 * middle + 1] -= a;
    return x;
  };
  for (const double a : {0.0, 0.1, 0.2, 0.24, 0.249999})
    CHECK(of(Shape::triangle, 2, moved(a)) == Verdict::valid);
  for (const double a : {0.250001, 0.26, 0.3})
    CHECK(of(Shape::triangle, 2, moved(a)) == Verdict::invalid);
  CHECK(of(Shape::triangle, 2, moved(0.25)) != Verdict::valid);
}

TEST_CASE("verdicts on random cells of every shape are those of dense sampling")
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const Shape shape : cell_shapes)
    for (int order = 1; order <= 4; ++order)
    {
      const int dim = element::dimension(shape);
      const mesh::ValidityTables tables(std::array{shape}, order);
      const element::CellTable table = element::tabulate(shape, order, lattice(shape, dim == 2 ? 40 : 14), 1);
      int valid = 0;
      int hidden = 0;
      int undecided = 0;
      std::vector<std::vector<double>> cells;
      std::vector<Verdict> alone;
      const int trials = 60;
      for (int trial = 0; trial < trials; ++trial)
      {
        std::vector<double> x = place_nodes(shape, order, same);
        const double size = 0.4 * (trial % 10 + 1) / 10.0;
        for (double& coordinate : x)
          coordinate += normal(random) * size / order;
        const std::vector<double> samples = jacobians(table, dim, x);
        const double minimum = *std::min_element(samples.begin(), samples.end());
        const Verdict verdict = mesh::certify(tables, x);
        if (verdict == Verdict::valid)
          CHECK(minimum > 0.0);
        if (verdict == Verdict::invalid)
          CHECK(minimum < 0.1);
        valid += verdict == Verdict::valid;
        undecided += verdict == Verdict::undecided;
        hidden += verdict == Verdict::invalid && minimum > 0.0;
        cells.push_back(x);
        alone.push_back(verdict);
      }
      CHECK(undecided == 0);
      CHECK(valid > trials / 10);
      CHECK(valid < trials);
      CHECK(hidden <= trials / 10);
      // Together, with those proved eight at a time, the verdicts are the same.
      const SampleMesh sample = separate_cells(shape, order, cells);
      std::vector<Verdict> together(cells.size());
      const mesh::Validity validity = mesh::certify(tables, sample.mesh, sample.x, together);
      CHECK(together == alone);
      CHECK(validity.valid == valid);
    }
}

TEST_CASE("straight cells of every shape and order are valid however thin, small, far away or turned")
{
  for (const Shape shape : cell_shapes)
    for (int order = 1; order <= (element::dimension(shape) == 2 ? 8 : 5); ++order)
      for (const double thin : {1.0, 1e-4})
        for (const double size : {1.0, 1e-9})
        {
          const auto map = [&](const Point& p) -> Point
          {
            const double u = size * p[0];
            const double v = size * thin * p[1];
            return {u * std::cos(0.7) - v * std::sin(0.7) + 10.0 * size,
                    u * std::sin(0.7) + v * std::cos(0.7) + 0.3 * size * p[2], size * p[2]};
          };
          CHECK(of(shape, order, place_nodes(shape, order, map)) == Verdict::valid);
        }
}

TEST_CASE("mirrored, flat, collapsed and unreal cells of every shape and order are invalid")
{
  for (const Shape shape : cell_shapes)
    for (int order = 1; order <= 4; ++order)
    {
      CHECK(of(shape, order,
               place_nodes(shape, order,
                           [](const Point& p) -> Point {
                             return {-p[0], p[1], p[2]};
                           })) == Verdict::invalid);
      CHECK(of(shape, order,
               place_nodes(shape, order,
                           [](const Point& p) -> Point {
                             return {p[0], 0.3 * p[0], p[2]};
                           })) == Verdict::invalid);
      CHECK(of(shape, order,
               place_nodes(shape, order,
                           [](const Point&) -> Point {
                             return {0.3, 0.1, 0.7};
                           })) == Verdict::invalid);
      std::vector<double> x = place_nodes(shape, order, same);
      x[3] = std::numeric_limits<double>::quiet_NaN();
      CHECK(of(shape, order, x) == Verdict::invalid);
      x[3] = std::numeric_limits<double>::infinity();
      CHECK(of(shape, order, x) == Verdict::invalid);
    }
}

TEST_CASE("a cell of which one corner is drawn through the cell is invalid in every shape")
{
  for (const Shape shape : cell_shapes)
  {
    std::vector<double> x = place_nodes(shape, 1, same);
    const int dim = element::dimension(shape);
    for (int d = 0; d < dim; ++d)
      x[d] = 1.2;
    CHECK(of(shape, 1, x) == Verdict::invalid);
  }
}

TEST_CASE("a Jacobian that vanishes at a known place is told from one that nearly does")
{
  // y = v + 4 a u (1 - u) (1 - v) has the Jacobian 1 - 4 a u (1 - u), positive for a < 1, on shapes whose
  // space holds it; z as it is.
  for (const Shape shape : {Shape::quadrilateral, Shape::hexahedron})
    for (const double a : {0.5, 0.99, 0.9999, 1.0001, 1.5})
      CHECK(of(shape, 2,
               place_nodes(shape, 2,
                           [a](const Point& p) -> Point {
                             return {p[0], p[1] + 4.0 * a * p[0] * (1.0 - p[0]) * (1.0 - p[1]), p[2]};
                           })) == (a < 1.0 ? Verdict::valid : Verdict::invalid));
  // x = u - a u^2 has 1 - 2 a u, least at u = 1 and thus positive for a < 1/2.
  for (const Shape shape : cell_shapes)
    for (const int order : {2, 3})
      for (const double a : {0.3, 0.49, 0.4999, 0.5001, 0.6})
        CHECK(of(shape, order,
                 place_nodes(shape, order,
                             [a](const Point& p) -> Point {
                               return {p[0] - a * p[0] * p[0], p[1], p[2]};
                             })) == (a < 0.5 ? Verdict::valid : Verdict::invalid));
  // x = u - a z^2 u^2, of degree 4: 1 - 2 a u z^2 is least where u z^2 is largest, inside a slanted face of a
  // tetrahedron at u = 1/3, z = 2/3: 1 - 8 a / 27.
  for (const double a : {3.0, 3.37, 3.38, 4.0})
    CHECK(of(Shape::tetrahedron, 4,
             place_nodes(Shape::tetrahedron, 4,
                         [a](const Point& p) -> Point {
                           return {p[0] - a * p[2] * p[2] * p[0] * p[0], p[1], p[2]};
                         })) == (a < 3.375 ? Verdict::valid : Verdict::invalid));
}

TEST_CASE("a pyramid with any convex base is valid and one with a re-entrant corner is not")
{
  const auto with_corner = [](double at)
  {
    std::vector<double> x = place_nodes(Shape::pyramid, 1, same);
    x[9] = x[10] = at;  // corner 3 of the lattice is (1, 1)
    return x;
  };
  for (const double at : {0.51, 0.8, 1.0, 3.0})
    CHECK(of(Shape::pyramid, 1, with_corner(at)) == Verdict::valid);
  for (const double at : {0.49, 0.3, -1.0})
    CHECK(of(Shape::pyramid, 1, with_corner(at)) == Verdict::invalid);
}

TEST_CASE("a mesh of several shapes is certified as a whole")
{
  SampleMesh sample = separate_cells(
      Shape::quadrilateral, 2,
      {place_nodes(Shape::quadrilateral, 2, same), place_nodes(Shape::quadrilateral, 2, same)});
  SampleMesh triangles = separate_cells(
      Shape::triangle, 2, {place_nodes(Shape::triangle, 2, same), place_nodes(Shape::triangle, 2, same)});
  triangles.x[2 * 6] += 2.0;  // the first node of the second triangle
  mesh::Mesh& all = sample.mesh;
  all.runs.push_back({Shape::triangle, 2, 2, static_cast<std::int64_t>(all.cells.size())});
  for (const std::int32_t node : triangles.mesh.cells)
    all.cells.push_back(node + static_cast<std::int32_t>(all.local_node_count));
  all.local_node_count += triangles.mesh.local_node_count;
  all.cell_block = {0, 0, 1, 1};
  sample.x.insert(sample.x.end(), triangles.x.begin(), triangles.x.end());
  const mesh::Validity validity = mesh::certify(mesh::ValidityTables(all), all, sample.x);
  CHECK(validity.valid == 3);
  CHECK(validity.invalid == 1);
  CHECK(validity.cell == 3);
  CHECK(validity.block == 1);
  CHECK_THROWS_AS(mesh::certify(mesh::ValidityTables(2), all, sample.x), Error);
  all.dim = 3;
  CHECK_THROWS_AS(mesh::ValidityTables{all}, Error);
}
