#include "element/quadrature.hpp"

#include "shapes.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace blockfsi::element;

namespace
{

double factorial(int n)
{
  return std::tgamma(n + 1.0);
}

/// Integral of xi^i eta^j zeta^k over a reference cell.
double exact(Shape shape, int i, int j, int k)
{
  switch (shape)
  {
  case Shape::triangle:
    return factorial(i) * factorial(j) / factorial(i + j + 2);
  case Shape::tetrahedron:
    return factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3);
  case Shape::prism:
    return factorial(i) * factorial(j) / factorial(i + j + 2) / (k + 1);
  case Shape::pyramid:  // the square of side 1 - zeta, then a beta function
    return factorial(k) * factorial(i + j + 2) / factorial(i + j + k + 3) / ((i + 1) * (j + 1));
  case Shape::segment:
    return 1.0 / (i + 1);
  case Shape::quadrilateral:
    return 1.0 / ((i + 1) * (j + 1));
  default:
    return 1.0 / ((i + 1) * (j + 1) * (k + 1));
  }
}

}  // namespace

TEST_CASE("a rule integrates all monomials of its degree exactly, with positive weights")
{
  for (const Shape shape : all_shapes)
    for (int degree = 0; degree <= 17; ++degree)
    {
      const CellRule rule = quadrature(shape, degree);
      for (const double weight : rule.weights)
        CHECK(weight > 0.0);
      const bool total = shape == Shape::pyramid;
      for (const auto [i, j, k] : lattice_points(total ? Shape::tetrahedron : shape, degree))
      {
        double sum = 0.0;
        for (std::size_t q = 0; q < rule.points.size(); ++q)
          sum += rule.weights[q] * std::pow(rule.points[q][0], i) * std::pow(rule.points[q][1], j) *
                 std::pow(rule.points[q][2], k);
        CHECK(std::abs(sum - exact(shape, i, j, k)) < 1e-14);
      }
    }
}

TEST_CASE("a rule of a pyramid integrates products of its rational functions")
{
  // Over the pyramid xi^2 eta^2 / (1 - zeta)^2, a product of two functions of order 1, has the integral of
  // (1 - zeta)^4 / 9, which is 1/45.
  const CellRule rule = quadrature(Shape::pyramid, 2);
  double sum = 0.0;
  for (std::size_t q = 0; q < rule.points.size(); ++q)
    sum += rule.weights[q] * std::pow(rule.points[q][0] * rule.points[q][1] / (1.0 - rule.points[q][2]), 2);
  CHECK(sum == doctest::Approx(1.0 / 45.0).epsilon(1e-14));
}

TEST_CASE("a Gauss-Jacobi rule of n points is exact to degree 2n - 1")
{
  for (int n = 1; n <= 12; ++n)
    for (const int alpha : {1, 2})
    {
      const Rule rule = gauss_jacobi(n, alpha);
      for (int power = 0; power < 2 * n; ++power)
      {
        double sum = 0.0;
        for (int q = 0; q < n; ++q)
          sum += rule.weights[q] * std::pow(rule.points[q], power);
        CHECK(std::abs(sum - factorial(power) * factorial(alpha) / factorial(power + alpha + 1)) < 1e-15);
      }
    }
}
