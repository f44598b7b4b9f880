#include "mesh/convert.hpp"

#include "core/error.hpp"
#include "linear.hpp"
#include "mesh/split.hpp"
#include "mesh/validity.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

using namespace blockfsi;
using element::Shape;
using mesh::Conversion;
using mesh::Converted;
using mesh::Target;

namespace
{

/// Raised to an order, then bent by polynomials of degree 2, which every space of order 2 holds.
SampleMesh curved(const SampleMesh& straight, int order)
{
  Converted raised = mesh::convert(straight.mesh, straight.x, {Target::same, order, {}});
  const int dim = straight.mesh.dim;
  for (std::size_t n = 0; order > 1 && n < raised.mesh.node_count(); ++n)
  {
    double* const p = &raised.x[dim * n];
    const double u = p[0];
    const double v = p[1];
    const double w = dim == 3 ? p[2] : 0.0;
    p[0] += 0.06 * v * v - 0.04 * w * u;
    p[1] += 0.05 * u * u + 0.03 * w * w;
    if (dim == 3)
      p[2] += 0.05 * u * v;
  }
  return {raised.mesh, raised.x};
}

/// Every inner side belongs to two cells, and the boundary "outer" is what belongs to one.
void check_conformity(const mesh::Mesh& made)
{
  auto counts = count_sides(made);
  std::size_t outer = 0;
  for (const auto& [nodes, count] : counts)
  {
    CHECK(count <= 2);
    outer += count == 1;
  }
  CHECK(made.boundaries.at("outer").size() == outer);
  for (const mesh::Side& side : made.boundaries.at("outer"))
  {
    std::vector<std::int32_t> nodes = side_nodes(made, side);
    std::sort(nodes.begin(), nodes.end());
    CHECK(counts.at(nodes) == 1);
  }
}

void check_sizes(const Converted& made)
{
  const mesh::Mesh& m = made.mesh;
  CHECK(m.node_count() * m.dim == made.x.size());
  CHECK(made.parent.size() == m.cell_count());
  std::vector<bool> used(m.node_count(), false);
  for (const std::int32_t node : m.cells)
    used.at(node) = true;
  CHECK(std::count(used.begin(), used.end(), false) == 0);
  // No two nodes at one place.
  std::vector<std::array<double, 3>> points;
  for (std::size_t n = 0; n < m.node_count(); ++n)
  {
    std::array<double, 3> point{};
    for (int d = 0; d < m.dim; ++d)
      point[d] = std::round(1e9 * made.x[m.dim * n + d]);
    points.push_back(point);
  }
  std::sort(points.begin(), points.end());
  CHECK(std::adjacent_find(points.begin(), points.end()) == points.end());
}

/// Converts and checks all that must hold.
Converted checked(const SampleMesh& sample, Target to, Shape shape, int order = 0)
{
  Converted made = mesh::convert(sample.mesh, sample.x, {to, order, {}});
  CHECK(made.mesh.is_all(shape));
  check_sizes(made);
  check_conformity(made.mesh);
  CHECK(volume(made.mesh, made.x) == doctest::Approx(volume(sample.mesh, sample.x)).epsilon(1e-12));
  CHECK(mesh::certify(mesh::ValidityTables(made.mesh), made.mesh, made.x).all_valid());
  for (std::size_t c = 0; c < made.mesh.cell_count(); ++c)
    CHECK(made.mesh.cell_block[c] == sample.mesh.cell_block[made.parent[c]]);
  return made;
}

SampleMesh squares(int order)
{
  return curved(linear_mesh(2, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
                            {{Shape::quadrilateral, {0, 1, 4, 3}}, {Shape::quadrilateral, {4, 1, 2, 5}}}),
                order);
}

}  // namespace

TEST_CASE("quadrilaterals become two or four triangles each, of any order")
{
  for (int order = 1; order <= 4; ++order)
  {
    CHECK(checked(squares(order), Target::triangles, Shape::triangle).mesh.cell_count() == 4);
    CHECK(checked(squares(order), Target::triangles_with_centres, Shape::triangle).mesh.cell_count() == 8);
    CHECK(checked(curved(mixed_faces(), order), Target::triangles, Shape::triangle).mesh.cell_count() == 7);
  }
}

TEST_CASE("triangles become three quadrilaterals each, quadrilaterals beside them four")
{
  for (int order = 1; order <= 4; ++order)
    CHECK(checked(curved(mixed_faces(), order), Target::quadrilaterals, Shape::quadrilateral)
              .mesh.cell_count() == 17);
  CHECK(checked(squares(2), Target::quadrilaterals, Shape::quadrilateral).mesh.cell_count() == 2);
}

