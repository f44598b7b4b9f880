#pragma once

#include "block/connect.hpp"
#include "block/move.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// Weights with which a displacement known at some centres is interpolated at a point by cubic radial
/// functions |x - x_i|^3 with linear polynomials: no parameters, linear displacements are reproduced, the
/// result does not depend on the order of the centres (corners3d.md; Duchon 1977). Needs three centres that
/// do not lie on a line. The weights sum to 1.
std::vector<double> radial_weights(std::span<const std::array<double, 2>> centres,
                                   const std::array<double, 2>& x);

/// Rules for all corners that nothing else moves or holds: those inside the domain, not on the interface and
/// without a rule of the user. They follow the interface by radial functions whose centres are the corners on
/// the interface, on boundaries (at rest) and those with rules of the user. Constant weights: the nodes stay
/// a linear function of the interface, without memory.
std::vector<Follow> automatic_rules(const Layout& layout, const Skeleton& skeleton,
                                    std::span<const std::int64_t> interface, std::span<const Follow> user);

}  // namespace blockfsi::block
