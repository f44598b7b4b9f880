#pragma once

#include "geometry/point.hpp"

#include <functional>
#include <vector>

namespace blockfsi::geometry
{

/// The length of a smooth curve and the parameters that cut it into given shares of it. The curve is sampled
/// once: polynomials of degree 8 on 16 to 128 equal parts, halved until the length has settled to 1e-13.
class ArcLength
{
public:
  /// `curve` gives the point at a parameter from 0 to 1; what it throws passes through.
  explicit ArcLength(const std::function<Point(double)>& curve);

  /// [m]
  double length() const { return ends_.back(); }
  /// The parameter up to which the curve has `share` (0 to 1) of its length; exactly 0 at 0 and 1 at 1.
  double parameter(double share) const;

private:
  /// Length of part `part` from its start up to u (0 to 1) of it [m].
  double within(int part, double u) const;
  /// Its derivative by u.
  double speed(int part, double u) const;
  void sample(const std::function<Point(double)>& curve, int parts);

  std::vector<double> speed_;  ///< |dx/dt| at the nodes of all parts [m], shape (parts, node count)
  std::vector<double> ends_;   ///< length up to the start of each part, then the whole [m]
};

}  // namespace blockfsi::geometry
