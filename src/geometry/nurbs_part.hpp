#pragma once

#include "geometry/nurbs.hpp"

#include <vector>

namespace blockfsi::geometry
{

/// The part of a NURBS curve between two of its parameters, in either direction; through the seam of a closed
/// curve if `to` is below 0 or above 1.
struct NurbsPart
{
  const NurbsCurve* curve = nullptr;  ///< must outlive the part
  double from = 0.0;
  double to = 1.0;

  /// The curve's parameter at u in [0, 1].
  double parameter(double u) const;
};

/// The parameter of the point of a curve that is closest to x: Newton's method, going downhill only, from the
/// nearest of samples.
double closest_parameter(const NurbsCurve& curve, const Point& x);

/// The part of a curve between the points that are closest to a and b; of a closed curve the shorter way
/// round, or the longer one.
NurbsPart part_between(const NurbsCurve& curve, const Point& a, const Point& b, bool longer);

/// Where the part is less smooth, ascending from 0 to 1.
std::vector<double> breaks(const NurbsPart& part);

}  // namespace blockfsi::geometry
