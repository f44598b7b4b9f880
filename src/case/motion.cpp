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

/// A motion with the layouts that its points are looked up in.
struct Rules
{
  const block::Layout& pieces;
  const block::Layout& merged;
  Motion& motion;
};

/// Parameters of a motion with all that reading it needs.
template <typename T>
struct Draft
{
  const Rules& rules;
  T parameters;
};

/// The names of block::CornerRule in its order.
constexpr std::array<std::string_view, 5> corner_choices = {"automatic", "fixed", "radial", "elastic",
                                                            "nonlinear"};
constexpr std::array<std::string_view, 2> from_choices = {"first", "last"};
constexpr std::array<std::string_view, 2> slope_choices = {"turned", "zero"};
constexpr Range poisson_range = {.low = -1.0,
                                 .high = 0.5,
                                 .low_allowed = false,
                                 .high_allowed = false,
                                 .words = "a number > -1 and < 0.5"};

/// Boundaries along which corners slide; they must exist.
std::vector<std::string> read_slide(const Value& value, const Rules& rules)
{
  std::vector<std::string> known;
  for (const block::Boundary& boundary : rules.merged.boundaries)
    known.push_back(boundary.name);
  std::vector<std::string> names;
  for (const Value& entry : list(value))
  {
    names.push_back(text(entry));
    if (std::find(known.begin(), known.end(), names.back()) == known.end())
      fail(entry, fmt::format("there is no boundary '{}'; the boundaries are {}{}", names.back(),
                              listed(known), did_you_mean(names.back(), known)));
  }
  return names;
}

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
      {{"corners", "\"automatic\", \"radial\", \"elastic\", \"nonlinear\" or \"fixed\"", "automatic", "",
        "what corners do that are not on the interface, not held by a boundary and without a rule in "
        "follows: "
        "elastic and radial move them linearly with the interface, nonlinear to where the blocks are least "
        "distorted, fixed leaves them where they are; automatic is elastic, in space radial"},
       [](const Value& v, Reading&, Rules& rules)
       { rules.motion.corners.rule = static_cast<block::CornerRule>(choice(v, corner_choices)); }},
      {{"follows", "table \"point\" = \"leader\" or { \"leader\" = weight, ... }", "{}", "",
        "corners that move by the weighted displacements of others; corners on the interface move with it"},
       [](const Value& v, Reading& r, Rules& rules)
       {
         for (const Field& field : table(v))
           rules.motion.corners.follows.push_back(read_rule(field, r, rules));
       }},
      {{"slide", "list of boundaries", "walls and slip", "",
        "boundaries along which corners move where they are straight; elsewhere corners on boundaries stay"},
       [](const Value& v, Reading&, Rules& rules) { rules.motion.corners.slide = read_slide(v, rules); }}};
  return keys;
}

const Keys<motion::Falloff>& falloff_keys()
{
  using motion::Falloff;
  static const Keys<Falloff> keys = {
      {{"weight", "number", "1", "-", "stiffness at distance 0"},
       [](const Value& v, Reading& r, Falloff& f) { f.weight = number(v, r.constants, positive); }},
      {{"length", "number", "required", "m", "distance at which it has fallen by 2 to the exponent"},
       [](const Value& v, Reading& r, Falloff& f) { f.length = number(v, r.constants, positive); }},
      {{"exponent", "number", "2", "-", "how steeply it falls: weight (1 + d / length)^-exponent"},
       [](const Value& v, Reading& r, Falloff& f) { f.exponent = number(v, r.constants, not_negative); }}};
  return keys;
}

motion::Falloff read_falloff(const Value& value, Reading& reading)
{
  motion::Falloff falloff;
  falloff.weight = 1.0;
  read_keys(value, falloff_keys(), reading, falloff);
  return falloff;
}

/// Keys of all equations that have a stiffness.
template <typename T>
Keys<Draft<T>> stiffness_keys()
{
  return {{{"base", "number", "1, or 0 with near_interface or near_points", "-", "stiffness far away"},
           [](const Value& v, Reading& r, Draft<T>& d)
           { d.parameters.stiffness.base = number(v, r.constants, not_negative); }},
          {{"near_interface", "table", "none", "", "added stiffness near the interface"},
           [](const Value& v, Reading& r, Draft<T>& d)
           { d.parameters.stiffness.interface = read_falloff(v, r); }},
          {{"near_points", "table", "none", "", "added stiffness near the points"},
           [](const Value& v, Reading& r, Draft<T>& d)
           { d.parameters.stiffness.points = read_falloff(v, r); }},
          {{"points", "list of names of points", "[]", "", "corners that near_points means"},
           [](const Value& v, Reading&, Draft<T>& d)
           {
             for (const Value& entry : list(v))
               d.parameters.stiffness.at.push_back(
                   d.rules.merged.points[point_named(d.rules, entry.where, entry.path, text(entry))].x);
           }},
          {{"jacobian", "number", "1", "-",
            "exponent with which cells are stiffer the smaller they are, 0: not at all"},
           [](const Value& v, Reading& r, Draft<T>& d)
           { d.parameters.stiffness.jacobian = number(v, r.constants, not_negative); }},
          {{"from", "\"first\" or \"last\"", "first", "",
            "mesh from which the displacement is counted: the first one, or that of the last step, in small "
            "increments that add up"},
           [](const Value& v, Reading&, Draft<T>& d)
           { d.parameters.from = static_cast<motion::From>(choice(v, from_choices)); }}};
}

