#include "core/expression.hpp"

#include "core/expression_block.hpp"
#include "core/expression_parser.hpp"
#include "core/expression_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace blockfsi
{

struct Expression::Program : expression::Program
{
};

struct Condition::Program : expression::Program
{
};

namespace
{

constexpr std::array<std::string_view, 3> space = {"x", "y", "z"};

expression::Program number(double value)
{
  return {fmt::format("{}", value), {{expression::Operation::number, 0, value}}, {}};
}

using Block = std::array<std::array<double, expression::block_size>, 4>;

/// The points from `begin` on as rows x, y, z, t; the last point fills what is left of the block.
Block block_of(std::span<const std::array<double, 3>> points, std::size_t begin, double t)
{
  Block at;
  for (std::size_t i = 0; i < expression::block_size; ++i)
  {
    const std::array<double, 3>& x = points[std::min(begin + i, points.size() - 1)];
    for (std::size_t c = 0; c < 3; ++c)
      at[c][i] = x[c];
    at[3][i] = t;
  }
  return at;
}

}  // namespace

Expression::Expression()
{
  // Parameter structs are full of zeros: they share one.
  static const auto zero = std::make_shared<const Program>(Program{number(0.0)});
  program_ = zero;
}

Expression::Expression(double value) : program_(std::make_shared<const Program>(Program{number(value)})) {}

Expression::Expression(std::string_view text, const Constants& constants,
                       std::span<const std::string_view> variables)
    : program_(std::make_shared<const Program>(
          Program{expression::parse(text, constants, variables, expression::Purpose::value)}))
{
}

double Expression::operator()(double x, double y, double z, double t) const
{
  return expression::evaluate(program_->code, {x, y, z, t}, 0.0);
}

Expression::Derivatives Expression::derivatives(double x, double y, double z, double t) const
{
  const auto numbers = expression::evaluate<1, 4>(program_->code, {{{x}, {y}, {z}, {t}}});
  Derivatives result{numbers.value[0], {}};
  for (std::size_t d = 0; d < 4; ++d)
    result.by[d] = numbers.derivative[d][0];
  return result;
}

void Expression::evaluate(std::span<const std::array<double, 3>> points, double t,
                          std::span<double> values) const
{
  for (std::size_t begin = 0; begin < points.size(); begin += expression::block_size)
  {
    const auto numbers =
        expression::evaluate<expression::block_size, 0>(program_->code, block_of(points, begin, t));
    const std::size_t count = std::min(expression::block_size, points.size() - begin);
    std::copy_n(numbers.value.begin(), count, values.begin() + static_cast<std::ptrdiff_t>(begin));
  }
}

void Expression::evaluate(std::span<const std::array<double, 3>> points, double t, std::span<double> values,
                          std::span<std::array<double, 3>> gradients) const
{
  for (std::size_t begin = 0; begin < points.size(); begin += expression::block_size)
  {
    const auto numbers =
        expression::evaluate<expression::block_size, 3>(program_->code, block_of(points, begin, t));
    const std::size_t count = std::min(expression::block_size, points.size() - begin);
    for (std::size_t i = 0; i < count; ++i)
    {
      values[begin + i] = numbers.value[i];
      for (std::size_t d = 0; d < 3; ++d)
        gradients[begin + i][d] = numbers.derivative[d][i];
    }
  }
}

bool Expression::is_constant() const
{
  return program_->uses == std::array<bool, 4>{};
}

bool Expression::depends_on_time() const
{
  return program_->uses[3];
}

const std::string& Expression::text() const
{
  return program_->text;
}

Condition::Condition(std::string_view text, const Constants& constants)
    : program_(std::make_shared<const Program>(
          Program{expression::parse(text, constants, space, expression::Purpose::condition)}))
{
}

bool Condition::holds(double x, double y, double z, double tolerance) const
{
  return expression::evaluate(program_->code, {x, y, z, 0.0}, tolerance) != 0.0;
}

const std::string& Condition::text() const
{
  return program_->text;
}

}  // namespace blockfsi
