#include "element/table.hpp"

#include "core/error.hpp"
#include "shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace blockfsi::element;

namespace
{

constexpr std::array<std::array<int, 2>, 6> pairs = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

using Function = std::function<double(const Point&)>;

/// Functions that span the space of a cell, in no numerically good way, but simple to read.
std::vector<Function> space(Shape shape, int order)
{
  std::vector<Function> functions;
  const auto add = [&](int i, int j, int k)
  {
    functions.emplace_back([=](const Point& x)
                           { return std::pow(x[0], i) * std::pow(x[1], j) * std::pow(x[2], k); });
  };
  for (const auto [i, j, k] : lattice_points(shape == Shape::pyramid ? Shape::hexahedron : shape, order))
  {
    if (shape != Shape::pyramid)
      add(i, j, k);
    else if (std::max(i, j) + k <= order)
      functions.emplace_back(
          [=](const Point& x)
          {
            const double h = 1.0 - x[2];
            return std::pow(x[0] / h, i) * std::pow(x[1] / h, j) * std::pow(h, std::max(i, j)) *
                   std::pow(x[2], k);
          });
  }
  return functions;
}

}  // namespace

TEST_CASE("each Lagrange function is 1 at its node and 0 at the others")
{
  for (const Shape shape : all_shapes)
    for (int order = 1; order <= 8; ++order)
    {
      const CellTable table = tabulate(shape, order, nodes(shape, order), 0);
      REQUIRE(table.point_count == table.node_count);
      double error = 0.0;
      for (int q = 0; q < table.point_count; ++q)
        for (int n = 0; n < table.node_count; ++n)
          error = std::max(error, std::abs(table.value[q * table.node_count + n] - (q == n ? 1.0 : 0.0)));
      CHECK(error < 1e-12);
    }
}

TEST_CASE("Lagrange functions reproduce every function of the space of their cell")
{
  for (const Shape shape : all_shapes)
    for (const int order : {1, 2, 3, 5, 8})
    {
      std::vector<Point> at = nodes(shape, order);
      const std::vector<Point> points = inner_points(shape);
      const CellTable table = tabulate(shape, order, points, 0);
      const std::vector<Function> functions = space(shape, order);
      REQUIRE(functions.size() == at.size());
      if (shape ==
          Shape::pyramid)  // rational functions have a limit at the apex, along the axis for instance
        at[lattice_index(shape, order, {0, 0, order})] = {0.5e-14, 0.5e-14, 1.0 - 1e-14};
      double error = 0.0;
      for (const Function& f : functions)
        for (std::size_t q = 0; q < points.size(); ++q)
        {
          double sum = -f(points[q]);
          for (std::size_t n = 0; n < at.size(); ++n)
            sum += table.value[q * at.size() + n] * f(at[n]);
          error = std::max(error, std::abs(sum));
        }
      CHECK(error < 1e-12);
    }
}

TEST_CASE("Lagrange functions sum to 1 and their derivatives to 0, at the apex too")
{
  for (const Shape shape : all_shapes)
    for (const int order : {1, 4, 8})
    {
      std::vector<Point> points = inner_points(shape);
      points.insert(points.end(), corners(shape).begin(), corners(shape).end());
      const CellTable table = tabulate(shape, order, points, 2);
      const auto sum = [&](const std::vector<double>& matrix, int q)
      {
        double result = 0.0;
        for (int n = 0; n < table.node_count; ++n)
          result += matrix[q * table.node_count + n];
        return result;
      };
      for (int q = 0; q < table.point_count; ++q)
      {
        CHECK(std::abs(sum(table.value, q) - 1.0) < 1e-12);
        for (int d = 0; d < dimension(shape); ++d)
          CHECK(std::abs(sum(table.first[d], q)) < 1e-10);
        for (int p = 0; p < 6; ++p)
          if (pairs[p][1] < dimension(shape))
            CHECK(std::abs(sum(table.second[p], q)) < 1e-7);
      }
    }
}

TEST_CASE("on a side only its own nodes count, with the functions of its own shape")
{
  for (const Shape shape : all_shapes)
    for (const int order : {1, 2, 3, 6, 8})
      for (int side = 0; side < static_cast<int>(sides(shape).size()); ++side)
      {
        const Shape of_side = sides(shape)[side].shape;
        const std::vector<Point> points = inner_points(of_side);
        std::vector<Point> in_cell;
        for (const Point& point : points)
          in_cell.push_back(on_side(shape, side, point));
        const CellTable cell = tabulate(shape, order, in_cell, 0);
        const CellTable own = tabulate(of_side, order, points, 0);
        std::vector<double> expected(cell.value.size(), 0.0);
        const std::vector<std::int32_t> on = side_lattice(shape, order, side);
        for (int q = 0; q < own.point_count; ++q)
          for (int n = 0; n < own.node_count; ++n)
            expected[q * cell.node_count + on[n]] = own.value[q * own.node_count + n];
        double error = 0.0;
        for (std::size_t m = 0; m < expected.size(); ++m)
          error = std::max(error, std::abs(cell.value[m] - expected[m]));
        CHECK(error < 1e-12);
      }
}

