#pragma once

#include "core/expression.hpp"
#include "core/expression_program.hpp"

#include <span>
#include <string_view>

namespace blockfsi::expression
{

/// What a text is read as.
enum class Purpose
{
  /// A number; comparisons are exact.
  value,
  /// A set of points: the outermost operation must be a comparison or logic, and < and > include the edge of
  /// the set, since the end of a block edge at x = 0.2 should count for "x > 0.2".
  condition
};

/// Reads a formula by recursive descent. Throws Error as the constructors of Expression and Condition say.
Program parse(std::string_view text, const Constants& constants, std::span<const std::string_view> variables,
              Purpose purpose);

}  // namespace blockfsi::expression
