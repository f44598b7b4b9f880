#pragma once

#include "case/tree.hpp"
#include "core/expression.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::case_file
{

/// Typed access to values. All throw Error at the value, saying what was found and what is allowed. Wherever
/// a number is allowed, so is a formula in the constants of [let].

/// What make() returns; an Error that it throws gets the value's path and place.
template <typename Make>
auto placed(const Value& value, const Make& make)
{
  try
  {
    return make();
  }
  catch (const Error& error)
  {
    throw error.within(value.path).at(value.where);
  }
}

/// Which numbers are allowed.
struct Range
{
  double low = -1e300;
  double high = 1e300;
  bool low_allowed = true;
  bool high_allowed = true;
  std::string_view words = "a number or a formula in the constants of [let]";  ///< for errors
};

inline constexpr Range positive = {.low = 0.0, .low_allowed = false, .words = "a number > 0"};
inline constexpr Range not_negative = {.low = 0.0, .words = "a number >= 0"};

/// A number for an error; the sign that some processors give to nan means nothing.
std::string number_text(double number);

/// A finite number.
double number(const Value& value, const Constants& constants, const Range& range = {});
/// A list of finite numbers.
std::vector<double> numbers(const Value& value, const Constants& constants, const Range& range = {});
/// A whole number from low to high.
int integer(const Value& value, const Constants& constants, int low, int high);
/// true; a false is refused, since leaving the key out says the same.
void yes(const Value& value);
const std::string& text(const Value& value);
const Value::List& list(const Value& value);
const Value::Table& table(const Value& value);
/// The position of a text in a list of allowed ones.
std::size_t choice(const Value& value, std::span<const std::string_view> allowed);
/// A formula in some of x, y, t.
Expression expression(const Value& value, const Constants& constants,
                      std::span<const std::string_view> variables);
/// A list of two numbers; the third is 0.
std::array<double, 3> point(const Value& value, const Constants& constants);
/// A list of two formulas; the third is 0.
std::array<Expression, 3> vector(const Value& value, const Constants& constants,
                                 std::span<const std::string_view> variables);
/// A condition on x and y.
Condition condition(const Value& value, const Constants& constants);

inline constexpr std::array<std::string_view, 3> in_space_and_time = {"x", "y", "t"};
inline constexpr std::array<std::string_view, 2> in_space = {"x", "y"};
inline constexpr std::array<std::string_view, 1> along_curve = {"t"};

}  // namespace blockfsi::case_file
