#pragma once

#include "core/lanes.hpp"
#include "fem/line_table.hpp"

#include <array>
#include <vector>

namespace blockfsi::fem
{

/// Geometry of a batch of cells at all quadrature points.
struct CellGeometry
{
  struct Point
  {
    std::array<std::array<Lanes, 2>, 2> inverse;  ///< inverse[k][l] = d xi_k / d x_l
    Lanes weight;                                 ///< quadrature weight times det J
    std::array<Lanes, 3> metric;                  ///< G = J^-T J^-1: xx, xy, yy
    /// Second derivatives of x and y in the reference coordinates: xi xi, xi eta, eta eta.
    std::array<std::array<Lanes, 3>, 2> curvature;
  };
  std::vector<Point> points;

  /// From nodal coordinates of shape (2, nodes, nodes): all x, then all y.
  void compute(const LineTable& table, const Lanes* nodal, bool curvature);
};

/// Gradient in physical coordinates from derivatives on the unit cell.
inline std::array<Lanes, 2> gradient(const CellGeometry::Point& point, const Lanes& xi, const Lanes& eta)
{
  const auto& a = point.inverse;
  return {xi * a[0][0] + eta * a[1][0], xi * a[0][1] + eta * a[1][1]};
}

/// Second derivatives xx, xy, yy in physical coordinates:
/// J^-T (H - sum_l d_l u X_l) J^-1, where X_l is the curvature of the map (not optional on curved cells).
inline std::array<Lanes, 3> second(const CellGeometry::Point& point, const std::array<Lanes, 2>& grad,
                                   const Lanes& xi_xi, const Lanes& xi_eta, const Lanes& eta_eta)
{
  const auto& a = point.inverse;
  const auto& c = point.curvature;
  const Lanes h11 = xi_xi - grad[0] * c[0][0] - grad[1] * c[1][0];
  const Lanes h12 = xi_eta - grad[0] * c[0][1] - grad[1] * c[1][1];
  const Lanes h22 = eta_eta - grad[0] * c[0][2] - grad[1] * c[1][2];
  const Lanes x1 = h11 * a[0][0] + h12 * a[1][0];
  const Lanes x2 = h12 * a[0][0] + h22 * a[1][0];
  const Lanes y1 = h11 * a[0][1] + h12 * a[1][1];
  const Lanes y2 = h12 * a[0][1] + h22 * a[1][1];
  return {a[0][0] * x1 + a[1][0] * x2, a[0][1] * x1 + a[1][1] * x2, a[0][1] * y1 + a[1][1] * y2};
}

}  // namespace blockfsi::fem
