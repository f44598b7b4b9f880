#pragma once

#include "core/expression_program.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace blockfsi::expression
{

/// How many points are evaluated at once.
inline constexpr std::size_t block_size = 16;

/// A formula's values at some points and its derivatives by the first D of x, y, z, t.
template <std::size_t Points, std::size_t D>
struct Numbers
{
  std::array<double, Points> value;
  std::array<std::array<double, Points>, D> derivative;
};

/// Values (D = 0) or values and derivatives (forward mode, exact to rounding) of a formula at points given as
/// four rows x, y, z, t; comparisons are exact. Where a formula has a kink or a jump, the derivative is that
/// of the branch that gives the value, and 0 for abs at 0. A part that does not depend on a variable has the
/// derivative 0 whatever its slope, so that sqrt(x^2 + y^2) has a finite one at the origin. Allocates
/// nothing.
template <std::size_t Points, std::size_t D>
Numbers<Points, D> evaluate(std::span<const Instruction> code,
                            const std::array<std::array<double, Points>, 4>& at);

extern template Numbers<1, 4> evaluate(std::span<const Instruction>,
                                       const std::array<std::array<double, 1>, 4>&);
extern template Numbers<1, 3> evaluate(std::span<const Instruction>,
                                       const std::array<std::array<double, 1>, 4>&);
extern template Numbers<block_size, 0> evaluate(std::span<const Instruction>,
                                                const std::array<std::array<double, block_size>, 4>&);
extern template Numbers<block_size, 3> evaluate(std::span<const Instruction>,
                                                const std::array<std::array<double, block_size>, 4>&);

}  // namespace blockfsi::expression
