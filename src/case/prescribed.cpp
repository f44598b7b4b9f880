#include "case/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blockfsi::case_file
{

namespace
{

const Prescribed defaults;

const Keys<Prescribed>& prescribed_keys()
{
  static const Keys<Prescribed> keys = {
      {{"root", "[number, number]", "required", "m", "clamped end of the flap's straight centre line"},
       [](const Value& v, Reading& r, Prescribed& p) { p.root = point(v, r.constants); }},
      {{"tip", "[number, number]", "required", "m", "its other end"},
       [](const Value& v, Reading& r, Prescribed& p) { p.tip = point(v, r.constants); }},
      {{"angle", "number", fmt::format("{}", defaults.angle), "degrees", "of the tip at which sweeps end"},
       [](const Value& v, Reading& r, Prescribed& p) { p.angle = number(v, r.constants, positive); }},
      {{"step", "number", fmt::format("{}", defaults.step), "degrees", "between two positions"},
       [](const Value& v, Reading& r, Prescribed& p) { p.step = number(v, r.constants, positive); }},
      {{"show", "list of numbers", "[30, 60, 90, 120]", "degrees", "angles in tables and pictures"},
       [](const Value& v, Reading& r, Prescribed& p)
       {
         p.show.clear();
         for (const Value& entry : list(v))
           p.show.push_back(number(entry, r.constants, not_negative));
       }},
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
  if (std::hypot(prescribed.tip[0] - prescribed.root[0], prescribed.tip[1] - prescribed.root[1]) == 0.0)
    fail(value, "root and tip are the same point");
}

std::vector<Section> prescribed_sections()
{
  return {section("[prescribed]", "how `blockfsi compare --prescribed` bends a flap without a fluid",
                  prescribed_keys())};
}

}  // namespace blockfsi::case_file
