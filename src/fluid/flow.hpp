#pragma once

#include "fem/point.hpp"
#include "fem/side_loop.hpp"

#include <array>
#include <cmath>
#include <functional>

namespace blockfsi::fluid
{

/// Incompressible Navier-Stokes equations on a moving mesh with equal-order stabilisation (SUPG, PSPG, LSIC),
/// as a function at a point (formulation.md chapter 5).
///
/// Unknowns u_x, u_y [m/s], p [Pa] at t + theta step. The rate of change is (u - u_old) * rate.
/// Data: u_old (2), mesh velocity (2), body force per mass (2).
struct Flow
{
  static constexpr int unknowns = 3;
  static constexpr int curved = 2;
  static constexpr int data = 6;

  double density = 1.0;
  double viscosity = 1.0;
  double rate = 0.0;            ///< 1 / (theta step), 0 if steady [1/s]
  double step_frequency = 0.0;  ///< 2 / step, 0 if steady [1/s]
  int order = 1;
  double inverse_constant = 12.0;  ///< C_k of the inverse estimate on the unit square [-]

  template <class S>
  void operator()(const fem::PointInput<S, 3, 2, 6>& in, fem::PointOutput<S, 3>& out) const
  {
    const auto& u = in.value;
    const auto& grad = in.gradient;
    const auto& h = in.second;
    const Lanes rho = lanes(density);
    const Lanes mu = lanes(viscosity);
    const S relative[2] = {u[0] - in.data[2], u[1] - in.data[3]};
    const S viscous[2] = {mu * (h[0][0] + h[0][0] + h[0][2] + h[1][1]),  // div (2 mu eps)
                          mu * (h[1][2] + h[1][2] + h[1][0] + h[0][1])};
    S residual[2];
    for (int i = 0; i < 2; ++i)
    {
      out.value[i] = rho * rate * (u[i] - in.data[i])                               // rho du/dt
                     + rho * (relative[0] * grad[i][0] + relative[1] * grad[i][1])  // rho (u - w) . grad u
                     - rho * in.data[4 + i];                                        // - rho f
      residual[i] = out.value[i] + grad[2][i] - viscous[i];
    }
    const S inverse_tau = this->inverse_tau(relative, in.metric);
    const S tau = S(lanes(1.0)) / inverse_tau;
    const S divergence = grad[0][0] + grad[1][1];
    const Lanes trace = order * order * (in.metric[0] + in.metric[2]);
    const S isotropic = rho / trace * inverse_tau * divergence - u[2];  // LSIC, - p
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
      {
        out.gradient[i][j] = mu * (grad[i][j] + grad[j][i])      // 2 mu eps
                             + tau * residual[i] * relative[j];  // SUPG
        if (i == j)
          out.gradient[i][j] = out.gradient[i][j] + isotropic;
      }
    out.value[2] = divergence;
    for (int j = 0; j < 2; ++j)
      out.gradient[2][j] = tau * residual[j] * lanes(1.0 / density);  // PSPG
  }

private:
  /// 1 / tau_M = sqrt((2 / step)^2 + (2 k)^2 (u - w) . G (u - w) + (C_k nu)^2 G : G / 2).
  template <class S>
  S inverse_tau(const S (&relative)[2], const std::array<Lanes, 3>& g) const
  {
    const double kinematic = inverse_constant * viscosity / density;
    const Lanes constant = step_frequency * step_frequency +
                           0.5 * kinematic * kinematic * (g[0] * g[0] + 2.0 * g[1] * g[1] + g[2] * g[2]);
    const S advective =
        relative[0] * (relative[0] * g[0] + relative[1] * (2.0 * g[1])) + relative[1] * relative[1] * g[2];
    return sqrt(advective * lanes(4.0 * order * order) + constant);
  }
};

/// Constant C_k of ||laplace v||^2 <= C_k / h^2 ||grad v||^2 for polynomials of order k on a square of side h
/// (Harari & Hughes 1992; largest eigenvalue, computed for k = 2..8; k = 1 is set so that tau stays h^2 / (12
/// nu)).
double inverse_constant(int order);

/// Traction on boundaries where the velocity is free.
/// Data: mesh velocity (2).
struct OpenBoundary
{
  static constexpr int unknowns = 3;
  static constexpr int data = 2;

  double density = 1.0;
  double viscosity = 1.0;
  double backflow = 0.5;
  bool do_nothing = false;  ///< subtract the transposed gradient, so that a developed flow leaves undisturbed
  /// Prescribed traction [Pa] at a point with an outward normal.
  std::function<std::array<double, 2>(const std::array<double, 2>& x, const std::array<double, 2>& normal)>
      traction;

  template <class S>
  std::array<S, 3> operator()(const fem::SideInput<S, 3, 2>& in) const
  {
    const auto& n = in.normal;
    const std::array<double, 2> h = traction(in.x, n);
    const S flux = (in.value[0] - in.data[0]) * n[0] + (in.value[1] - in.data[1]) * n[1];
    const bool inward = value(flux) < 0.0;
    std::array<S, 3> out{};
    for (int i = 0; i < 2; ++i)
    {
      out[i] = S(-h[i]);
      if (do_nothing)
        out[i] = out[i] - (in.gradient[0][i] * n[0] + in.gradient[1][i] * n[1]) * viscosity;
      if (inward)
        out[i] = out[i] - flux * in.value[i] * (backflow * density);
    }
    return out;
  }

private:
  static double value(double number) { return number; }
  template <int N>
  static double value(const Dual<double, N>& number)
  {
    return number.value;
  }
};

}  // namespace blockfsi::fluid
