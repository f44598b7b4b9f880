#pragma once

#include "geometry/jet.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace blockfsi::geometry
{

/// A quadrilateral surface element of any order: the Lagrange polynomial in u and v through points at given
/// parameters.
struct QuadrilateralPatch
{
  std::array<std::vector<double>, 2> parameters;  ///< of the points along u and v, ascending from 0 to 1
  std::vector<Point> points;  ///< row-major, shape (parameters[0].size(), parameters[1].size()) [m]
};

/// A triangular surface element of any order, u, v >= 0, u + v <= 1: the polynomial through points at
/// u = i / order, v = j / order (Silvester 1969).
struct TrianglePatch
{
  int order = 1;
  std::vector<Point> points;  ///< row after row: j = 0: i = 0 ... order; j = 1: i = 0 ... order - 1; ... [m]
};

/// The patch through order_u + 1 times order_v + 1 points at equal distances of the parameters.
QuadrilateralPatch equispaced_patch(int order_u, int order_v, std::vector<Point> points);

/// Throw Error saying what is wrong.
void check(std::string_view what, const QuadrilateralPatch& patch);
void check(std::string_view what, const TrianglePatch& patch);

/// The point at u, v with its derivatives. Allocates nothing.
SurfaceJet jet(const QuadrilateralPatch& patch, double u, double v);
SurfaceJet jet(const TrianglePatch& patch, double u, double v);

}  // namespace blockfsi::geometry
