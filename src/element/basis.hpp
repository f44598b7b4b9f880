#pragma once

#include "element/nodes.hpp"

#include <array>
#include <span>
#include <vector>

namespace blockfsi::element
{

/// A function at a point with its derivatives along the three reference coordinates.
struct Jet
{
  double value = 0.0;
  std::array<double, 3> first{};
  std::array<double, 6> second{};  ///< xx, yy, zz, xy, xz, yz
};

/// Functions of the space of a cell that are orthonormal on it, as many as it has nodes, at a point:
///   segment        Legendre polynomials
///   triangle       polynomials of total degree <= order (Proriol 1957, Koornwinder 1975, Dubiner 1991)
///   tetrahedron    the same in three coordinates
///   quadrilateral, hexahedron, prism  products
///   pyramid        X^i Y^j (1 - zeta)^max(i,j) zeta^l, l <= order - max(i, j), X = xi / (1 - zeta),
///                  Y = eta / (1 - zeta) (Bergot, Cohen and Durufle 2010): polynomials of total degree <=
///                  order and those rational functions that make base and triangles conform.
/// At the apex of a pyramid values are limits, first derivatives those along the axis X = Y = 1/2; second
/// derivatives that are unbounded there are given as 0. `result` has shape (lattice_size(shape, order)).
void orthonormal(Shape shape, int order, const Point& point, std::span<Jet> result);

}  // namespace blockfsi::element
