#include "mesh/validity.hpp"

#include "element/line.hpp"
#include "structured.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace blockfsi;

namespace
{

/// Nodes of the unit square at the Gauss-Lobatto-Legendre points.
std::vector<double> square(int order)
{
  const std::vector<double> line = element::lobatto(order);
  std::vector<double> x;
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i <= order; ++i)
      x.insert(x.end(), {line[i], line[j]});
  return x;
}

/// Quadratic cell with the middle of its lower and right sides moved inwards by a.
std::vector<double> pinched(double a)
{
  std::vector<double> x = square(2);
  x[2 * 1 + 1] += a;
  x[2 * 5] -= a;
  return x;
}

/// The lower side raised towards the upper one, y = v + 4 a u (1 - u) (1 - v): the Jacobian is 1 - 4 a u (1 -
/// u).
std::vector<double> bulged(int order, double a)
{
  std::vector<double> x = square(order);
  for (std::size_t k = 0; k < x.size(); k += 2)
    x[k + 1] += (1.0 - x[k + 1]) * a * 4.0 * x[k] * (1.0 - x[k]);
  return x;
}

std::vector<double> equispaced(int n)
{
  std::vector<double> points(n);
  for (int q = 0; q < n; ++q)
    points[q] = q / (n - 1.0);
  return points;
}

/// Least Jacobian at a lattice of points, by Lagrange functions: independent of the code under test.
double least_jacobian(int order, const std::vector<double>& x, const std::vector<double>& points)
{
  const int n = static_cast<int>(points.size());
  const element::Table table = element::lagrange(element::lobatto(order), points);
  double minimum = std::numeric_limits<double>::infinity();
  for (int r = 0; r < n; ++r)
    for (int q = 0; q < n; ++q)
    {
      std::array<double, 4> gradient{};
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i)
        {
          const double along_xi = table.first[q * (order + 1) + i] * table.value[r * (order + 1) + j];
          const double along_eta = table.value[q * (order + 1) + i] * table.first[r * (order + 1) + j];
          for (int d = 0; d < 2; ++d)
          {
            gradient[d] += along_xi * x[2 * (i + j * (order + 1)) + d];
            gradient[2 + d] += along_eta * x[2 * (i + j * (order + 1)) + d];
          }
        }
      minimum = std::min(minimum, gradient[0] * gradient[3] - gradient[1] * gradient[2]);
    }
  return minimum;
}

}  // namespace

TEST_CASE("a quadratic cell with both middle nodes moved in by a is invalid from a = 1/4 on")
{
  const mesh::ValidityTables tables(2);
  for (const double a : {0.0, 0.1, 0.2, 0.22, 0.24, 0.249, 0.2499999})
    CHECK(mesh::certify(tables, pinched(a)) == mesh::Verdict::valid);
  for (const double a : {0.2500001, 0.251, 0.26, 0.3})
    CHECK(mesh::certify(tables, pinched(a)) == mesh::Verdict::invalid);
  CHECK(mesh::certify(tables, pinched(0.25)) != mesh::Verdict::valid);
}

TEST_CASE("the verdict on random cells is that of dense sampling")
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int valid = 0;
  int hidden = 0;
  for (int trial = 0; trial < 3000; ++trial)
  {
    const int order = 2 + trial % 3;
    std::vector<double> x = square(order);
    for (double& coordinate : x)
      coordinate += normal(random) * 0.12 / order;
    const mesh::Verdict verdict = mesh::certify(mesh::ValidityTables(order), x);
    const double minimum = least_jacobian(order, x, equispaced(41));
    CHECK(verdict != mesh::Verdict::undecided);
    if (verdict == mesh::Verdict::valid)
      CHECK(minimum > 0.0);
    else
      CHECK(minimum < 0.02);
    valid += verdict == mesh::Verdict::valid;
    hidden += verdict == mesh::Verdict::invalid && minimum > 0.0;
  }
  // The sample must hold enough of both kinds to mean something.
  CHECK(valid > 500);
  CHECK(valid < 2500);
  CHECK(hidden < 30);
}

TEST_CASE("an inversion that no Gauss point sees is found")
{
  const std::vector<double> x = pinched(0.26);
  CHECK(least_jacobian(2, x, element::gauss(3).points) > 0.2);
  CHECK(least_jacobian(2, x, {0.0, 1.0}) < 0.0);
  CHECK(mesh::certify(mesh::ValidityTables(2), x) == mesh::Verdict::invalid);
}

