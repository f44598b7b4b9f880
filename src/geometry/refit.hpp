#pragma once

#include "geometry/nurbs.hpp"

#include <functional>
#include <span>

namespace blockfsi::geometry
{

/// A B-spline near a curve or a surface that is slow to evaluate, and how far it is off at the samples.
template <typename Spline>
struct Refitted
{
  Spline spline;
  double error = 0.0;  ///< largest distance at equal parameters between the nodes of the fit [m]
};

/// The continuous B-spline of degree 8 that interpolates a curve x(t), t from 0 to 1, at the Chebyshev points
/// of pieces, which lie between `breaks` (ascending from 0 to 1) and are halved until the error is at most
/// `tolerance` [m] or has been so six times.
Refitted<NurbsCurve> refit(const std::function<Point(double)>& curve, std::span<const double> breaks,
                           double tolerance);

/// The same for a surface x(u, v), halved in both directions, up to five times.
Refitted<NurbsSurface> refit(const std::function<Point(double, double)>& surface,
                             std::span<const double> breaks_u, std::span<const double> breaks_v,
                             double tolerance);

}  // namespace blockfsi::geometry
