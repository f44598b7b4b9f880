#include "run/locate.hpp"

#include "../mesh/structured.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

using namespace blockfsi;

namespace
{

using Point = std::array<double, 2>;

/// A quarter of a ring, 1 <= r <= 2.
Point ring(double a, double b)
{
  const double angle = 0.5 * std::numbers::pi * b;
  return {(1.0 + a) * std::cos(angle), (1.0 + a) * std::sin(angle)};
}

/// Where a point (a, b) of a cell's unit square is.
Point place(const SampleMesh& sample, std::size_t cell, double a, double b)
{
  const std::vector<double> nodes = element::lobatto(sample.mesh.order);
  const std::array<double, 2> at = {a, b};
  const element::Table table = element::lagrange(nodes, at);
  const int n = sample.mesh.order + 1;
  Point result{};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      for (int c = 0; c < 2; ++c)
        result[c] +=
            table.value[i] * table.value[n + j] * sample.x[2 * sample.mesh.cell(cell)[j * n + i] + c];
  return result;
}

double distance(const SampleMesh& sample, const run::Located& located, const Point& point)
{
  return std::hypot(located.value(sample.mesh, sample.x, 2, 0) - point[0],
                    located.value(sample.mesh, sample.x, 2, 1) - point[1]);
}

bool same(const std::optional<run::Located>& a, const std::optional<run::Located>& b)
{
  return a && b && a->cell == b->cell && a->shape == b->shape;
}

}  // namespace

TEST_CASE("a point within a curved cell is found there, at any order and whatever the cell's own axes")
{
  for (int order = 1; order <= 8; ++order)
    for (const SampleMesh& sample :
         {structured(order, 3, 2, ring, true), structured(order, 4, 4, waves, true)})
      for (std::size_t cell = 0; cell < sample.mesh.cell_count(); ++cell)
        for (const Point at : {Point{0.5, 0.5}, Point{0.03, 0.9}, Point{0.999, 0.002}, Point{0.7, 1e-5}})
        {
          const Point point = place(sample, cell, at[0], at[1]);
          const auto found = run::locate(sample.mesh, sample.x, point);
          CAPTURE(order);
          CAPTURE(cell);
          REQUIRE(found);
          CHECK(found->cell == cell);
          CHECK(distance(sample, *found, point) < 1e-12);
        }
}

TEST_CASE("a point outside of all cells is not found, however near")
{
  const SampleMesh sample = structured(3, 3, 2, ring);
  for (const Point point :
       {Point{0.0, 0.0}, Point{0.6, 0.6}, Point{0.9 * std::sqrt(0.5), 0.9 * std::sqrt(0.5)},
        Point{1.5, -1e-6}, Point{2.0 + 1e-6, 0.0}, Point{1.5, 1.5}, Point{5.0, 5.0}})
    CHECK_FALSE(run::locate(sample.mesh, sample.x, point));
}

TEST_CASE("every point of the outline is found")
{
  for (const int order : {1, 2, 5})
  {
    const SampleMesh sample = structured(order, 2, 3, ring);
    for (double t = 0.0; t <= 1.0; t += 1.0 / 64.0)
    {
      const std::array<Point, 4> points = {place(sample, 0, t, 0.0), place(sample, 1, 1.0, t),
                                           place(sample, 4, t, 1.0), place(sample, 2, 0.0, t)};
      for (const Point& point : points)
        CHECK(run::locate(sample.mesh, sample.x, point));
    }
  }
}

TEST_CASE("where cells meet the one of least number answers, whichever is tried first")
{
  const SampleMesh sample = structured(2, 4, 4, waves, true);
  // Corner of cells 0, 1, 4, 5; side between 5 and 6; side between 5 and 9.
  const std::vector<std::pair<Point, std::size_t>> meetings = {
      {waves(0.25, 0.25), 0}, {waves(0.5, 0.375), 5}, {waves(0.375, 0.5), 5}};
  for (const auto& [point, least] : meetings)
    for (std::size_t first = 0; first < sample.mesh.cell_count(); ++first)
    {
      const auto found = run::locate(sample.mesh, sample.x, point, first);
      REQUIRE(found);
      CHECK(found->cell == least);
    }
}