TEST_CASE("derivatives of Lagrange functions are those of differences")
{
  const double h = 1e-5;
  for (const Shape shape : all_shapes)
    for (const int order : {1, 2, 4})
    {
      const std::vector<Point> points = inner_points(shape);
      const CellTable table = tabulate(shape, order, points, 2);
      for (int d = 0; d < dimension(shape); ++d)
      {
        std::vector<Point> ahead = points;
        std::vector<Point> behind = points;
        for (std::size_t q = 0; q < points.size(); ++q)
        {
          ahead[q][d] += h;
          behind[q][d] -= h;
        }
        const CellTable plus = tabulate(shape, order, ahead, 1);
        const CellTable minus = tabulate(shape, order, behind, 1);
        double error = 0.0;
        double second_error = 0.0;
        for (std::size_t m = 0; m < table.value.size(); ++m)
        {
          error = std::max(error, std::abs((plus.value[m] - minus.value[m]) / (2.0 * h) - table.first[d][m]));
          for (int p = 0; p < 6; ++p)
            if (pairs[p][1] == d && !table.second[p].empty())
              second_error =
                  std::max(second_error,
                           std::abs((plus.first[pairs[p][0]][m] - minus.first[pairs[p][0]][m]) / (2.0 * h) -
                                    table.second[p][m]));
        }
        CHECK(error < 2e-7);
        CHECK(second_error < 2e-5);
      }
    }
}

TEST_CASE("a pyramid with any flat base is mapped by order 1 without error at the apex")
{
  // x = xi (1 + eta / 2 / (1 - zeta)) has a base that is no parallelogram; its derivative along xi at the
  // apex, along the axis, is 1 + 1/4.
  const std::vector<Point> apex = {{0.0, 0.0, 1.0}};
  const CellTable table = tabulate(Shape::pyramid, 1, apex, 1);
  const std::array<double, 5> x = {0.0, 1.0, 0.0, 1.5, 0.0};
  double derivative = 0.0;
  for (int n = 0; n < 5; ++n)
    derivative += table.first[0][n] * x[n];
  CHECK(derivative == doctest::Approx(1.25).epsilon(1e-14));
}

TEST_CASE("values taken to equispaced nodes and back are as before")
{
  for (const Shape shape : all_shapes)
    for (int order = 1; order <= 8; ++order)
    {
      const std::vector<double> there =
          resample(shape, {order, NodeKind::warped}, {order, NodeKind::equispaced});
      const std::vector<double> back =
          resample(shape, {order, NodeKind::equispaced}, {order, NodeKind::warped});
      const int n = static_cast<int>(lattice_size(shape, order));
      double error = 0.0;
      for (int q = 0; q < n; ++q)
        for (int m = 0; m < n; ++m)
        {
          double sum = q == m ? -1.0 : 0.0;
          for (int k = 0; k < n; ++k)
            sum += back[q * n + k] * there[k * n + m];
          error = std::max(error, std::abs(sum));
        }
      CHECK(error < 1e-11);
    }
}

TEST_CASE("elevated values are those of the same function and lowering takes them back")
{
  for (const Shape shape : all_shapes)
  {
    const std::vector<double> up = resample(shape, {2, NodeKind::warped}, {5, NodeKind::warped});
    const std::vector<double> down = resample(shape, {5, NodeKind::warped}, {2, NodeKind::warped});
    const int low = static_cast<int>(lattice_size(shape, 2));
    const int high = static_cast<int>(lattice_size(shape, 5));
    REQUIRE(static_cast<int>(up.size()) == low * high);
    for (int q = 0; q < low; ++q)
      for (int m = 0; m < low; ++m)
      {
        double sum = 0.0;
        for (int k = 0; k < high; ++k)
          sum += down[q * high + k] * up[k * low + m];
        CHECK(std::abs(sum - (q == m ? 1.0 : 0.0)) < 1e-13);
      }
  }
}

TEST_CASE("a table of an order that no cell has is refused")
{
  CHECK_THROWS_AS(tabulate(Shape::triangle, 9, {}), blockfsi::Error);
}
