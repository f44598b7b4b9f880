#include "case/level_set.hpp"
#include "case/sections.hpp"
#include "geometry/point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blockfsi::case_file
{

namespace
{

const Prescribed defaults;

constexpr Range share = {.low = 0.0, .high = 1.0, .low_allowed = false, .words = "a number > 0 and <= 1"};

const Keys<Prescribed>& prescribed_keys()
{
  static const Keys<Prescribed> keys = {
      {{"root", "list of numbers", "required", "m", "clamped end of the flap's straight centre line"},
       [](const Value& v, Reading& r, Prescribed& p) { p.root = point_in_space(v, r.constants); }},
      {{"tip", "list of numbers", "required", "m", "its other end"},
       [](const Value& v, Reading& r, Prescribed& p) { p.tip = point_in_space(v, r.constants); }},
      {{"axis", "[number, number, number]", "[0, 0, 1]", "",
        "direction about which the flap turns, perpendicular to its centre line; in space"},
       [](const Value& v, Reading& r, Prescribed& p) { p.axis = point_in_space(v, r.constants); }},
      {{"bent", "number", fmt::format("{}", defaults.bent), "",
        "share of the length, from the root on, in which rotation bends the flap"},
       [](const Value& v, Reading& r, Prescribed& p) { p.bent = number(v, r.constants, share); }},
      {{"angle", "number", fmt::format("{}", defaults.angle), "degrees", "of the tip at which sweeps end"},
       [](const Value& v, Reading& r, Prescribed& p) { p.angle = number(v, r.constants, positive); }},
      {{"step", "number", fmt::format("{}", defaults.step), "degrees", "between two positions"},
       [](const Value& v, Reading& r, Prescribed& p) { p.step = number(v, r.constants, positive); }},
      {{"show", "list of numbers", "[30, 60, 90, 120]", "degrees", "angles in tables and pictures"},
       [](const Value& v, Reading& r, Prescribed& p) { p.show = numbers(v, r.constants, not_negative); }},
      {{"amplitude", "number", fmt::format("{}", defaults.amplitude), "degrees", "of the cycles"},
       [](const Value& v, Reading& r, Prescribed& p) { p.amplitude = number(v, r.constants, positive); }},
      {{"cycles", "whole number", fmt::format("{}", defaults.cycles), "", "of rotation to and fro"},
       [](const Value& v, Reading& r, Prescribed& p) { p.cycles = integer(v, r.constants, 0, 1000); }}};
  return keys;
}

}  // namespace

void read_prescribed(const Value& value, Reading& reading, Prescribed& prescribed)
{
  read_keys(value, prescribed_keys(), reading, prescribed);
  const geometry::Point along = geometry::subtract(prescribed.tip, prescribed.root);
  if (geometry::norm(along) == 0.0)
    fail(value, "root and tip are the same point");
  constexpr double tolerance = 1e-9;
  const double size = geometry::norm(prescribed.axis) * geometry::norm(along);
  if (size == 0.0 || std::abs(geometry::dot(along, prescribed.axis)) > tolerance * size)
    fail(value, "axis must be a direction perpendicular to the line from root to tip");
}

std::vector<Section> prescribed_sections()
{
  return {section("[prescribed]", "how `blockfsi compare --prescribed` bends a flap without a fluid",
                  prescribed_keys())};
}

}  // namespace blockfsi::case_file
