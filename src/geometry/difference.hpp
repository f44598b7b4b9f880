#pragma once

#include "geometry/point.hpp"

#include <array>

namespace blockfsi::geometry
{

/// Derivative at t in [0, 1] of a function that is only known between 0 and 1, by seven points at distances
/// of 1/1024: the error is (1/1024)^6 / 140 (at the ends / 7) times the seventh derivative, and 1e-13 of the
/// values by rounding.
template <typename Function>
Point differentiate(const Function& function, double t)
{
  constexpr double h = 1.0 / 1024.0;
  // Row s: weights of the seven points where t is the s-th of them; the rows 4 to 6 mirror 2 to 0.
  constexpr std::array<std::array<double, 7>, 4> weights{
      {{-49.0 / 20, 6.0, -15.0 / 2, 20.0 / 3, -15.0 / 4, 6.0 / 5, -1.0 / 6},
       {-1.0 / 6, -77.0 / 60, 5.0 / 2, -5.0 / 3, 5.0 / 6, -1.0 / 4, 1.0 / 30},
       {1.0 / 30, -2.0 / 5, -7.0 / 12, 4.0 / 3, -1.0 / 2, 2.0 / 15, -1.0 / 60},
       {-1.0 / 60, 3.0 / 20, -3.0 / 4, 0.0, 3.0 / 4, -3.0 / 20, 1.0 / 60}}};
  const bool mirrored = t > 0.5;
  const double room = mirrored ? 1.0 - t : t;
  const int s = room >= 3 * h ? 3 : static_cast<int>(room / h);
  const double step = mirrored ? -h : h;
  Point sum{};
  for (int k = 0; k < 7; ++k)
    if (weights[s][k] != 0.0)
      sum = add_scaled(sum, weights[s][k] / step, function(t + (k - s) * step));
  return sum;
}

}  // namespace blockfsi::geometry
