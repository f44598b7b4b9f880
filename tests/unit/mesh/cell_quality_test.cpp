#include "mesh/cell_quality.hpp"

#include "cells.hpp"
#include "core/error.hpp"
#include "mesh/quality.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace blockfsi;
using element::Point;
using element::Shape;
using mesh::CellQuality;

namespace
{

/// Takes the reference cell to the ideal one, all of whose edges have length 1.
Point ideal(Shape shape, const Point& p)
{
  const double height = std::sqrt(0.75);
  switch (shape)
  {
  case Shape::triangle:
  case Shape::prism:
    return {p[0] + 0.5 * p[1], height * p[1], p[2]};
  case Shape::tetrahedron:
    return {p[0] + 0.5 * p[1] + 0.5 * p[2], height * p[1] + height / 3.0 * p[2], std::sqrt(2.0 / 3.0) * p[2]};
  case Shape::pyramid:
    return {p[0] + 0.5 * p[2], p[1] + 0.5 * p[2], std::sqrt(0.5) * p[2]};
  default:
    return p;
  }
}

CellQuality of(Shape shape, int order, const PointMap& map)
{
  return mesh::measure(mesh::ShapeQuality(shape, order), place_nodes(shape, order, map));
}

}  // namespace

TEST_CASE("the ideal cell of every shape and order is perfect, wherever and however large it is")
{
  for (const Shape shape : cell_shapes)
    for (int order = 1; order <= 4; ++order)
    {
      const CellQuality quality = of(shape, order,
                                     [shape](const Point& p) -> Point
                                     {
                                       const Point q = ideal(shape, p);
                                       // Scaled, turned about the third axis and moved.
                                       return {3.0 * (0.6 * q[0] - 0.8 * q[1]) + 10.0,
                                               3.0 * (0.8 * q[0] + 0.6 * q[1]), 3.0 * q[2] - 5.0};
                                     });
      CHECK(quality.scaled_jacobian == doctest::Approx(1.0).epsilon(1e-11));
      CHECK(quality.jacobian_ratio == doctest::Approx(1.0).epsilon(1e-11));
      CHECK(quality.aspect_ratio == doctest::Approx(1.0).epsilon(1e-6));
      CHECK(quality.edge_ratio == doctest::Approx(1.0).epsilon(1e-12));
    }
}

TEST_CASE("angles of ideal cells are those of geometry books")
{
  const auto angles = [](Shape shape)
  {
    const CellQuality q = of(shape, 2, [shape](const Point& p) { return ideal(shape, p); });
    return std::array{q.smallest_angle, q.largest_angle};
  };
  const double degree = 180.0 / std::acos(-1.0);
  const double tetrahedron = std::acos(1.0 / 3.0) * degree;
  // Dihedral angles of the pyramid of equal edges: acos(1 / sqrt(3)) at the base, acos(-1 / 3) between
  // triangles.
  const double base = std::acos(1.0 / std::sqrt(3.0)) * degree;
  const double between = std::acos(-1.0 / 3.0) * degree;
  const std::array<std::array<double, 2>, 6> expected = {
      {{60, 60}, {90, 90}, {tetrahedron, tetrahedron}, {90, 90}, {60, 90}, {base, between}}};
  for (std::size_t s = 0; s < cell_shapes.size(); ++s)
    for (int k = 0; k < 2; ++k)
      CHECK(angles(cell_shapes[s])[k] == doctest::Approx(expected[s][k]).epsilon(1e-6));
}

TEST_CASE("a stretched cell has the aspect and edge ratio of its stretch and orthogonal grid lines")
{
  for (const Shape shape : {Shape::quadrilateral, Shape::hexahedron})
    for (const double stretch : {3.0, 1e6})
    {
      const CellQuality quality = of(shape, 3,
                                     [stretch](const Point& p) -> Point {
                                       return {stretch * p[0], p[1], p[2]};
                                     });
      CHECK(quality.scaled_jacobian == doctest::Approx(1.0));
      CHECK(quality.aspect_ratio == doctest::Approx(stretch).epsilon(1e-6));
      CHECK(quality.edge_ratio == doctest::Approx(stretch).epsilon(1e-10));
    }
}

TEST_CASE("a sheared hexahedron has the sine of its angle as scaled Jacobian and both angles")
{
  const double angle = std::acos(-1.0) / 6.0;
  const CellQuality quality = of(Shape::hexahedron, 2,
                                 [angle](const Point& p) -> Point {
                                   return {p[0] + p[2] * std::cos(angle), p[1], p[2] * std::sin(angle)};
                                 });
  CHECK(quality.scaled_jacobian == doctest::Approx(0.5));
  CHECK(quality.smallest_angle == doctest::Approx(30.0).epsilon(1e-8));
  CHECK(quality.largest_angle == doctest::Approx(150.0).epsilon(1e-8));
}

TEST_CASE("the ratio of Jacobians is that of a known map")
{
  // x = u + u^2 / 2 has the Jacobian 1 + u, from 1 to 2.
  for (const Shape shape : cell_shapes)
    CHECK(of(shape, 2,
             [](const Point& p) -> Point {
               return {p[0] + 0.5 * p[0] * p[0], p[1], p[2]};
             })
              .jacobian_ratio == doctest::Approx(0.5).epsilon(1e-12));
}

