#pragma once

#include <vector>

namespace blockfsi::fem
{

/// The Lagrange functions of one order on the unit interval at the points of a Gauss rule: all that
/// tensor-product cells need. Arrays are row-major, shape (points, nodes).
struct LineTable
{
  int points = 0;
  int nodes = 0;
  std::vector<double> value;
  std::vector<double> first;
  std::vector<double> second;
  std::vector<double> position;  ///< of the points, shape (points)
  std::vector<double> weight;    ///< shape (points)
};

/// Gauss points along each direction for the weak forms of both physics: exact for the convective term on
/// straight cells up to order 3.
constexpr int quadrature_points(int order)
{
  return order + 2;
}

/// Nodes at the Gauss-Lobatto-Legendre points of the order.
LineTable make_line_table(int order, int points);

}  // namespace blockfsi::fem