template <typename T>
Key<Draft<T>> slide_key()
{
  return {{"slide", "list of names of boundaries", "[]", "",
           "straight boundaries along x or y on which nodes may slide"},
          [](const Value& v, Reading&, Draft<T>& d)
          {
            for (const Value& entry : list(v))
              d.parameters.slide.push_back(text(entry));
          }};
}

const Keys<Draft<motion::PseudoSolid>>& pseudo_solid_keys()
{
  using Target = Draft<motion::PseudoSolid>;
  static const Keys<Target> keys = []
  {
    Keys<Target> result = stiffness_keys<motion::PseudoSolid>();
    result.push_back({{"poisson", "number", "0.3", "-", "Poisson's ratio of the mesh"},
                      [](const Value& v, Reading& r, Target& d)
                      { d.parameters.poisson = number(v, r.constants, poisson_range); }});
    result.push_back(slide_key<motion::PseudoSolid>());
    return result;
  }();
  return keys;
}

const Keys<Draft<motion::Harmonic>>& harmonic_keys()
{
  using Target = Draft<motion::Harmonic>;
  static const Keys<Target> keys = []
  {
    Keys<Target> result = stiffness_keys<motion::Harmonic>();
    result.push_back(slide_key<motion::Harmonic>());
    return result;
  }();
  return keys;
}

const Keys<Draft<motion::Biharmonic>>& biharmonic_keys()
{
  using Target = Draft<motion::Biharmonic>;
  static const Keys<Target> keys = {
      {{"slope", "\"turned\" or \"zero\"", "turned", "",
        "normal derivative of the displacement at the interface: that of a mesh that turns with it, or zero"},
       [](const Value& v, Reading&, Target& d)
       { d.parameters.slope = static_cast<motion::Slope>(choice(v, slope_choices)); }},
      slide_key<motion::Biharmonic>()};
  return keys;
}

template <typename T>
void read_equation(const Value& value, const Keys<Draft<T>>& keys, Reading& reading, Rules& rules)
{
  Draft<T> draft{rules, {}};
  read_keys(value, keys, reading, draft);
  if constexpr (requires { draft.parameters.stiffness; })
  {
    motion::Stiffness& stiffness = draft.parameters.stiffness;
    const bool near = stiffness.interface.weight > 0.0 || stiffness.points.weight > 0.0;
    if (near && !value.find("base"))
      stiffness.base = 0.0;
    if (!near && stiffness.base == 0.0)
      fail(value, "nothing makes the mesh stiff; give base > 0, near_interface or near_points");
    if ((stiffness.points.weight > 0.0) != !stiffness.at.empty())
      fail(value, "near_points and points belong together: give both or none");
  }
  rules.motion.update = std::move(draft.parameters);
}

const Keys<Rules>& motion_keys()
{
  static const Keys<Rules> keys = {
      {{"regenerate", "table", "{}", "", "the fluid mesh is made anew from its blocks; the default"},
       [](const Value& v, Reading& r, Rules& rules)
       {
         rules.motion.update = motion::Regeneration{};
         read_keys(v, regenerate_keys(), r, rules);
       }},
      {{"pseudo_solid", "table", "", "", "the fluid mesh deforms like a linear elastic body"},
       [](const Value& v, Reading& r, Rules& rules) { read_equation(v, pseudo_solid_keys(), r, rules); }},
      {{"harmonic", "table", "", "", "each component of its displacement obeys a diffusion equation"},
       [](const Value& v, Reading& r, Rules& rules) { read_equation(v, harmonic_keys(), r, rules); }},
      {{"biharmonic", "table", "", "", "each component of its displacement obeys the biharmonic equation"},
       [](const Value& v, Reading& r, Rules& rules) { read_equation(v, biharmonic_keys(), r, rules); }}};
  return keys;
}

}  // namespace

void read_motion(const Value& value, Reading& reading, const block::Layout& pieces,
                 const block::Layout& merged, Motion& motion)
{
  Rules rules{pieces, merged, motion};
  motion.where = value.where;
  if (table(value).size() > 1)
    fail(value, fmt::format("found {} keys, allowed is one of {}", table(value).size(),
                            listed(names(motion_keys()))));
  read_keys(value, motion_keys(), reading, rules);
}

std::vector<Section> motion_sections()
{
  return {section("[motion]", "how the fluid mesh follows the solid; one key of", motion_keys()),
          section("[motion] regenerate = { ... }", "", regenerate_keys()),
          section("[motion] pseudo_solid = { ... }", "", pseudo_solid_keys()),
          section("[motion] harmonic = { ... }", "", harmonic_keys()),
          section("[motion] biharmonic = { ... }", "", biharmonic_keys()),
          section("near_interface = { ... }, near_points = { ... }", "", falloff_keys())};
}

void read_compare(const Value& value, Reading& reading, const block::Layout& pieces,
                  const block::Layout& merged, std::vector<std::pair<std::string, Motion>>& variants)
{
  for (const Field& field : table(value))
  {
    Motion& motion = variants.emplace_back(field.name, Motion{}).second;
    read_motion(field.value, reading, pieces, merged, motion);
  }
}

std::vector<Section> compare_sections()
{
  return {{"[compare.NAME]",
           "a way of moving the mesh for `blockfsi compare --motion NAME`",
           {{"NAME", "table", "", "", "one key of [motion]"}}}};
}

}  // namespace blockfsi::case_file