TEST_CASE("cells of every shape become tetrahedra")
{
  for (int order = 1; order <= 4; ++order)
  {
    const Converted made = checked(curved(mixed_solids(), order), Target::tetrahedra, Shape::tetrahedron);
    const auto hexahedron = std::count(made.parent.begin(), made.parent.end(), 0);
    CHECK((hexahedron == 5 || hexahedron == 6));
    CHECK(static_cast<long>(made.mesh.cell_count()) == hexahedron + 6 * 2 + 2 * 3 + 1);
    checked(curved(cubes(), order), Target::tetrahedra, Shape::tetrahedron);
  }
}

TEST_CASE("tetrahedra become four hexahedra each, prisms six, hexahedra beside them eight")
{
  for (int order = 1; order <= 3; ++order)
  {
    SampleMesh solids = mixed_solids();
    const SampleMesh bent = curved(solids, order);
    const Converted tetrahedra = mesh::convert(bent.mesh, bent.x, {Target::tetrahedra, 0, {}});
    const SampleMesh all_tetrahedra = {tetrahedra.mesh, tetrahedra.x};
    CHECK(checked(all_tetrahedra, Target::hexahedra, Shape::hexahedron).mesh.cell_count() ==
          4 * tetrahedra.mesh.cell_count());
  }
  const SampleMesh whole = cubes();
  CHECK(checked(curved(whole, 2), Target::hexahedra, Shape::hexahedron).mesh.cell_count() == 8);
  // A cube, two prisms and a tetrahedron.
  std::vector<std::array<double, 3>> points = cube_points(2, 1, 1);
  points.push_back({1.5, 0.4, 1.8});
  const std::vector<int> a = cube_corners(2, 1, 0, 0, 0);
  const std::vector<int> c = cube_corners(2, 1, 1, 0, 0);
  const SampleMesh mixed = linear_mesh(3, points,
                                       {{Shape::hexahedron, a},
                                        {Shape::prism, {c[0], c[1], c[2], c[4], c[5], c[6]}},
                                        {Shape::prism, {c[0], c[2], c[3], c[4], c[6], c[7]}},
                                        {Shape::tetrahedron, {c[4], c[5], c[6], 12}}});
  for (int order = 1; order <= 3; ++order)
    CHECK(checked(curved(mixed, order), Target::hexahedra, Shape::hexahedron).mesh.cell_count() == 24);
}

TEST_CASE("hexahedra become conforming tetrahedra for every numbering of their corners")
{
  std::mt19937 random(7);
  const SampleMesh whole = cubes();
  int five = 0;
  int six = 0;
  for (int trial = 0; trial < 40; ++trial)
  {
    std::vector<std::int32_t> number(whole.mesh.node_count());
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    SampleMesh shuffled = whole;
    for (std::int32_t& node : shuffled.mesh.cells)
      node = number[node];
    for (std::size_t n = 0; n < number.size(); ++n)
      for (int d = 0; d < 3; ++d)
        shuffled.x[3 * number[n] + d] = whole.x[3 * n + d];
    const Converted made = checked(shuffled, Target::tetrahedra, Shape::tetrahedron);
    for (int c = 0; c < 8; ++c)
    {
      const auto count = std::count(made.parent.begin(), made.parent.end(), c);
      five += count == 5;
      six += count == 6;
    }
  }
  CHECK(five + six == 320);
  CHECK(five > 20);
  CHECK(six > 160);
}

TEST_CASE("a mesh raised in order and lowered again has the same nodes in the same places")
{
  for (const SampleMesh& sample : {mixed_faces(), mixed_solids()})
    for (int low = 1; low <= 3; ++low)
    {
      const SampleMesh bent = curved(sample, low);
      const Converted up = mesh::convert(bent.mesh, bent.x, {Target::same, low + 2, {}});
      check_sizes(up);
      check_conformity(up.mesh);
      CHECK(volume(up.mesh, up.x) == doctest::Approx(volume(bent.mesh, bent.x)).epsilon(1e-12));
      CHECK(up.mesh.runs.size() == bent.mesh.runs.size());
      const Converted down = mesh::convert(up.mesh, up.x, {Target::same, low, {}});
      CHECK(down.mesh.cells == bent.mesh.cells);
      CHECK(down.mesh.boundaries == bent.mesh.boundaries);
      double error = 0.0;
      for (std::size_t m = 0; m < bent.x.size(); ++m)
        error = std::max(error, std::abs(down.x[m] - bent.x[m]));
      CHECK(error < 1e-14);
    }
}

