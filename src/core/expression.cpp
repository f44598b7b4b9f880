#include "core/expression.hpp"

#include "core/expression_parser.hpp"
#include "core/expression_program.hpp"

#include <fmt/format.h>

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
