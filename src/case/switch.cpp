#include "case/sections.hpp"

#include <fmt/format.h>

namespace blockfsi::case_file
{

namespace
{

constexpr Range quality = {.low = 0.0, .high = 1.0, .high_allowed = false, .words = "a number >= 0 and < 1"};

const Keys<Switch>& switch_keys()
{
  static const Keys<Switch> keys = {
      {{"to", "text", "required", "",
        "case file, beside this one, with other blocks of fluid around the same body; it takes over at the "
        "latest when a step fails because the mesh is not valid"},
       [](const Value& v, Reading&, Switch& s) { s.path = text(v); }},
      {{"below", "number", "0", "-", "it takes over after a step with a scaled Jacobian below this"},
       [](const Value& v, Reading& r, Switch& s) { s.below = number(v, r.constants, quality); }},
      {{"at", "number", "never", "s", "it takes over after the step that reaches this time"},
       [](const Value& v, Reading& r, Switch& s) { s.at = number(v, r.constants, positive); }}};
  return keys;
}

Switch read_switch(const Value& value, Reading& reading, const std::filesystem::path& file)
{
  Switch result;
  read_keys(value, switch_keys(), reading, result);
  result.where = value.where;
  result.path = file.parent_path() / result.path;
  if (!std::filesystem::exists(result.path))
    fail(*value.find("to"),
         fmt::format("there is no case file '{}' beside this one", text(*value.find("to"))));
  return result;
}

}  // namespace

void read_switches(const Value& value, Reading& reading, const std::filesystem::path& file,
                   std::vector<Switch>& switches)
{
  if (std::holds_alternative<Value::Table>(value.content))
    switches.push_back(read_switch(value, reading, file));
  else if (const auto* entries = std::get_if<Value::List>(&value.content))
    for (const Value& entry : *entries)
      switches.push_back(read_switch(entry, reading, file));
  else
    fail(value, fmt::format("found {}, allowed is a table [switch] or several [[switch]]", found(value)));
}

std::vector<Section> switch_sections()
{
  return {
      section("[switch]",
              "another layout of blocks, which takes over the state of this one; [[switch]] once for each if "
              "there are several, in their order",
              switch_keys())};
}

}  // namespace blockfsi::case_file
