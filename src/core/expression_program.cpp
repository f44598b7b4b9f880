#include "core/expression_program.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace blockfsi::expression
{

namespace
{

/// The first clause makes equal infinities equal: their difference is nan.
bool equal(double a, double b, double tolerance)
{
  return a == b || std::abs(a - b) <= tolerance;
}

double step(double a)
{
  return std::isnan(a) ? a : (a < 0.0 ? 0.0 : 1.0);
}

double ramp(double t, double duration)
{
  if (std::isnan(t) || std::isnan(duration))
    return std::numeric_limits<double>::quiet_NaN();
  if (t <= 0.0)
    return 0.0;
  return t >= duration ? 1.0 : 0.5 * (1.0 - std::cos(std::numbers::pi * t / duration));
}

/// Unlike std::fmin, a nan in either argument is the result: a formula that fails should not hide it.
double smaller(double a, double b)
{
  return std::isnan(a) || a < b ? a : b;
}

double larger(double a, double b)
{
  return std::isnan(a) || a > b ? a : b;
}

}  // namespace

double unary(Operation operation, double a)
{
  switch (operation)
  {
  case Operation::negate:
    return -a;
  case Operation::invert:
    return a == 0.0;
  case Operation::abs:
    return std::abs(a);
  case Operation::sqrt:
    return std::sqrt(a);
  case Operation::exp:
    return std::exp(a);
  case Operation::log:
    return std::log(a);
  case Operation::sin:
    return std::sin(a);
  case Operation::cos:
    return std::cos(a);
  case Operation::tan:
    return std::tan(a);
  case Operation::asin:
    return std::asin(a);
  case Operation::acos:
    return std::acos(a);
  case Operation::atan:
    return std::atan(a);
  case Operation::sinh:
    return std::sinh(a);
  case Operation::cosh:
    return std::cosh(a);
  case Operation::tanh:
    return std::tanh(a);
  case Operation::floor:
    return std::floor(a);
  default:
    return step(a);
  }
}

double binary(Operation operation, double a, double b, double tolerance)
{
  switch (operation)
  {
  case Operation::add:
    return a + b;
  case Operation::subtract:
    return a - b;
  case Operation::multiply:
    return a * b;
  case Operation::divide:
    return a / b;
  case Operation::power:
    return b == 2.0 ? a * a : std::pow(a, b);  // squares are common, and as exact
  case Operation::equal:
    return equal(a, b, tolerance);
  case Operation::differ:
    return !equal(a, b, tolerance);
  case Operation::less:
    return a < b;
  case Operation::less_equal:
    return a < b || equal(a, b, tolerance);
  case Operation::both:
    return a != 0.0 && b != 0.0;
  case Operation::either:
    return a != 0.0 || b != 0.0;
  case Operation::atan2:
    return std::atan2(a, b);
  case Operation::min:
    return smaller(a, b);
  case Operation::max:
    return larger(a, b);
  default:
    return ramp(a, b);
  }
}

double select(double condition, double a, double b)
{
  return std::isnan(condition) ? condition : (condition != 0.0 ? a : b);
}

double evaluate(std::span<const Instruction> code, const std::array<double, 4>& at, double tolerance)
{
  std::array<double, stack_size> stack{};
  std::size_t top = 0;
  for (const Instruction& instruction : code)
  {
    const Operation operation = instruction.operation;
    switch (instruction.arity)
    {
    case 0:
      stack[top++] = operation == Operation::number
                         ? instruction.value
                         : at[static_cast<std::size_t>(operation) - static_cast<std::size_t>(Operation::x)];
      break;
    case 1:
      stack[top - 1] = unary(operation, stack[top - 1]);
      break;
    case 2:
      top -= 1;
      stack[top - 1] = binary(operation, stack[top - 1], stack[top], tolerance);
      break;
    default:
      top -= 2;
      stack[top - 1] = select(stack[top - 1], stack[top], stack[top + 1]);
    }
  }
  return stack[0];
}

}  // namespace blockfsi::expression
