#include "mesh/quality.hpp"

#include "core/error.hpp"
#include "structured.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace blockfsi;

namespace
{

std::array<double, 2> same(double u, double v)
{
  return {u, v};
}

}  // namespace

TEST_CASE("a rectangle is perfect whatever its order, size and aspect ratio")
{
  for (int order = 1; order <= mesh::max_order; ++order)
  {
    const SampleMesh sample = structured(
        order, 3, 2,
        [](double u, double v) {
          return std::array{1e-2 * u, 1e2 * v};
        },
        true);
    const mesh::QualityTables tables(order);
    const mesh::Quality quality = mesh::measure(tables, sample.mesh, sample.x);
    CHECK(quality.scaled_jacobian == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(quality.smallest_angle == doctest::Approx(90.0).epsilon(1e-8));
    CHECK(quality.largest_angle == doctest::Approx(90.0).epsilon(1e-8));
  }
}

TEST_CASE("a parallelogram has the sine of its angle as scaled Jacobian")
{
  const double angle = 30.0 * std::numbers::pi / 180.0;
  for (const int order : {1, 3, 8})
  {
    const SampleMesh sample = structured(
        order, 2, 2,
        [angle](double u, double v) {
          return std::array{u + v * std::cos(angle), v * std::sin(angle)};
        },
        true);
    const mesh::Quality quality = mesh::measure(mesh::QualityTables(order), sample.mesh, sample.x);
    CHECK(quality.scaled_jacobian == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(quality.smallest_angle == doctest::Approx(30.0).epsilon(1e-12));
    CHECK(quality.largest_angle == doctest::Approx(150.0).epsilon(1e-12));
  }
}

TEST_CASE("an angle above 180 degrees and its negative scaled Jacobian mark a cell with a re-entrant corner")
{
  SampleMesh sample = structured(1, 1, 1, same);
  sample.x[6] = 0.25;
  sample.x[7] = 0.25;
  const mesh::Quality quality = mesh::measure(mesh::QualityTables(1), sample.mesh, sample.x);
  // At the moved corner the edges run to (1, 0) and (0, 1).
  const double beyond = std::atan2(0.25, 0.75) * 180.0 / std::numbers::pi;
  CHECK(quality.largest_angle == doctest::Approx(270.0 - 2.0 * beyond).epsilon(1e-12));
  CHECK(quality.largest_angle > 180.0);
  CHECK(quality.scaled_jacobian ==
        doctest::Approx(std::sin(quality.largest_angle * std::numbers::pi / 180.0)).epsilon(1e-12));
}

TEST_CASE("the worst cell is named with its number and block")
{
  SampleMesh sample = structured(2, 4, 3, same);
  const mesh::QualityTables tables(2);
  const std::int32_t middle = sample.mesh.cell(6)[4];
  sample.x[2 * middle] += 0.03;
  const mesh::Quality quality = mesh::measure(tables, sample.mesh, sample.x);
  CHECK(quality.cell == 6);
  CHECK(quality.block == 1);
  CHECK(quality.scaled_jacobian < 0.99);
}

TEST_CASE("the change of the mesh is the determinant of an affine deformation")
{
  const auto wavy = [](double u, double v) {
    return std::array{u + 0.05 * std::sin(6.0 * v), v + 0.05 * std::sin(5.0 * u)};
  };
  const SampleMesh first = structured(4, 3, 3, wavy);
  const mesh::QualityTables tables(4);
  const std::vector<double> jacobian = mesh::sample_jacobian(tables, first.mesh, first.x);
  std::vector<double> x = first.x;
  for (std::size_t node = 0; node < first.mesh.node_count(); ++node)
  {
    x[2 * node] = 3.0 * first.x[2 * node] + 0.5 * first.x[2 * node + 1] + 7.0;
    x[2 * node + 1] = 0.5 * first.x[2 * node + 1];
  }
  const mesh::Quality quality = mesh::measure(tables, first.mesh, x, jacobian);
  CHECK(quality.smallest_change == doctest::Approx(1.5).epsilon(1e-12));
  CHECK(quality.largest_change == doctest::Approx(1.5).epsilon(1e-12));
}

TEST_CASE("samples see what happens between the nodes of linear and quadratic cells")
{
  // The corners of this quadratic cell are right angles; only inside does its side come near the opposite
  // one.
  SampleMesh sample = structured(2, 1, 1, same);
  sample.x[2 * 1 + 1] = 0.2;
  const mesh::Quality quality = mesh::measure(mesh::QualityTables(2), sample.mesh, sample.x);
  CHECK(quality.scaled_jacobian < 0.8);
  CHECK(quality.scaled_jacobian > 0.0);
}

TEST_CASE("quality merged from parts in any order is that of the whole")
{
  const SampleMesh sample = structured(3, 4, 4,
                                       [](double u, double v) {
                                         return std::array{u + 0.2 * v * v, v + 0.3 * u * v};
                                       });
  const mesh::QualityTables tables(3);
  const mesh::Quality whole = mesh::measure(tables, sample.mesh, sample.x);
  std::vector<mesh::Quality> parts(4);
  for (int part = 0; part < 4; ++part)
  {
    mesh::Mesh own = sample.mesh;
    own.cells.assign(sample.mesh.cells.begin() + part * 64, sample.mesh.cells.begin() + (part + 1) * 64);
    own.runs[0].count = 4;
    own.cell_block.assign(4, part);
    own.cell_number = {4 * part, 4 * part + 1, 4 * part + 2, 4 * part + 3};
    parts[part] = mesh::measure(tables, own, sample.x);
  }
  mesh::Quality forward;
  mesh::Quality backward;
  for (int part = 0; part < 4; ++part)
  {
    forward = mesh::merge(forward, parts[part]);
    backward = mesh::merge(parts[3 - part], backward);
  }
  for (const mesh::Quality& merged : {forward, backward})
  {
    CHECK(merged.scaled_jacobian == whole.scaled_jacobian);
    CHECK(merged.smallest_angle == whole.smallest_angle);
    CHECK(merged.largest_angle == whole.largest_angle);
    CHECK(merged.cell == whole.cell);
    CHECK(merged.block == whole.block);
  }
}

TEST_CASE("of equally bad cells the lowest number is named in any order of merging")
{
  mesh::Quality a;
  a.scaled_jacobian = 1.0;
  a.cell = 5;
  mesh::Quality b = a;
  b.cell = 3;
  CHECK(mesh::merge(a, b).cell == 3);
  CHECK(mesh::merge(b, a).cell == 3);
  CHECK(mesh::merge(a, mesh::Quality{}).cell == 5);
  CHECK(mesh::merge(mesh::Quality{}, a).cell == 5);
}

TEST_CASE("coordinates that are not finite are never taken for a good mesh")
{
  SampleMesh sample = structured(3, 3, 1, same);
  sample.x[2 * sample.mesh.cell(1)[5]] = std::numeric_limits<double>::quiet_NaN();
  const mesh::Quality quality = mesh::measure(mesh::QualityTables(3), sample.mesh, sample.x);
  CHECK(quality.scaled_jacobian == -1.0);
  CHECK(quality.cell == 1);
}

TEST_CASE("orders outside 1 to 8 are refused")
{
  CHECK_THROWS_WITH_AS(mesh::QualityTables(9), "the order of the mesh is 9; choose an order from 1 to 8",
                       Error);
  CHECK_THROWS_AS(mesh::QualityTables(0), Error);
}
