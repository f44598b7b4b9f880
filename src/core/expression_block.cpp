#include "core/expression_block.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace blockfsi::expression
{

namespace
{

/// Derivative of a function of one argument `a` that has the given value.
double slope(Operation operation, double a, double value)
{
  switch (operation)
  {
  case Operation::negate:
    return -1.0;
  case Operation::abs:
    return a == 0.0 ? 0.0 : std::copysign(1.0, a);
  case Operation::sqrt:
    return 0.5 / value;
  case Operation::exp:
    return value;
  case Operation::log:
    return 1.0 / a;
  case Operation::sin:
    return std::cos(a);
  case Operation::cos:
    return -std::sin(a);
  case Operation::tan:
    return 1.0 + value * value;
  case Operation::asin:
    return 1.0 / std::sqrt((1.0 - a) * (1.0 + a));
  case Operation::acos:
    return -1.0 / std::sqrt((1.0 - a) * (1.0 + a));
  case Operation::atan:
    return 1.0 / (1.0 + a * a);
  case Operation::sinh:
    return std::cosh(a);
  case Operation::cosh:
    return std::sinh(a);
  case Operation::tanh:
    return 1.0 - value * value;
  default:
    return 0.0;  // logic, floor, step
  }
}

using Slopes = std::array<double, 2>;

Slopes power_slopes(double a, double b, double value)
{
  const double by_base = b == 2.0 ? 2.0 * a : b * std::pow(a, b - 1.0);
  return {b == 0.0 ? 0.0 : by_base, value == 0.0 ? 0.0 : value * std::log(a)};
}

Slopes ramp_slopes(double t, double duration)
{
  if (t <= 0.0 || t >= duration)
    return {0.0, 0.0};
  const double phase = std::numbers::pi / duration;
  const double rise = 0.5 * phase * std::sin(phase * t);
  return {rise, -rise * t / duration};
}

/// Derivatives of a function of two arguments that has the given value.
Slopes slopes(Operation operation, double a, double b, double value)
{
  switch (operation)
  {
  case Operation::add:
    return {1.0, 1.0};
  case Operation::subtract:
    return {1.0, -1.0};
  case Operation::multiply:
    return {b, a};
  case Operation::divide:
    return {1.0 / b, -value / b};
  case Operation::power:
    return power_slopes(a, b, value);
  case Operation::atan2:
  {
    const double square = a * a + b * b;
    return {b / square, -a / square};
  }
  case Operation::min:
    return a < b ? Slopes{1.0, 0.0} : Slopes{0.0, 1.0};
  case Operation::max:
    return a > b ? Slopes{1.0, 0.0} : Slopes{0.0, 1.0};
  case Operation::ramp:
    return ramp_slopes(a, b);
  default:
    return {0.0, 0.0};  // comparisons and logic
  }
}

/// 0 stays 0 even where the slope is infinite.
double chain(double factor, double derivative)
{
  return derivative == 0.0 ? 0.0 : factor * derivative;
}

template <std::size_t Points, std::size_t D>
void apply_unary(Operation operation, Numbers<Points, D>& a)
{
  for (std::size_t i = 0; i < Points; ++i)
  {
    const double value = unary(operation, a.value[i]);
    const double factor = D > 0 ? slope(operation, a.value[i], value) : 0.0;
    for (auto& derivative : a.derivative)
      derivative[i] = chain(factor, derivative[i]);
    a.value[i] = value;
  }
}

/// Sums, products and squares, which are most of all formulas: loops that the compiler vectorises.
template <std::size_t Points, std::size_t D>
bool apply_arithmetic(Operation operation, Numbers<Points, D>& a, const Numbers<Points, D>& b)
{
  switch (operation)
  {
  case Operation::add:
    for (std::size_t i = 0; i < Points; ++i)
      a.value[i] += b.value[i];
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t i = 0; i < Points; ++i)
        a.derivative[d][i] += b.derivative[d][i];
    return true;
  case Operation::subtract:
    for (std::size_t i = 0; i < Points; ++i)
      a.value[i] -= b.value[i];
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t i = 0; i < Points; ++i)
        a.derivative[d][i] -= b.derivative[d][i];
    return true;
  case Operation::multiply:
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t i = 0; i < Points; ++i)
        a.derivative[d][i] = a.derivative[d][i] * b.value[i] + a.value[i] * b.derivative[d][i];
    for (std::size_t i = 0; i < Points; ++i)
      a.value[i] *= b.value[i];
    return true;
  default:
    return false;
  }
}

