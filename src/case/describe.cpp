#include "case/describe.hpp"

#include "case/sections.hpp"

#include <fmt/format.h>

#include <string_view>

namespace blockfsi::case_file
{

namespace
{

constexpr std::string_view introduction =
    "A case file is written in TOML. Wherever a number is allowed, so is a formula in the constants of "
    "[let], in\n"
    "quotes: \"2 * U\". Formulas know + - * / ^, comparisons, and, or, not, pi and the functions abs, sqrt, "
    "exp,\n"
    "log, sin, cos, tan, asin, acos, atan, atan2, sinh, cosh, tanh, min, max, pow, floor, step(a), if(c, a, "
    "b) and\n"
    "ramp(t, T), which rises smoothly from 0 to 1 while t goes from 0 to T. All units are SI.\n";

std::string text_of(const Description& key)
{
  std::string text = fmt::format("  {}: {}\n      {}", key.name, key.meaning, key.type);
  if (!key.unit.empty())
    text += fmt::format(" [{}]", key.unit);
  if (key.fallback.starts_with("required"))
    text += "; " + key.fallback;
  else if (!key.fallback.empty())
    text += "; default: " + key.fallback;
  return text + "\n";
}

}  // namespace

std::string describe()
{
  std::string text(introduction);
  for (const Section& section : all_sections())
  {
    text += "\n" + section.title + (section.meaning.empty() ? "" : "  # " + section.meaning) + "\n";
    for (const Description& key : section.keys)
      text += text_of(key);
  }
  return text;
}

}  // namespace blockfsi::case_file
