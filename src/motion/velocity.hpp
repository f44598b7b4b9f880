#pragma once

#include "fem/time.hpp"

#include <span>

namespace blockfsi::motion
{

/// Mesh velocity and geometry of a step from the nodes at its ends: w = (x1 - x0) / step, integrals on
/// x0 + geometry (x1 - x0). With the midpoint this pairing is second order; other pairings are only first
/// (formulation.md chapter 5). All arrays of shape (node_count, 2); allocates nothing.
void mesh_velocity(const fem::TimeStep& step, std::span<const double> x0, std::span<const double> x1,
                   std::span<double> x, std::span<double> w);

}  // namespace blockfsi::motion
