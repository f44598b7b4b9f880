#include "case/sections.hpp"

#include "case/field.hpp"

#include <fmt/format.h>

namespace blockfsi::case_file
{

namespace
{

using fluid::Parameters;

const fluid::Parameters defaults;

const Keys<fluid::Newton>& newton_keys()
{
  static const Keys<fluid::Newton> keys = {
      {{"tolerance", "number", fmt::format("{}", defaults.newton.tolerance), "-",
        "size of the last increment relative to the solution"},
       [](const Value& v, Reading& r, fluid::Newton& n) { n.tolerance = number(v, r.constants, positive); }},
      {{"iterations", "whole number", fmt::format("{}", defaults.newton.iterations), "", "at most"},
       [](const Value& v, Reading& r, fluid::Newton& n)
       { n.iterations = integer(v, r.constants, 1, 1000); }}};
  return keys;
}

const Keys<Parameters>& fluid_keys()
{
  static const Keys<Parameters> keys = {
      {{"region", "text", defaults.region, "", "region of blocks that is fluid"},
       [](const Value& v, Reading&, Parameters& p) { p.region = text(v); }},
      {{"density", "number", "required", "kg/m^3", "density"},
       [](const Value& v, Reading& r, Parameters& p) { p.density = number(v, r.constants, positive); }},
      {{"viscosity", "number", "required", "Pa s", "dynamic viscosity"},
       [](const Value& v, Reading& r, Parameters& p) { p.viscosity = number(v, r.constants, positive); }},
      {{"body_force", "[formula, formula] in x, y, t", "[0, 0]", "m/s^2", "force per mass"},
       [](const Value& v, Reading& r, Parameters& p)
       { p.body_force = sampled_vector(v, r, in_space_and_time, p.region, false); }},
      {{"initial_velocity", "[formula, formula] in x, y", "[0, 0]", "m/s", "velocity at the start"},
       [](const Value& v, Reading& r, Parameters& p)
       { p.initial_velocity = sampled_vector(v, r, in_space, p.region, false); }},
      {{"backflow", "number", fmt::format("{}", defaults.backflow), "-",
        "stabilisation against flow coming in through traction and outflow boundaries; 0 where flow shall "
        "enter there, as from a prescribed pressure"},
       [](const Value& v, Reading& r, Parameters& p) { p.backflow = number(v, r.constants, not_negative); }},
      {{"stabilisation_time", "number", "the step", "s",
        "what stands for the step in the stabilisation; fix it to compare results of different steps"},
       [](const Value& v, Reading& r, Parameters& p)
       { p.stabilisation_time = number(v, r.constants, positive); }},
      {{"newton", "table", "see below", "", "Newton's method"},
       [](const Value& v, Reading& r, Parameters& p) { read_keys(v, newton_keys(), r, p.newton); }}};
  return keys;
}

const Keys<fluid::BoundaryCondition>& condition_keys()
{
  using Target = fluid::BoundaryCondition;
  static const Keys<Target> keys = {
      {{"velocity", "[formula, formula] in x, y, t", "", "m/s", "prescribed velocity"},
       [](const Value& v, Reading& r, Target& b)
       { b.condition = fluid::Velocity{sampled_vector(v, r, in_space_and_time, b.boundary, true)}; }},
      {{"wall", "true", "", "", "no slip on a wall at rest"},
       [](const Value& v, Reading&, Target& b)
       {
         yes(v);
         b.condition = fluid::Wall{};
       }},
      {{"slip", "true", "", "", "no flow through a straight boundary along an axis, no shear"},
       [](const Value& v, Reading&, Target& b)
       {
         yes(v);
         b.condition = fluid::Slip{};
       }},
      {{"traction", "0 or [formula, formula] in x, y, t", "", "Pa", "prescribed traction sigma n"},
       [](const Value& v, Reading& r, Target& b)
       { b.condition = fluid::Traction{traction(v, r, b.boundary)}; }},
      {{"outflow", "true or formula in x, y, t", "", "Pa",
        "do-nothing outflow against a pressure: mu du/dn - p n = -outflow n"},
       [](const Value& v, Reading& r, Target& b)
       {
         if (std::holds_alternative<bool>(v.content))
         {
           yes(v);
           b.condition = fluid::Outflow{};
         }
         else
           b.condition = fluid::Outflow{sampled(v, r, in_space_and_time, b.boundary, true)};
       }}};
  return keys;
}

}  // namespace

void read_fluid(const Value& value, Reading& reading, Parameters& parameters)
{
  // The region names the place where formulas of other keys are tried.
  if (const Value* region = value.find("region"))
    parameters.region = text(*region);
  read_keys(value, fluid_keys(), reading, parameters,
            [&](const Field& field)
            {
              require_boundary(field, names(fluid_keys()), reading);
              fluid::BoundaryCondition condition{field.name, fluid::Wall{}, field.where};
              read_one(field.value, condition_keys(), reading, condition);
              parameters.boundaries.push_back(std::move(condition));
            });
}

std::vector<Section> fluid_sections()
{
  return {section("[fluid]", "the incompressible fluid; left out: there is none", fluid_keys()),
          section("[fluid] newton = { ... }", "", newton_keys()),
          section("[fluid] BOUNDARY = { ... }",
                  "one line for each boundary that touches the fluid, one key of", condition_keys())};
}

}  // namespace blockfsi::case_file