TEST_CASE("conversion to the same order keeps every coordinate bit for bit")
{
  const SampleMesh bent = curved(mixed_solids(), 3);
  const Converted same = mesh::convert(bent.mesh, bent.x, {});
  REQUIRE(same.mesh.node_count() == bent.mesh.node_count());
  for (std::size_t m = 0; m < bent.mesh.cells.size(); ++m)
    for (int d = 0; d < 3; ++d)
      CHECK(same.x[3 * same.mesh.cells[m] + d] == bent.x[3 * bent.mesh.cells[m] + d]);
}

TEST_CASE("each new boundary node is moved to the true boundary once, old and inner ones stay")
{
  // The unit square blown up to a disc of which only the corners of cells lie on the circle.
  const double s = std::sqrt(0.5);
  const SampleMesh square = linear_mesh(2, {{-s, -s, 0}, {s, -s, 0}, {s, s, 0}, {-s, s, 0}},
                                        {{Shape::quadrilateral, {0, 1, 2, 3}}});
  int calls = 0;
  const auto project = [&calls](std::string_view name, std::span<double> x)
  {
    ++calls;
    CHECK(name == "outer");
    const double radius = std::hypot(x[0], x[1]);
    CHECK(radius < 1.0);
    x[0] /= radius;
    x[1] /= radius;
  };
  for (const Target to : {Target::same, Target::triangles})
  {
    calls = 0;
    const Converted disc = mesh::convert(square.mesh, square.x, {to, 4, project});
    CHECK(calls == 12);
    for (const mesh::Side& side : disc.mesh.boundaries.at("outer"))
      for (const std::int32_t node : side_nodes(disc.mesh, side))
        CHECK(std::hypot(disc.x[2 * node], disc.x[2 * node + 1]) == doctest::Approx(1.0).epsilon(1e-14));
    // Sides of order 4 that interpolate quarters of the circle.
    CHECK(volume(disc.mesh, disc.x) == doctest::Approx(std::numbers::pi).epsilon(2e-3));
  }
}

TEST_CASE("two arcs between the same corners are not mixed up")
{
  // An annulus of two cells: both have the same corners.
  const double half = std::numbers::pi;
  SampleMesh ring;
  ring.mesh.order = 3;
  const std::vector<double> line = element::lobatto(3);
  for (int r = 0; r < 4; ++r)
    for (int a = 0; a < 6; ++a)
    {
      const double angle = half * (a / 3 + line[a % 3]);
      ring.x.insert(ring.x.end(), {(2.0 - line[r]) * std::cos(angle), (2.0 - line[r]) * std::sin(angle)});
    }
  for (int cell = 0; cell < 2; ++cell)
    for (int r = 0; r < 4; ++r)
      for (int a = 0; a < 4; ++a)
        ring.mesh.cells.push_back(6 * r + (3 * cell + a) % 6);
  ring.mesh.runs = {{Shape::quadrilateral, 0, 2, 0}};
  ring.mesh.cell_block = {0, 0};
  ring.mesh.local_node_count = 24;
  ring.mesh.total_cell_count = 2;
  for (int cell = 0; cell < 2; ++cell)
    for (const int side : {0, 2})
      ring.mesh.boundaries["outer"].push_back({cell, side});
  const Converted up = mesh::convert(ring.mesh, ring.x, {Target::same, 5, {}});
  CHECK(up.mesh.node_count() == 60);
  check_conformity(up.mesh);
  CHECK(volume(up.mesh, up.x) == doctest::Approx(volume(ring.mesh, ring.x)).epsilon(1e-12));
  const Converted triangles = mesh::convert(ring.mesh, ring.x, {Target::triangles, 0, {}});
  check_conformity(triangles.mesh);
  CHECK(volume(triangles.mesh, triangles.x) == doctest::Approx(volume(ring.mesh, ring.x)).epsilon(1e-12));
}

TEST_CASE("what cannot be converted is refused")
{
  const SampleMesh solids = mixed_solids();
  const SampleMesh faces = mixed_faces();
  CHECK_THROWS_AS(mesh::convert(solids.mesh, solids.x, {Target::hexahedra, 0, {}}), Error);
  CHECK_THROWS_AS(mesh::convert(solids.mesh, solids.x, {Target::triangles, 0, {}}), Error);
  CHECK_THROWS_AS(mesh::convert(faces.mesh, faces.x, {Target::tetrahedra, 0, {}}), Error);
  CHECK_THROWS_AS(mesh::convert(faces.mesh, faces.x, {Target::same, 9, {}}), Error);
  CHECK_THROWS_AS(mesh::convert(faces.mesh, std::span(faces.x).first(4), {}), Error);
  mesh::Mesh part = faces.mesh;
  part.total_cell_count = 100;
  CHECK_THROWS_AS(mesh::convert(part, faces.x, {}), Error);
}
