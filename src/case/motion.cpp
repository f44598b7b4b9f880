#include "case/sections.hpp"

#include "block/names.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace blockfsi::case_file
{

namespace
{

/// Rules with the layouts that their points are looked up in.
struct Rules
{
  const block::Layout& pieces;
  const block::Layout& merged;
  std::vector<block::Follow>& follows;
  Corners& corners;
};

constexpr std::array<std::string_view, 2> corner_choices = {"automatic", "fixed"};

/// The point of the merged layout that a point of the pieces became: the nearest one.
int merged_point(const Rules& rules, int point)
{
  const auto& x = rules.pieces.points[point].x;
  const auto distance = [&](const block::Point& p) { return std::hypot(p.x[0] - x[0], p.x[1] - x[1]); };
  const auto nearest_point = std::min_element(rules.merged.points.begin(), rules.merged.points.end(),
                                              [&](const block::Point& a, const block::Point& b)
                                              { return distance(a) < distance(b); });
  return static_cast<int>(nearest_point - rules.merged.points.begin());
}

int point_named(const Rules& rules, const Location& where, const std::string& path, const std::string& name)
{
  try
  {
    return merged_point(rules, block::find_point(rules.pieces, name));
  }
  catch (const Error& error)
  {
    throw error.within(path).at(where);
  }
}

block::Follow read_rule(const Field& field, Reading& reading, const Rules& rules)
{
  block::Follow follow;
  follow.point = point_named(rules, field.where, field.value.path, field.name);
  if (const auto* leader = std::get_if<std::string>(&field.value.content))
    follow.leaders.push_back({point_named(rules, field.value.where, field.value.path, *leader), 1.0});
  else if (const auto* leaders = std::get_if<Value::Table>(&field.value.content))
    for (const Field& entry : *leaders)
      follow.leaders.push_back({point_named(rules, entry.where, entry.value.path, entry.name),
                                number(entry.value, reading.constants)});
  else
    fail(field.value,
         fmt::format("found {}, allowed is the name of a point or a table {{ \"point\" = weight, ... }}",
                     found(field.value)));
  return follow;
}

const Keys<Rules>& regenerate_keys()
{
  static const Keys<Rules> keys = {
      {{"corners", "\"automatic\" or \"fixed\"", "automatic", "",
        "what corners inside the domain do that are not on the interface and have no rule in follows: "
        "automatic "
        "moves them smoothly with the interface, fixed leaves them where they are"},
       [](const Value& v, Reading&, Rules& rules)
       { rules.corners = static_cast<Corners>(choice(v, corner_choices)); }},
      {{"follows", "table \"point\" = \"leader\" or { \"leader\" = weight, ... }", "{}", "",
        "corners that move by the weighted displacements of others; corners on the interface move with it"},
       [](const Value& v, Reading& r, Rules& rules)
       {
         for (const Field& field : table(v))
           rules.follows.push_back(read_rule(field, r, rules));
       }}};
  return keys;
}

const Keys<Rules>& motion_keys()
{
  static const Keys<Rules> keys = {
      {{"regenerate", "table", "{}", "", "the fluid mesh is made anew from its blocks"},
       [](const Value& v, Reading& r, Rules& rules) { read_keys(v, regenerate_keys(), r, rules); }}};
  return keys;
}

}  // namespace

void read_motion(const Value& value, Reading& reading, const block::Layout& pieces,
                 const block::Layout& merged, std::vector<block::Follow>& follows, Corners& corners)
{
  Rules rules{pieces, merged, follows, corners};
  read_keys(value, motion_keys(), reading, rules);
}

std::vector<Section> motion_sections()
{
  return {section("[motion]", "how the fluid mesh follows the solid", motion_keys()),
          section("[motion] regenerate = { ... }", "", regenerate_keys())};
}

}  // namespace blockfsi::case_file
