#pragma once

#include <span>
#include <vector>

namespace blockfsi::element
{

/// Points and weights of a quadrature rule on [0, 1].
struct Rule
{
  std::vector<double> points;
  std::vector<double> weights;
};

/// Gauss-Legendre rule with n >= 1 points, exact to degree 2n - 1.
Rule gauss(int n);

/// The order + 1 Gauss-Lobatto-Legendre points on [0, 1], ascending, with both ends; order >= 1.
/// Symmetric bit for bit: points[order - i] == 1 - points[i] up to one rounding.
std::vector<double> lobatto(int order);

/// Lagrange functions of some nodes at some points, row-major, shape (point_count, node_count).
struct Table
{
  int point_count = 0;
  int node_count = 0;
  std::vector<double> value;
  std::vector<double> first;   ///< first derivative
  std::vector<double> second;  ///< second derivative
};

/// Values and derivatives by products of differences: exact at the nodes.
Table lagrange(std::span<const double> nodes, std::span<const double> points);

}  // namespace blockfsi::element
