#pragma once

#include "geometry/bspline.hpp"
#include "geometry/jet.hpp"

#include <array>
#include <span>
#include <vector>

namespace blockfsi::geometry
{

/// A curve of B-splines, rational where there are weights (NURBS; Piegl & Tiller 1997, chapters 3 and 4):
/// c(k) = sum_i N_i(k) w_i p_i / sum_i N_i(k) w_i.
struct NurbsCurve
{
  int degree = 1;
  std::vector<double> knots;    ///< clamped, points.size() + degree + 1
  std::vector<Point> points;    ///< control points, ends included [m]
  std::vector<double> weights;  ///< one per control point, > 0; empty: all 1
};

/// A surface of B-splines, rational where there are weights.
struct NurbsSurface
{
  std::array<int, 2> degrees{1, 1};          ///< along u and v
  std::array<std::vector<double>, 2> knots;  ///< along u and v, each clamped
  std::vector<Point> points;    ///< control points, row-major, shape (count of u, count of v) [m]
  std::vector<double> weights;  ///< one per control point, > 0; empty: all 1

  /// Number of control points along u (0) or v (1).
  std::size_t count(int direction) const { return knots[direction].size() - degrees[direction] - 1; }
};

/// Throw Error naming the knot, weight or point that is wrong; `what` starts the message.
void check(std::string_view what, const NurbsCurve& curve);
void check(std::string_view what, const NurbsSurface& surface);

/// The point at t in [0, 1], which stands for the range of the knots. Allocates nothing.
Point evaluate(const NurbsCurve& curve, double t);
/// The point with the derivatives with respect to t.
CurveJet jet(const NurbsCurve& curve, double t);
/// Points at many parameters, shape (t.size()); fastest where t ascends. Allocates nothing.
void evaluate(const NurbsCurve& curve, std::span<const double> t, std::span<Point> x);

/// The point at u, v in [0, 1], which stand for the ranges of the knots. Allocates nothing.
Point evaluate(const NurbsSurface& surface, double u, double v);
/// The point with the derivatives with respect to u and v.
SurfaceJet jet(const NurbsSurface& surface, double u, double v);
/// Points at many parameters, shapes (u.size()). Allocates nothing.
void evaluate(const NurbsSurface& surface, std::span<const double> u, std::span<const double> v,
              std::span<Point> x);

/// The knots that are different, in units of the parameter from 0 to 1.
std::vector<double> breaks(std::span<const double> knots);

}  // namespace blockfsi::geometry
