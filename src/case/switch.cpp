#include "case/sections.hpp"

#include <fmt/format.h>

namespace blockfsi::case_file
{

namespace
{

constexpr Range quality = {.low = 0.0, .high = 1.0, .high_allowed = false, .words = "a number >= 0 and < 1"};

const Keys<Second>& switch_keys()
{
  static const Keys<Second> keys = {
      {{"to", "text", "required", "",
        "case file, beside this one, with other blocks of fluid around the same body; it takes over at the "
        "latest when a "
        "step fails because the mesh is not valid"},
       [](const Value& v, Reading&, Second& s) { s.path = text(v); }},
      {{"below", "number", "0", "-", "it takes over after a step with a scaled Jacobian below this"},
       [](const Value& v, Reading& r, Second& s) { s.below = number(v, r.constants, quality); }},
      {{"at", "number", "never", "s", "it takes over after the step that reaches this time"},
       [](const Value& v, Reading& r, Second& s) { s.at = number(v, r.constants, positive); }}};
  return keys;
}

}  // namespace

void read_switch(const Value& value, Reading& reading, const std::filesystem::path& file, Second& second)
{
  read_keys(value, switch_keys(), reading, second);
  second.where = value.where;
  const std::filesystem::path path = file.parent_path() / second.path;
  if (!std::filesystem::exists(path))
    fail(*value.find("to"), fmt::format("there is no case file '{}' beside this one", second.path.string()));
  second.path = path;
}

std::vector<Section> switch_sections()
{
  return {
      section("[switch]", "another layout of blocks, which takes over the state of this one", switch_keys())};
}

}  // namespace blockfsi::case_file
