#include "case/sections.hpp"

#include "case/field.hpp"

#include <fmt/format.h>

#include <array>

namespace blockfsi::case_file
{

namespace
{

using solid::Parameters;

const solid::Parameters defaults;

constexpr Range poisson_range = {.low = -1.0,
                                 .high = 0.5,
                                 .low_allowed = false,
                                 .high_allowed = false,
                                 .words = "a number > -1 and < 0.5 (at 0.5 the material is incompressible)"};

constexpr std::array<std::string_view, 2> planes = {"strain", "stress"};

const Keys<solid::Newton>& newton_keys()
{
  static const Keys<solid::Newton> keys = {
      {{"tolerance", "number", fmt::format("{}", defaults.newton.tolerance), "-",
        "size of the last increment relative to the displacement"},
       [](const Value& v, Reading& r, solid::Newton& n) { n.tolerance = number(v, r.constants, positive); }},
      {{"iterations", "whole number", fmt::format("{}", defaults.newton.iterations), "", "at most"},
       [](const Value& v, Reading& r, solid::Newton& n)
       { n.iterations = integer(v, r.constants, 1, 1000); }}};
  return keys;
}

const Keys<Parameters>& material_keys()
{
  static const Keys<Parameters> keys = {
      {{"young", "number", "required", "Pa", "Young's modulus"},
       [](const Value& v, Reading& r, Parameters& p) { p.young = number(v, r.constants, positive); }},
      {{"poisson", "number", "required", "-", "Poisson's ratio, > -1 and < 0.5"},
       [](const Value& v, Reading& r, Parameters& p) { p.poisson = number(v, r.constants, poisson_range); }}};
  return keys;
}

const Keys<Parameters>& model_keys()
{
  static const Keys<Parameters> keys = {
      {{"saint_venant_kirchhoff", "table", "", "", "linear law for large rotations and small strains"},
       [](const Value& v, Reading& r, Parameters& p) { read_keys(v, material_keys(), r, p); }}};
  return keys;
}

const Keys<Parameters>& solid_keys()
{
  static const Keys<Parameters> keys = {
      {{"region", "text", defaults.region, "", "region of blocks that is solid"},
       [](const Value& v, Reading&, Parameters& p) { p.region = text(v); }},
      {{"order", "whole number", "that of [blocks]", "", "polynomial order of its cells, 1 to 8"},
       [](const Value& v, Reading& r, Parameters& p) { p.order = integer(v, r.constants, 1, 8); }},
      {{"divide", "number", fmt::format("{}", defaults.divide), "-",
        "its cells along an edge of the blocks, relative to those of the fluid; rounded, at least one"},
       [](const Value& v, Reading& r, Parameters& p) { p.divide = number(v, r.constants, positive); }},
      {{"density", "number", "required", "kg/m^3", "density of the undeformed body"},
       [](const Value& v, Reading& r, Parameters& p) { p.density = number(v, r.constants, positive); }},
      {{"model", "table", "required", "", "the material, one of the models below"},
       [](const Value& v, Reading& r, Parameters& p) { read_one(v, model_keys(), r, p); }},
      {{"plane", "\"strain\" or \"stress\"", std::string(planes[static_cast<std::size_t>(defaults.plane)]),
        "", "what the third direction does"},
       [](const Value& v, Reading&, Parameters& p)
       { p.plane = static_cast<solid::Plane>(choice(v, planes)); }},
      {{"body_force", "[formula, formula] in x, y, t", "[0, 0]", "m/s^2", "force per mass"},
       [](const Value& v, Reading& r, Parameters& p)
       { p.body_force = sampled_vector(v, r, in_space_and_time, p.region, false); }},
      {{"initial_velocity", "[formula, formula] in x, y", "[0, 0]", "m/s",
        "velocity of the undeformed body at the start"},
       [](const Value& v, Reading& r, Parameters& p)
       { p.initial_velocity = sampled_vector(v, r, in_space, p.region, false); }},
      {{"load_steps", "whole number", fmt::format("{}", defaults.load_steps), "",
        "steps in which the load of a static solution is raised"},
       [](const Value& v, Reading& r, Parameters& p) { p.load_steps = integer(v, r.constants, 1, 100000); }},
      {{"newton", "table", "see below", "", "Newton's method"},
       [](const Value& v, Reading& r, Parameters& p) { read_keys(v, newton_keys(), r, p.newton); }}};
  return keys;
}

solid::Displacement displacement(const Value& value, Reading& reading, const std::string& boundary)
{
  const Value::List& entries = list(value);
  if (entries.size() != 2)
    fail(value, fmt::format("found {}, allowed is a list of two numbers, formulas in x, y, t or \"free\"",
                            found(value)));
  solid::Displacement result;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const auto* word = std::get_if<std::string>(&entries[i].content);
    result.is_free[i] = word != nullptr && *word == "free";
    if (!result.is_free[i])
      result.value[i] = sampled(entries[i], reading, in_space_and_time, boundary, true);
  }
  if (result.is_free[0] && result.is_free[1])
    fail(value, "both directions are free; say free = true instead");
  return result;
}

const Keys<solid::BoundaryCondition>& condition_keys()
{
  using Target = solid::BoundaryCondition;
  static const Keys<Target> keys = {
      {{"fixed", "true", "", "", "no displacement"},
       [](const Value& v, Reading&, Target& b)
       {
         yes(v);
         b.condition = solid::Fixed{};
       }},
      {{"displacement", "[formula or \"free\", formula or \"free\"] in x, y, t", "", "m",
        "prescribed displacement; no traction where it is free"},
       [](const Value& v, Reading& r, Target& b) { b.condition = displacement(v, r, b.boundary); }},
      {{"traction", "0 or [formula, formula] in x, y, t", "", "Pa", "dead traction per undeformed area"},
       [](const Value& v, Reading& r, Target& b)
       { b.condition = solid::Traction{traction(v, r, b.boundary)}; }},
      {{"free", "true", "", "", "no traction"},
       [](const Value& v, Reading&, Target& b)
       {
         yes(v);
         b.condition = solid::Traction{};
       }}};
  return keys;
}

}  // namespace

void read_solid(const Value& value, Reading& reading, Parameters& parameters)
{
  // The region names the place where formulas of other keys are tried.
  if (const Value* region = value.find("region"))
    parameters.region = text(*region);
  read_keys(value, solid_keys(), reading, parameters,
            [&](const Field& field)
            {
              require_boundary(field, names(solid_keys()), reading);
              solid::BoundaryCondition condition{field.name, solid::Fixed{}, field.where};
              read_one(field.value, condition_keys(), reading, condition);
              parameters.boundaries.push_back(std::move(condition));
            });
}

std::vector<Section> solid_sections()
{
  return {section("[solid]", "the elastic body; left out: there is none", solid_keys()),
          section("[solid] model = { ... }", "one key of", model_keys()),
          section("[solid] model = { saint_venant_kirchhoff = { ... } }", "", material_keys()),
          section("[solid] newton = { ... }", "", newton_keys()),
          section("[solid] BOUNDARY = { ... }",
                  "one line for each boundary that touches the solid, one key of", condition_keys())};
}

}  // namespace blockfsi::case_file
