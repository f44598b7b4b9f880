#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace blockfsi::expression
{

/// What one instruction does with the top of the stack.
enum class Operation : std::uint8_t
{
  number,
  x,
  y,
  z,
  t,
  negate,
  invert,  ///< logical not
  add,
  subtract,
  multiply,
  divide,
  power,
  equal,
  differ,
  less,
  less_equal,
  both,    ///< logical and
  either,  ///< logical or
  abs,
  sqrt,
  exp,
  log,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  sinh,
  cosh,
  tanh,
  min,
  max,
  floor,
  step,
  select,
  ramp
};

/// One entry of a postfix program: takes `arity` values from the stack and puts one there.
struct Instruction
{
  Operation operation = Operation::number;
  std::uint8_t arity = 0;
  double value = 0.0;  ///< of a number
};

/// The largest number of values that a program may have on its stack.
inline constexpr std::size_t stack_size = 64;

/// A parsed formula.
struct Program
{
  std::string text;
  std::vector<Instruction> code;
  std::array<bool, 4> uses{};  ///< whether x, y, z, t occur
};

/// The value of a formula at (x, y, z, t). Two numbers count as equal if they differ by at most `tolerance`,
/// and
/// <= is "less or equal" in that sense. Allocates nothing.
double evaluate(std::span<const Instruction> code, const std::array<double, 4>& at, double tolerance);

/// The single operations of which `evaluate` is made, by their number of arguments.
double unary(Operation operation, double a);
double binary(Operation operation, double a, double b, double tolerance);
/// `a` if the condition holds, else `b`; a condition that is nan chooses neither.
double select(double condition, double a, double b);

}  // namespace blockfsi::expression
