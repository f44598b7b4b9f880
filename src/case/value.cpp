#include "case/value.hpp"

#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blockfsi::case_file
{

namespace
{

[[noreturn]] void refuse(const Value& value, std::string_view allowed)
{
  fail(value, fmt::format("found {}, allowed is {}", found(value), allowed));
}

std::string found_number(const Value& value, double result)
{
  return std::holds_alternative<std::string>(value.content)
             ? fmt::format("{} = {}", found(value), number_text(result))
             : number_text(result);
}

}  // namespace

std::string number_text(double number)
{
  return std::isnan(number) ? "nan" : fmt::format("{}", number);
}

double number(const Value& value, const Constants& constants, const Range& range)
{
  double result = 0.0;
  if (const auto* whole = std::get_if<std::int64_t>(&value.content))
    result = static_cast<double>(*whole);
  else if (const auto* real = std::get_if<double>(&value.content))
    result = *real;
  else if (std::holds_alternative<std::string>(value.content))
    result = expression(value, constants, {})(0.0);
  else
    refuse(value, range.words);
  const bool inside = (range.low_allowed ? result >= range.low : result > range.low) &&
                      (range.high_allowed ? result <= range.high : result < range.high);
  if (!inside)
    fail(value, fmt::format("found {}, allowed is {}", found_number(value, result),
                            std::isfinite(result) ? range.words : "a finite number"));
  return result;
}

std::vector<double> numbers(const Value& value, const Constants& constants, const Range& range)
{
  std::vector<double> result;
  for (const Value& entry : list(value))
    result.push_back(number(entry, constants, range));
  return result;
}

int integer(const Value& value, const Constants& constants, int low, int high)
{
  const std::string words = fmt::format("a whole number from {} to {}", low, high);
  const double result = number(value, constants, {.words = words});
  if (result != std::floor(result) || result < low || result > high)
    fail(value, fmt::format("found {}, allowed is {}", found_number(value, result), words));
  return static_cast<int>(result);
}

void yes(const Value& value)
{
  const auto* flag = std::get_if<bool>(&value.content);
  if (!flag || !*flag)
    refuse(value, "true");
}

const std::string& text(const Value& value)
{
  const auto* content = std::get_if<std::string>(&value.content);
  if (!content)
    refuse(value, "a text in quotes");
  return *content;
}

const Value::List& list(const Value& value)
{
  const auto* content = std::get_if<Value::List>(&value.content);
  if (!content)
    refuse(value, "a list [...]");
  return *content;
}

const Value::Table& table(const Value& value)
{
  const auto* content = std::get_if<Value::Table>(&value.content);
  if (!content)
    refuse(value, "a table { key = value, ... }");
  return *content;
}

std::size_t choice(const Value& value, std::span<const std::string_view> allowed)
{
  const auto* content = std::get_if<std::string>(&value.content);
  const auto position = content ? std::find(allowed.begin(), allowed.end(), *content) : allowed.end();
  if (position == allowed.end())
    fail(value, fmt::format("found {}, allowed is one of {}{}", found(value), listed(allowed),
                            content ? did_you_mean(*content, allowed) : ""));
  return static_cast<std::size_t>(position - allowed.begin());
}

Expression expression(const Value& value, const Constants& constants,
                      std::span<const std::string_view> variables)
{
  if (const auto* content = std::get_if<std::string>(&value.content))
    return placed(value, [&] { return Expression(*content, constants, variables); });
  if (std::holds_alternative<std::int64_t>(value.content) || std::holds_alternative<double>(value.content))
    return Expression(number(value, constants));
  refuse(value, variables.empty() ? std::string("a number or a formula in the constants of [let]")
                                  : fmt::format("a number or a formula in {}", listed(variables)));
}

std::array<double, 3> point(const Value& value, const Constants& constants)
{
  const auto* content = std::get_if<Value::List>(&value.content);
  if (!content || content->size() != 2)
    refuse(value, "a list of two numbers [x, y]");
  return {number((*content)[0], constants), number((*content)[1], constants), 0.0};
}

std::array<Expression, 3> vector(const Value& value, const Constants& constants,
                                 std::span<const std::string_view> variables)
{
  const auto* content = std::get_if<Value::List>(&value.content);
  if (!content || content->size() != 2)
    refuse(value, fmt::format("a list of two numbers or formulas in {}", listed(variables)));
  return {expression((*content)[0], constants, variables), expression((*content)[1], constants, variables),
          Expression()};
}

Condition condition(const Value& value, const Constants& constants)
{
  return placed(value, [&] { return Condition(text(value), constants); });
}

}  // namespace blockfsi::case_file
