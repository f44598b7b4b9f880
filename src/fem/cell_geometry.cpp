#include "fem/cell_geometry.hpp"

#include "fem/tensor.hpp"

namespace blockfsi::fem
{

namespace
{

constexpr int max_points = max_line * max_line;

struct Derivatives
{
  Lanes xi[max_points];
  Lanes eta[max_points];
  Lanes xi_xi[max_points];
  Lanes xi_eta[max_points];
  Lanes eta_eta[max_points];

  void compute(const LineTable& table, const Lanes* nodal, bool curvature)
  {
    ReferenceValues out{nullptr, xi, eta, nullptr, nullptr, nullptr};
    if (curvature)
      out = {nullptr, xi, eta, xi_xi, xi_eta, eta_eta};
    interpolate(table, nodal, out);
  }
};

}  // namespace

void CellGeometry::compute(const LineTable& table, const Lanes* nodal, bool curvature)
{
  const int m = table.points;
  points.resize(m * m);
  Derivatives x;
  Derivatives y;
  x.compute(table, nodal, curvature);
  y.compute(table, nodal + table.nodes * table.nodes, curvature);
  for (int q = 0; q < m * m; ++q)
  {
    Point& point = points[q];
    const Lanes det = x.xi[q] * y.eta[q] - x.eta[q] * y.xi[q];
    const Lanes inverse = 1.0 / det;
    auto& a = point.inverse;
    a[0] = {y.eta[q] * inverse, -x.eta[q] * inverse};
    a[1] = {-y.xi[q] * inverse, x.xi[q] * inverse};
    point.weight = table.weight[q % m] * table.weight[q / m] * det;
    point.metric = {a[0][0] * a[0][0] + a[1][0] * a[1][0], a[0][0] * a[0][1] + a[1][0] * a[1][1],
                    a[0][1] * a[0][1] + a[1][1] * a[1][1]};
    if (curvature)
      point.curvature = {{{x.xi_xi[q], x.xi_eta[q], x.eta_eta[q]}, {y.xi_xi[q], y.xi_eta[q], y.eta_eta[q]}}};
  }
}

}  // namespace blockfsi::fem
