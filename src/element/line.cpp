#include "element/line.hpp"

#include <cmath>
#include <numbers>

namespace blockfsi::element
{

namespace
{

struct Legendre
{
  double value;
  double derivative;
};

/// Legendre polynomial of degree n and its derivative on (-1, 1), by the three-term recurrence.
Legendre legendre(int n, double x)
{
  double before = 1.0;
  double value = n == 0 ? 1.0 : x;
  for (int k = 2; k <= n; ++k)
  {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  const double derivative = n == 0 ? 0.0 : n * (x * value - before) / (x * x - 1.0);
  return {value, derivative};
}

}  // namespace

Rule gauss(int n)
{
  Rule rule;
  rule.points.resize(n);
  rule.weights.resize(n);
  for (int i = 0; i < n; ++i)
  {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    for (int iteration = 0; iteration < 100; ++iteration)
    {
      const auto [value, derivative] = legendre(n, x);
      const double change = value / derivative;
      x -= change;
      if (std::abs(change) < 1e-16)
        break;
    }
    const double derivative = legendre(n, x).derivative;
    rule.points[i] = 0.5 * (1.0 + x);
    rule.weights[i] = 1.0 / ((1.0 - x * x) * derivative * derivative);
  }
  return rule;
}

std::vector<double> lobatto(int order)
{
  std::vector<double> points(order + 1);
  points.back() = 1.0;
  for (int i = 1; 2 * i <= order; ++i)
  {
    // Roots of P'_order by Newton; P'' follows from Legendre's equation.
    double x = -std::cos(std::numbers::pi * i / order);
    for (int iteration = 0; iteration < 100 && 2 * i != order; ++iteration)
    {
      const auto [value, derivative] = legendre(order, x);
      const double second = (2.0 * x * derivative - order * (order + 1.0) * value) / (1.0 - x * x);
      const double change = derivative / second;
      x -= change;
      if (std::abs(change) < 1e-16)
        break;
    }
    points[i] = 2 * i == order ? 0.5 : 0.5 * (1.0 + x);
    points[order - i] = 1.0 - points[i];
  }
  return points;
}

Table lagrange(std::span<const double> nodes, std::span<const double> points)
{
  const int n = static_cast<int>(nodes.size());
  const int m = static_cast<int>(points.size());
  Table table{m, n, std::vector<double>(m * n), std::vector<double>(m * n), std::vector<double>(m * n)};
  for (int q = 0; q < m; ++q)
    for (int i = 0; i < n; ++i)
    {
      // Multiply the factors one by one and carry both derivatives along: no division, exact at the nodes.
      double value = 1.0;
      double first = 0.0;
      double second = 0.0;
      for (int j = 0; j < n; ++j)
      {
        if (j == i)
          continue;
        const double scale = 1.0 / (nodes[i] - nodes[j]);
        const double factor = (points[q] - nodes[j]) * scale;
        second = second * factor + 2.0 * first * scale;
        first = first * factor + value * scale;
        value *= factor;
      }
      table.value[q * n + i] = value;
      table.first[q * n + i] = first;
      table.second[q * n + i] = second;
    }
  return table;
}

}  // namespace blockfsi::element