TEST_CASE("an inversion that neither corners nor Gauss points see is found")
{
  const std::vector<double> x = bulged(2, 1.02);
  CHECK(least_jacobian(2, x, {0.0, 1.0}) > 0.5);
  CHECK(least_jacobian(2, x, element::gauss(2).points) > 0.1);
  CHECK(least_jacobian(2, x, equispaced(101)) < 0.0);
  CHECK(mesh::certify(mesh::ValidityTables(2), x) == mesh::Verdict::invalid);
}

TEST_CASE("straight cells of every order are valid however thin, small, far away or turned")
{
  for (int order = 1; order <= mesh::max_order; ++order)
  {
    const mesh::ValidityTables tables(order);
    for (const double thin : {1.0, 1e-3, 1e-5})
      for (const double size : {1.0, 1e-9, 1e9})
        for (const double angle : {0.0, 0.7, 2.0})
        {
          std::vector<double> x = square(order);
          for (std::size_t k = 0; k < x.size(); k += 2)
          {
            const double u = size * x[k];
            const double v = size * thin * x[k + 1];
            x[k] = u * std::cos(angle) - v * std::sin(angle) + 10.0 * size;
            x[k + 1] = u * std::sin(angle) + v * std::cos(angle) - 5.0 * size;
          }
          CHECK(mesh::certify(tables, x) == mesh::Verdict::valid);
        }
  }
}

TEST_CASE("a mirrored cell and a collapsed cell of every order are invalid")
{
  for (int order = 1; order <= mesh::max_order; ++order)
  {
    const mesh::ValidityTables tables(order);
    std::vector<double> mirrored = square(order);
    std::vector<double> collapsed = mirrored;
    for (std::size_t k = 0; k < mirrored.size(); k += 2)
    {
      mirrored[k] = -mirrored[k];
      collapsed[k + 1] = 0.3 * collapsed[k];
    }
    CHECK(mesh::certify(tables, mirrored) == mesh::Verdict::invalid);
    CHECK(mesh::certify(tables, collapsed) == mesh::Verdict::invalid);
  }
}

TEST_CASE("cells of high order are certified up to a Jacobian that nearly vanishes inside")
{
  for (int order = 2; order <= mesh::max_order; ++order)
  {
    const mesh::ValidityTables tables(order);
    for (const double a : {0.5, 0.9, 0.99, 0.9999, 1.0001, 1.01, 2.0})
      CHECK(mesh::certify(tables, bulged(order, a)) ==
            (a < 1.0 ? mesh::Verdict::valid : mesh::Verdict::invalid));
    CHECK(mesh::certify(tables, bulged(order, 1.0)) != mesh::Verdict::valid);
  }
}

TEST_CASE("coordinates that are not finite are invalid")
{
  std::vector<double> x = square(3);
  x[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK(mesh::certify(mesh::ValidityTables(3), x) == mesh::Verdict::invalid);
}

TEST_CASE("the first cell of a mesh that is not valid is named, and all are counted")
{
  SampleMesh sample = structured(
      2, 5, 2,
      [](double u, double v) {
        return std::array{u, v};
      },
      true);
  const mesh::ValidityTables tables(2);
  CHECK(mesh::certify(tables, sample.mesh, sample.x).all_valid());
  for (const int cell : {8, 7})
    sample.x[2 * sample.mesh.cell(cell)[4]] += 0.2;
  std::vector<mesh::Verdict> verdicts(sample.mesh.cell_count());
  const mesh::Validity validity = mesh::certify(tables, sample.mesh, sample.x, verdicts);
  CHECK(validity.invalid == 2);
  CHECK(validity.valid == 8);
  CHECK(validity.cell == 7);
  CHECK(validity.block == 1);
  CHECK(std::count(verdicts.begin(), verdicts.end(), mesh::Verdict::invalid) == 2);
  CHECK(verdicts[7] == mesh::Verdict::invalid);
  CHECK_FALSE(validity.all_valid());
}

TEST_CASE("verdicts merged from parts count all cells and name the lowest")
{
  const mesh::Validity a{10, 1, 0, 12, 3};
  const mesh::Validity b{20, 0, 2, 4, 1};
  for (const mesh::Validity& merged : {mesh::merge(a, b), mesh::merge(b, a)})
  {
    CHECK(merged.valid == 30);
    CHECK(merged.invalid == 1);
    CHECK(merged.undecided == 2);
    CHECK(merged.cell == 4);
    CHECK(merged.block == 1);
  }
  CHECK(mesh::merge(mesh::Validity{}, a).cell == 12);
  CHECK(mesh::merge(a, mesh::Validity{}).cell == 12);
}
