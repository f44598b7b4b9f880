#pragma once

#include <cmath>

namespace blockfsi
{

/// Number of cells that kernels treat at once.
inline constexpr int lane_count = 8;

/// One number for each of eight cells; arithmetic acts on all of them (one AVX-512 register, two of AVX2).
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));

/// All lanes equal.
inline Lanes lanes(double value)
{
  return Lanes{} + value;
}

using std::sqrt;

inline Lanes sqrt(const Lanes& a)
{
  Lanes root{};
  for (int i = 0; i < lane_count; ++i)
    root[i] = std::sqrt(a[i]);
  return root;
}

}  // namespace blockfsi
