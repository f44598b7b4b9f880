#pragma once

#include "element/line.hpp"
#include "element/nodes.hpp"

#include <vector>

namespace blockfsi::element
{

/// Points and weights of a quadrature rule on a reference cell; the weights sum to its volume.
struct CellRule
{
  std::vector<Point> points;
  std::vector<double> weights;
};

/// Gauss-Jacobi rule with n >= 1 points for the weight (1 - x)^alpha on [0, 1]: exact for polynomials of
/// degree 2n - 1 times that weight.
Rule gauss_jacobi(int n, int alpha);

/// Rule with positive weights and all points inside, exact for polynomials of total degree <= degree on
/// simplices, of degree <= degree in each coordinate on quadrilaterals and hexahedra, of the product on
/// prisms, and on pyramids for products of two functions of elements whose orders sum to degree. Gauss points
/// in each coordinate, collapsed to a corner (simplices) or the apex (Stroud 1971, chapter 2).
CellRule quadrature(Shape shape, int degree);

}  // namespace blockfsi::element
