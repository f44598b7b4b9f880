#include "element/line.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace blockfsi;

TEST_CASE("a Gauss rule with n points integrates degree 2n - 1 exactly and 2n not")
{
  for (int n = 1; n <= 12; ++n)
  {
    const element::Rule rule = element::gauss(n);
    for (int degree = 0; degree <= 2 * n; ++degree)
    {
      double sum = 0.0;
      for (int i = 0; i < n; ++i)
        sum += rule.weights[i] * std::pow(rule.points[i], degree);
      const double error = std::abs(sum - 1.0 / (degree + 1));
      if (degree < 2 * n)
        CHECK(error < 1e-15);
      else if (n < 9)
        CHECK(error > 1e-12);
    }
  }
}

TEST_CASE("Gauss-Lobatto points are the roots known from the literature")
{
  // Abramowitz & Stegun 1964, table 25.6, mapped from [-1, 1] to [0, 1].
  CHECK(element::lobatto(1) == std::vector<double>{0.0, 1.0});
  CHECK(element::lobatto(2) == std::vector<double>{0.0, 0.5, 1.0});
  CHECK(element::lobatto(3)[1] == doctest::Approx(0.5 * (1 - 1 / std::sqrt(5.0))).epsilon(1e-15));
  CHECK(element::lobatto(4)[1] == doctest::Approx(0.5 * (1 - std::sqrt(3.0 / 7.0))).epsilon(1e-15));
  CHECK(element::lobatto(6)[2] == doctest::Approx(0.5 * (1 - 0.468848793470714)).epsilon(1e-14));
}

TEST_CASE("Lagrange functions reproduce polynomials of their degree with both derivatives")
{
  for (int order = 1; order <= 8; ++order)
  {
    const std::vector<double> nodes = element::lobatto(order);
    const std::vector<double> points = {0.0, 0.1234, 0.5, 0.77, 1.0, nodes[1]};
    const element::Table table = element::lagrange(nodes, points);
    for (std::size_t q = 0; q < points.size(); ++q)
    {
      double value = 0.0, first = 0.0, second = 0.0;
      for (int i = 0; i <= order; ++i)
      {
        const double f = std::pow(nodes[i] - 0.3, order);
        value += table.value[q * (order + 1) + i] * f;
        first += table.first[q * (order + 1) + i] * f;
        second += table.second[q * (order + 1) + i] * f;
      }
      const double x = points[q] - 0.3;
      CHECK(value == doctest::Approx(std::pow(x, order)).epsilon(1e-12));
      CHECK(std::abs(first - order * std::pow(x, order - 1)) < 1e-11);
      if (order > 1)
        CHECK(std::abs(second - order * (order - 1) * std::pow(x, order - 2)) < 1e-9);
    }
  }
}
