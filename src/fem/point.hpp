#pragma once

#include "core/lanes.hpp"

#include <array>
#include <concepts>

namespace blockfsi::fem
{

/// What a physics sees at a quadrature point, for a batch of cells at once.
/// S is Lanes for residuals and Dual<Lanes, N> for tangents.
template <class S, int Unknowns, int Curved, int Data>
struct PointInput
{
  std::array<S, Unknowns> value;
  std::array<std::array<S, 2>, Unknowns> gradient;  ///< in physical coordinates
  /// Second derivatives xx, xy, yy of the first `Curved` unknowns.
  std::array<std::array<S, 3>, Curved> second;
  std::array<Lanes, Data> data;  ///< given fields
  std::array<Lanes, 3> metric;   ///< G = J^-T J^-1 on the unit cell: xx, xy, yy [1/m^2]
};

/// What it answers: the factors of the test functions and of their gradients in the weak form.
template <class S, int Unknowns>
struct PointOutput
{
  std::array<S, Unknowns> value;
  std::array<std::array<S, 2>, Unknowns> gradient;
};

/// A weak form as a function at a point.
template <class P>
concept Physics = requires(const P& physics, const PointInput<Lanes, P::unknowns, P::curved, P::data>& in,
                           PointOutput<Lanes, P::unknowns>& out)
{
  {
    P::unknowns
    } -> std::convertible_to<int>;
  physics(in, out);
};

}  // namespace blockfsi::fem