TEST_CASE("the cell that is tried first changes nothing, bit for bit")
{
  const SampleMesh sample = structured(4, 4, 4, waves, true);
  for (double a = 0.0; a <= 1.0; a += 0.0625)
    for (double b = 0.0; b <= 1.0; b += 0.0625)
    {
      const Point point = waves(a, b);
      const auto plain = run::locate(sample.mesh, sample.x, point);
      for (std::size_t first = 0; first <= sample.mesh.cell_count(); ++first)
        CHECK((same(run::locate(sample.mesh, sample.x, point, first), plain) || !plain));
    }
}

TEST_CASE("points of thin cells far from the origin are found, on their edges as well")
{
  // Cells of 1 x 1e-6 beside (300, 200), turned: round-off is 1e-7 of a cell.
  const auto map = [](double a, double b)
  {
    const double along = 8.0 * a;
    const double across = 4e-6 * b;
    return Point{300.0 + 0.8 * along - 0.6 * across, 200.0 + 0.6 * along + 0.8 * across};
  };
  const SampleMesh sample = structured(2, 8, 4, map);
  for (const double a : {0.0, 0.1, 0.25, 0.5, 1.0})
    for (const double b : {0.0, 0.2, 0.25, 0.5, 0.75, 1.0})
    {
      const Point point = map(a, b);
      const auto found = run::locate(sample.mesh, sample.x, point);
      CAPTURE(a);
      CAPTURE(b);
      REQUIRE(found);
      CHECK(distance(sample, *found, point) < 1e-12);
    }
}

TEST_CASE("a polynomial of the cell's order is evaluated exactly")
{
  const SampleMesh sample = structured(
      3, 2, 2,
      [](double a, double b) {
        return Point{a, b};
      },
      true);
  const auto cubic = [](const Point& p) { return 1.0 + p[0] * p[0] * p[1] - 2.0 * p[1] * p[1] * p[1]; };
  std::vector<double> field;
  for (std::size_t node = 0; node < sample.mesh.node_count(); ++node)
    field.insert(field.end(), {-1.0, cubic({sample.x[2 * node], sample.x[2 * node + 1]}), -1.0});
  for (const Point point : {Point{0.1, 0.2}, Point{0.77, 0.31}, Point{0.5, 0.9}})
    CHECK(run::locate(sample.mesh, sample.x, point)->value(sample.mesh, field, 3, 1) ==
          doctest::Approx(cubic(point)).epsilon(1e-13));
}

TEST_CASE("a finder gives what a search of all cells gives")
{
  const SampleMesh sample = structured(4, 6, 5, waves, true);
  run::Finder finder(sample.mesh, sample.x);
  for (double a = 0.0; a <= 1.0; a += 0.03125)
    for (double b = 0.0; b <= 1.0; b += 0.03125)
    {
      const run::Located found = finder.find(waves(a, b));
      CHECK(same(found, run::locate(sample.mesh, sample.x, waves(a, b))));
      CHECK(found.outside < 1e-9);
    }
}

TEST_CASE("a polynomial goes on beside the mesh, and far away the nearest node answers")
{
  const SampleMesh sample = structured(
      3, 4, 4,
      [](double a, double b) {
        return Point{2.0 * a, b};
      },
      true);
  run::Finder finder(sample.mesh, sample.x);
  const auto cubic = [](const Point& p) { return 1.0 + p[0] * p[0] * p[1] - 2.0 * p[1] * p[1] * p[1]; };
  std::vector<double> field;
  for (std::size_t node = 0; node < sample.mesh.node_count(); ++node)
    field.push_back(cubic({sample.x[2 * node], sample.x[2 * node + 1]}));
  // A cell is 0.5 x 0.25.
  for (const Point point : {Point{-0.04, 0.3}, Point{2.04, 1.02}, Point{1.2, -0.02}})
  {
    const run::Located found = finder.find(point);
    CHECK(found.outside == doctest::Approx(0.08));
    CHECK(found.value(sample.mesh, field, 1, 0) == doctest::Approx(cubic(point)).epsilon(1e-12));
  }
  CHECK(finder.find({-0.2, 0.25}).value(sample.mesh, field, 1, 0) == doctest::Approx(cubic({0.0, 0.25})));
  CHECK(finder.find({9.0, 8.0}).value(sample.mesh, field, 1, 0) == doctest::Approx(cubic({2.0, 1.0})));
}
