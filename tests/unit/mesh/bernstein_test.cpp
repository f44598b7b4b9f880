#include "mesh/bernstein.hpp"

#include "cells.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace blockfsi;
using element::Shape;
using mesh::Bernstein;

namespace
{

/// Value of a Bernstein polynomial, by its definition.
double evaluate(const Bernstein& space, const std::vector<double>& coefficients, const element::Point& at)
{
  const auto factors = space.factors();
  const auto points = space.points();
  double sum = 0.0;
  for (std::size_t m = 0; m < points.size(); ++m)
  {
    const auto [i, j, k] = points[m];
    double function = factors[m] * std::pow(at[0], i) * std::pow(at[1], j) * std::pow(at[2], k);
    if (space.kind == Bernstein::Kind::tensor)
      function *= std::pow(1 - at[0], space.a - i) * std::pow(1 - at[1], space.b - j) *
                  std::pow(1 - at[2], space.c - k);
    else if (space.kind == Bernstein::Kind::prism)
      function *= std::pow(1 - at[0] - at[1], space.a - i - j) * std::pow(1 - at[2], space.c - k);
    else
      function *= std::pow(1 - at[0] - at[1] - at[2], space.a - i - j - k);
    sum += coefficients[m] * function;
  }
  return sum;
}

std::vector<double> random_coefficients(std::size_t size, std::mt19937& random)
{
  std::vector<double> result(size);
  for (double& value : result)
    value = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  return result;
}

/// A line, a triangle, a tetrahedron and so on, with different degrees in different directions.
const std::array<Bernstein, 6> spaces = {{{Bernstein::Kind::tensor, 3, 2, 0},
                                          {Bernstein::Kind::tensor, 2, 3, 1},
                                          {Bernstein::Kind::prism, 3, 0, 0},
                                          {Bernstein::Kind::prism, 2, 0, 3},
                                          {Bernstein::Kind::simplex, 3, 0, 0},
                                          {Bernstein::Kind::tensor, 1, 0, 2}}};

}  // namespace

TEST_CASE("the tangents of a cell in Bernstein form are the derivatives of its coordinates")
{
  std::mt19937 random(1);
  const element::Point inside = {0.23, 0.31, 0.37};
  for (const Shape shape : cell_shapes)
    for (int order = 1; order <= 8; ++order)
    {
      // Pyramids are polynomials in collapsed coordinates.
      const element::Point at =
          shape == Shape::pyramid
              ? element::Point{inside[0] / (1 - inside[2]), inside[1] / (1 - inside[2]), inside[2]}
              : element::Point{inside[0], inside[1], element::dimension(shape) == 3 ? inside[2] : 0.0};
      const element::CellTable table =
          element::tabulate(shape, order, std::vector<element::Point>{inside}, 1);
      const std::vector<double> x = random_coefficients(table.node_count, random);
      const std::vector<mesh::Tangent> tangents = mesh::tangents(shape, order);
      REQUIRE(static_cast<int>(tangents.size()) == element::dimension(shape));
      for (std::size_t d = 0; d < tangents.size(); ++d)
      {
        const mesh::SparseRows& rows = tangents[d].from_nodes;
        REQUIRE(rows.row_count() == tangents[d].space.size());
        std::vector<double> coefficients(rows.row_count(), 0.0);
        for (std::size_t row = 0; row < rows.row_count(); ++row)
          for (std::int32_t m = rows.start[row]; m < rows.start[row + 1]; ++m)
            coefficients[row] += rows.entry[m] * x[rows.column[m]];
        double expected = 0.0;
        for (int n = 0; n < table.node_count; ++n)
          expected += table.first[d][n] * x[n];
        CHECK(std::abs(evaluate(tangents[d].space, coefficients, at) - expected) < 1e-10);
      }
    }
}

TEST_CASE("the product of two Bernstein polynomials is the product of their values")
{
  std::mt19937 random(2);
  const element::Point at = {0.21, 0.34, 0.4};
  for (const Bernstein& space : spaces)
  {
    Bernstein other = space;
    ++other.a;
    const Bernstein both = space * other;
    std::vector<double> a = random_coefficients(space.size(), random);
    std::vector<double> b = random_coefficients(other.size(), random);
    const double expected = evaluate(space, a, at) * evaluate(other, b, at);
    for (std::size_t m = 0; m < a.size(); ++m)
      a[m] *= space.factors()[m];
    for (std::size_t m = 0; m < b.size(); ++m)
      b[m] *= other.factors()[m];
    std::vector<double> product(both.size(), 0.0);
    mesh::Product(space, other).add(1.0, a, b, product);
    for (std::size_t m = 0; m < product.size(); ++m)
      product[m] /= both.factors()[m];
    CHECK(evaluate(both, product, at) == doctest::Approx(expected).epsilon(1e-13));
  }
}

TEST_CASE("both halves of a patch are the polynomial on the halves of its cell")
{
  std::mt19937 random(3);
  const element::Point at = {0.21, 0.34, 0.4};
  const std::array<element::Point, 4> corners = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const Bernstein& space : spaces)
    for (const mesh::Halving& halving : mesh::halvings(space))
    {
      const std::vector<double> whole = random_coefficients(space.size(), random);
      std::vector<double> upper = whole;
      std::vector<double> lower(whole.size());
      halving.split(upper, lower);
      for (const bool is_upper : {false, true})
      {
        element::Point in_whole = at;
        if (halving.axis >= 0)
          in_whole[halving.axis] = 0.5 * (at[halving.axis] + (is_upper ? 1.0 : 0.0));
        else
        {
          // One corner of the edge moves to its middle.
          std::array<element::Point, 4> moved = corners;
          for (int d = 0; d < 3; ++d)
            moved[is_upper ? halving.from : halving.to][d] =
                0.5 * (corners[halving.from][d] + corners[halving.to][d]);
          const bool flat = space.kind == Bernstein::Kind::prism;
          const double rest = 1.0 - at[0] - at[1] - (flat ? 0.0 : at[2]);
          for (int d = 0; d < (flat ? 2 : 3); ++d)
            in_whole[d] = rest * moved[0][d] + at[0] * moved[1][d] + at[1] * moved[2][d] +
                          (flat ? 0.0 : at[2] * moved[3][d]);
        }
        CHECK(evaluate(space, is_upper ? upper : lower, at) ==
              doctest::Approx(evaluate(space, whole, in_whole)).epsilon(1e-13));
      }
    }
}

TEST_CASE("coefficients at the corners are values of the polynomial")
{
  CHECK(Bernstein{Bernstein::Kind::tensor, 2, 2, 0}.corners() == std::vector<std::int32_t>{0, 2, 6, 8});
  CHECK(Bernstein{Bernstein::Kind::tensor, 1, 1, 2}.corners().size() == 8);
  CHECK(Bernstein{Bernstein::Kind::prism, 2, 0, 0}.corners() == std::vector<std::int32_t>{0, 2, 5});
  CHECK(Bernstein{Bernstein::Kind::prism, 2, 0, 1}.corners().size() == 6);
  CHECK(Bernstein{Bernstein::Kind::simplex, 2, 0, 0}.corners() == std::vector<std::int32_t>{0, 2, 5, 9});
  CHECK(Bernstein{Bernstein::Kind::simplex, 0, 0, 0}.corners() == std::vector<std::int32_t>{0});
}
