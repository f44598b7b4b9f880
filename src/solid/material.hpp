#pragma once

#include "fem/point.hpp"
#include "solid/parameters.hpp"

namespace blockfsi::solid
{

/// Lame's constants [Pa] of the plane problem.
struct Lame
{
  double lambda = 0.0;
  double mu = 0.0;
};

/// lambda = E nu / ((1 + nu)(1 - 2 nu)), mu = E / (2 (1 + nu)); in plane stress S_33 = 0 gives
/// lambda* = 2 lambda mu / (lambda + 2 mu), exact for St. Venant-Kirchhoff (formulation.md chapter 6).
Lame lame(double young, double poisson, Plane plane);

/// Momentum of a St. Venant-Kirchhoff body in its undeformed state as a function at a point:
/// inertia (d - inertia_origin) - rho f for the test function, weight F S for its gradient.
///
/// Unknowns: displacement d [m]. Data: inertia origin (2) [m], body force per mass (2) [m/s^2].
struct Body
{
  static constexpr int unknowns = 2;
  static constexpr int curved = 0;
  static constexpr int data = 4;

  Lame material;
  double inertia = 0.0;        ///< rho / (theta step^2), 0 if static [kg/(m^3 s^2)]
  double force_density = 0.0;  ///< rho times the load factor [kg/m^3]
  double stress_weight = 1.0;  ///< theta

  template <class S>
  void operator()(const fem::PointInput<S, 2, 0, 4>& in, fem::PointOutput<S, 2>& out) const
  {
    const auto& grad = in.gradient;
    const Lanes one = lanes(1.0);
    const S F[2][2] = {{grad[0][0] + one, grad[0][1]}, {grad[1][0], grad[1][1] + one}};
    const Lanes half = lanes(0.5);
    // E = (H + H^T + H^T H) / 2 with H = grad d: F^T F - I would lose small strains to rounding.
    const S E11 = grad[0][0] + half * (grad[0][0] * grad[0][0] + grad[1][0] * grad[1][0]);
    const S E22 = grad[1][1] + half * (grad[0][1] * grad[0][1] + grad[1][1] * grad[1][1]);
    const S E12 = half * (grad[0][1] + grad[1][0] + grad[0][0] * grad[0][1] + grad[1][0] * grad[1][1]);
    // S = lambda tr E I + 2 mu E
    const S trace = lanes(stress_weight * material.lambda) * (E11 + E22);
    const Lanes two_mu = lanes(2.0 * stress_weight * material.mu);
    const S S11 = trace + two_mu * E11;
    const S S22 = trace + two_mu * E22;
    const S S12 = two_mu * E12;
    for (int i = 0; i < 2; ++i)
    {
      out.value[i] = lanes(inertia) * (in.value[i] - in.data[i]) - force_density * in.data[2 + i];
      out.gradient[i][0] = F[i][0] * S11 + F[i][1] * S12;
      out.gradient[i][1] = F[i][0] * S12 + F[i][1] * S22;
    }
  }
};

}  // namespace blockfsi::solid