TEST_CASE("the edge ratio follows curved edges")
{
  // The lower side of a square as an arc of the parabola y = -u (1 - u), of length 1.1478 (the integral of
  // sqrt(1 + s^2) over -1 < s < 1, halved).
  const double arc = 0.5 * (std::sqrt(2.0) + std::asinh(1.0));
  const CellQuality quality = of(Shape::quadrilateral, 6,
                                 [](const Point& p) -> Point {
                                   return {p[0], p[1] - p[0] * (1.0 - p[0]) * (1.0 - p[1]), 0.0};
                                 });
  CHECK(quality.edge_ratio == doctest::Approx(arc).epsilon(1e-5));
}

TEST_CASE("a mirrored cell of any shape has a negative scaled Jacobian and an angle above 180 degrees")
{
  for (const Shape shape : cell_shapes)
  {
    const CellQuality quality = of(shape, 2, [](const Point& p) -> Point { return {-p[0], p[1], p[2]}; });
    CHECK(quality.scaled_jacobian < 0.0);
    CHECK(quality.largest_angle > 180.0);
  }
}

TEST_CASE("coordinates that are not finite are never taken for a good cell")
{
  for (const Shape shape : cell_shapes)
  {
    std::vector<double> x = place_nodes(shape, 2, [](const Point& p) { return p; });
    x[4] = std::numeric_limits<double>::quiet_NaN();
    CHECK(mesh::measure(mesh::ShapeQuality(shape, 2), x).scaled_jacobian == -1.0);
  }
}

TEST_CASE("quadrilaterals measured alone and as a mesh have the same quality")
{
  const SampleMesh sample = structured(3, 3, 2,
                                       [](double u, double v) {
                                         return std::array{u + 0.2 * v * v, v + 0.3 * u * v};
                                       });
  const mesh::QualityTables tables(sample.mesh);
  const mesh::Quality whole = mesh::measure(tables, sample.mesh, sample.x);
  std::vector<CellQuality> cells(6);
  mesh::measure_cells(tables, sample.mesh, sample.x, cells);
  CellQuality worst;
  for (const CellQuality& cell : cells)
  {
    worst.scaled_jacobian = std::min(worst.scaled_jacobian, cell.scaled_jacobian);
    worst.smallest_angle = std::min(worst.smallest_angle, cell.smallest_angle);
    worst.largest_angle = std::max(worst.largest_angle, cell.largest_angle);
  }
  CHECK(worst.scaled_jacobian == doctest::Approx(whole.scaled_jacobian).epsilon(1e-12));
  CHECK(worst.smallest_angle == doctest::Approx(whole.smallest_angle).epsilon(1e-12));
  CHECK(worst.largest_angle == doctest::Approx(whole.largest_angle).epsilon(1e-12));
}

TEST_CASE("a mesh of solids has the quality of its worst cell and its change from the first mesh")
{
  for (const Shape shape : cell_shapes)
  {
    const auto good = place_nodes(shape, 2, [shape](const Point& p) { return ideal(shape, p); });
    auto flat = good;
    const int dim = element::dimension(shape);
    for (std::size_t k = dim - 1; k < flat.size(); k += dim)
      flat[k] *= 0.5;
    const SampleMesh first = separate_cells(shape, 2, {good, good, good});
    const SampleMesh sample = separate_cells(shape, 2, {good, flat, good});
    const mesh::QualityTables tables(sample.mesh);
    const std::vector<double> before = mesh::sample_jacobian(tables, first.mesh, first.x);
    const mesh::Quality quality = mesh::measure(tables, sample.mesh, sample.x, before);
    CHECK(quality.smallest_change == doctest::Approx(0.5).epsilon(1e-11));
    CHECK(quality.largest_change == doctest::Approx(1.0).epsilon(1e-11));
    const CellQuality worst = mesh::measure(tables.of(shape), flat);
    CHECK(quality.scaled_jacobian == doctest::Approx(worst.scaled_jacobian).epsilon(1e-11));
    if (shape != Shape::quadrilateral && shape != Shape::hexahedron && shape != Shape::prism)
      CHECK(quality.cell == 1);
  }
}

TEST_CASE("a histogram counts every cell once")
{
  std::vector<CellQuality> cells(6);
  const std::array<double, 6> values = {-3.0, 0.0, 0.26, 0.5, 1.0, std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t c = 0; c < cells.size(); ++c)
    cells[c].scaled_jacobian = values[c];
  const mesh::Histogram result = mesh::histogram(cells, &CellQuality::scaled_jacobian, 0.0, 1.0, 4);
  CHECK(result.counts == std::vector<std::int64_t>{2, 1, 1, 2});
}

TEST_CASE("tables for one shape do not measure another, nor cells in a space of another dimension")
{
  SampleMesh sample =
      separate_cells(Shape::triangle, 2, {place_nodes(Shape::triangle, 2, [](const Point& p) { return p; })});
  CHECK_THROWS_AS(mesh::measure(mesh::QualityTables(2), sample.mesh, sample.x), Error);
  sample.mesh.dim = 3;
  CHECK_THROWS_AS(mesh::QualityTables{sample.mesh}, Error);
}
