#pragma once

#include "fem/point.hpp"
#include "motion/parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace blockfsi::motion
{

/// The stiffness of the mesh at a quadrature point.
///
/// Data: distance to the interface and to the nearest chosen point [m].
struct Weight
{
  Stiffness stiffness;

  Lanes operator()(const std::array<Lanes, 2>& distance, const std::array<Lanes, 3>& metric) const
  {
    Lanes result{};
    for (int lane = 0; lane < lane_count; ++lane)
    {
      // G = J^-T J^-1, so its determinant is that of J to the power -2.
      const double inverse_square = metric[0][lane] * metric[2][lane] - metric[1][lane] * metric[1][lane];
      result[lane] = (stiffness.base + fall(stiffness.interface, distance[0][lane]) +
                      fall(stiffness.points, distance[1][lane])) *
                     std::pow(inverse_square, 0.5 * stiffness.jacobian);
    }
    return result;
  }

private:
  static double fall(const Falloff& falloff, double distance)
  {
    if (falloff.weight == 0.0)
      return 0.0;
    // Between nodes an interpolated distance can be a little negative.
    return falloff.weight * std::pow(1.0 + std::max(0.0, distance) / falloff.length, -falloff.exponent);
  }
};

/// Linear elasticity in plane strain, sigma = lambda tr(eps) I + 2 mu eps.
struct Elasticity
{
  static constexpr int unknowns = 2;
  static constexpr int curved = 0;
  static constexpr int data = 2;

  Weight weight;
  double lambda = 0.0;
  double mu = 0.5;

  /// Lame's constants of Young's modulus 1.
  static Elasticity from(const PseudoSolid& parameters)
  {
    const double nu = parameters.poisson;
    return {{parameters.stiffness}, nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), 0.5 / (1.0 + nu)};
  }

  template <class S>
  void operator()(const fem::PointInput<S, 2, 0, 2>& in, fem::PointOutput<S, 2>& out) const
  {
    const Lanes young = weight(in.data, in.metric);
    const auto& grad = in.gradient;
    const S pressure = lambda * young * (grad[0][0] + grad[1][1]);
    const S shear = mu * young * (grad[0][1] + grad[1][0]);
    out.value = {S(Lanes{}), S(Lanes{})};
    out.gradient[0] = {pressure + 2.0 * mu * young * grad[0][0], shear};
    out.gradient[1] = {shear, pressure + 2.0 * mu * young * grad[1][1]};
  }
};

/// Diffusion of one component of the displacement.
struct Diffusion
{
  static constexpr int unknowns = 1;
  static constexpr int curved = 0;
  static constexpr int data = 2;

  Weight weight;

  template <class S>
  void operator()(const fem::PointInput<S, 1, 0, 2>& in, fem::PointOutput<S, 1>& out) const
  {
    const Lanes conductivity = weight(in.data, in.metric);
    out.value[0] = S(Lanes{});
    out.gradient[0] = {in.gradient[0][0] * conductivity, in.gradient[0][1] * conductivity};
  }
};

/// One component u of the displacement with z = -Laplacian of u, both of the order of the mesh (Ciarlet &
/// Raviart 1974): int grad z . grad v = 0 for all v that vanish where u is prescribed, int grad u . grad q -
/// z q = (normal derivative of u, q) on the boundary for all q. Unknowns: u, z.
struct Plate
{
  static constexpr int unknowns = 2;
  static constexpr int curved = 0;
  static constexpr int data = 0;

  template <class S>
  void operator()(const fem::PointInput<S, 2, 0, 0>& in, fem::PointOutput<S, 2>& out) const
  {
    out.value = {S(Lanes{}), -in.value[1]};
    out.gradient[0] = in.gradient[1];
    out.gradient[1] = in.gradient[0];
  }
};

}  // namespace blockfsi::motion
