#include "case/sections.hpp"

#include "core/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace blockfsi::case_file
{

namespace
{

/// Whether a formula reads the name as a constant, rather than as a variable, a function or several words.
bool is_free(const std::string& name)
{
  static constexpr std::array<std::string_view, 4> variables = {"x", "y", "z", "t"};
  const auto is_letter = [](char c)
  { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
  if (name == "pi" || name.empty() || !std::all_of(name.begin(), name.end(), is_letter) ||
      (name.front() >= '0' && name.front() <= '9'))
    return false;
  try
  {
    return Expression(name, Constants{{name, 1.0}}, variables).is_constant();
  }
  catch (const Error&)
  {
    return false;
  }
}

}  // namespace

Constants read_let(const Value& value)
{
  Constants constants;
  for (const Field& field : table(value))
  {
    if (!is_free(field.name))
      throw Error(
          field.where,
          fmt::format("{}: '{}' cannot name a constant, allowed are letters, digits and _ that start with a "
                      "letter and are not x, y, z, t, pi, and, or, not or a function",
                      field.value.path, field.name));
    constants[field.name] = number(field.value, constants);
  }
  return constants;
}

std::vector<Section> let_sections()
{
  return {{"[let]",
           "constants for all formulas; later ones may use earlier ones",
           {{"NAME", "number or formula in constants", "", "", "value of the constant"}}}};
}

}  // namespace blockfsi::case_file