bool is_two(const Instruction& instruction)
{
  return instruction.operation == Operation::number && instruction.value == 2.0;
}

template <std::size_t Points, std::size_t D>
void square(Numbers<Points, D>& a)
{
  for (std::size_t d = 0; d < D; ++d)
    for (std::size_t i = 0; i < Points; ++i)
      a.derivative[d][i] *= 2.0 * a.value[i];
  for (std::size_t i = 0; i < Points; ++i)
    a.value[i] *= a.value[i];
}

template <std::size_t Points, std::size_t D>
void apply_binary(Operation operation, Numbers<Points, D>& a, const Numbers<Points, D>& b)
{
  if (apply_arithmetic(operation, a, b))
    return;
  for (std::size_t i = 0; i < Points; ++i)
  {
    const double value = binary(operation, a.value[i], b.value[i], 0.0);
    const Slopes factor = D > 0 ? slopes(operation, a.value[i], b.value[i], value) : Slopes{};
    for (std::size_t d = 0; d < D; ++d)
      a.derivative[d][i] = chain(factor[0], a.derivative[d][i]) + chain(factor[1], b.derivative[d][i]);
    a.value[i] = value;
  }
}

/// if(condition, a, b): each point takes its own branch; the result replaces the condition.
template <std::size_t Points, std::size_t D>
void apply_select(Numbers<Points, D>& condition, const Numbers<Points, D>& a, const Numbers<Points, D>& b)
{
  for (std::size_t i = 0; i < Points; ++i)
  {
    const bool first = condition.value[i] != 0.0;
    condition.value[i] = select(condition.value[i], a.value[i], b.value[i]);
    for (std::size_t d = 0; d < D; ++d)
      condition.derivative[d][i] = first ? a.derivative[d][i] : b.derivative[d][i];
  }
}

template <std::size_t Points, std::size_t D>
void put(const Instruction& instruction, const std::array<std::array<double, Points>, 4>& at,
         Numbers<Points, D>& result)
{
  for (auto& derivative : result.derivative)
    derivative.fill(0.0);
  if (instruction.operation == Operation::number)
  {
    result.value.fill(instruction.value);
    return;
  }
  const auto variable =
      static_cast<std::size_t>(instruction.operation) - static_cast<std::size_t>(Operation::x);
  result.value = at[variable];
  if constexpr (D > 0)
    if (variable < D)
      result.derivative[variable].fill(1.0);
}

}  // namespace

template <std::size_t Points, std::size_t D>
Numbers<Points, D> evaluate(std::span<const Instruction> code,
                            const std::array<std::array<double, Points>, 4>& at)
{
  std::array<Numbers<Points, D>, stack_size> stack;
  std::size_t top = 0;
  for (const Instruction& instruction : code)
  {
    switch (instruction.arity)
    {
    case 0:
      put(instruction, at, stack[top++]);
      break;
    case 1:
      apply_unary(instruction.operation, stack[top - 1]);
      break;
    case 2:
      top -= 1;
      // In a postfix program, a number that is the last operand stands right before the operator.
      if (instruction.operation == Operation::power && is_two(*(&instruction - 1)))
        square(stack[top - 1]);
      else
        apply_binary(instruction.operation, stack[top - 1], stack[top]);
      break;
    default:
      top -= 2;
      apply_select(stack[top - 1], stack[top], stack[top + 1]);
    }
  }
  return stack[0];
}

template Numbers<1, 4> evaluate(std::span<const Instruction>, const std::array<std::array<double, 1>, 4>&);
template Numbers<1, 3> evaluate(std::span<const Instruction>, const std::array<std::array<double, 1>, 4>&);
template Numbers<block_size, 0> evaluate(std::span<const Instruction>,
                                         const std::array<std::array<double, block_size>, 4>&);
template Numbers<block_size, 3> evaluate(std::span<const Instruction>,
                                         const std::array<std::array<double, block_size>, 4>&);

}  // namespace blockfsi::expression
