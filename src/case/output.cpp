#include "case/sections.hpp"

#include <fmt/format.h>

#include <array>

namespace blockfsi::case_file
{

namespace
{

using output::Force;
using output::Parameters;
using output::Probe;

const Parameters defaults;

constexpr std::array<std::string_view, 3> quantities = {"displacement", "velocity", "pressure"};

const Keys<Probe>& probe_keys()
{
  static const Keys<Probe> keys = {
      {{"at", "[number, number]", "required", "m", "place of the probe in the undeformed domain"},
       [](const Value& v, Reading& r, Probe& p) { p.at = point(v, r.constants); }},
      {{"of", "\"displacement\", \"velocity\" or \"pressure\"", "required", "",
        "quantity: displacement of the solid, velocity or pressure of the fluid"},
       [](const Value& v, Reading&, Probe& p) { p.of = quantities[choice(v, quantities)]; }}};
  return keys;
}

/// Names become columns of tables.
void check_name(const Field& field)
{
  if (field.name.empty() || field.name.find_first_of(",\"\r\n") != std::string::npos)
    throw Error(field.where,
                fmt::format("{}: found the name \"{}\", allowed are names without commas, quotes and "
                            "line breaks: they head the columns of the results",
                            field.value.path, field.name));
}

void read_probes(const Value& value, Reading& reading, Parameters& parameters)
{
  for (const Field& field : table(value))
  {
    check_name(field);
    Probe probe{field.name, {}, "", field.where};
    read_keys(field.value, probe_keys(), reading, probe);
    parameters.probes.push_back(std::move(probe));
  }
}

void read_forces(const Value& value, Parameters& parameters)
{
  if (const auto* entries = std::get_if<Value::List>(&value.content))
  {
    for (const Value& entry : *entries)
      parameters.forces.push_back({text(entry), {text(entry)}, entry.where});
    return;
  }
  if (!std::holds_alternative<Value::Table>(value.content))
    fail(value, fmt::format("found {}, allowed is a list of names or a table {{ NAME = [names], ... }}",
                            found(value)));
  for (const Field& field : table(value))
  {
    check_name(field);
    Force force{field.name, {}, field.value.where};
    for (const Value& entry : list(field.value))
      force.on.push_back(text(entry));
    if (force.on.empty())
      fail(field.value, "found an empty list, allowed are names of boundaries or of the solid's region");
    parameters.forces.push_back(std::move(force));
  }
}

const Keys<Parameters>& output_keys()
{
  static const Keys<Parameters> keys = {
      {{"directory", "text", "results/ beside the case file", "", "folder of all results"},
       [](const Value& v, Reading&, Parameters& p) { p.directory = text(v); }},
      {{"every", "number", fmt::format("{}", defaults.every), "s",
        "simulated time between field files, 0: only the last state"},
       [](const Value& v, Reading& r, Parameters& p) { p.every = number(v, r.constants, not_negative); }},
      {{"checkpoint_every", "whole number", fmt::format("{}", defaults.checkpoint_every), "steps",
        "time steps between checkpoints"},
       [](const Value& v, Reading& r, Parameters& p)
       { p.checkpoint_every = integer(v, r.constants, 1, 1000000000); }},
      {{"probes", "table { NAME = { ... } }", "{}", "", "quantities followed at points"},
       [](const Value& v, Reading& r, Parameters& p) { read_probes(v, r, p); }},
      {{"forces", "list of names or table { NAME = [names] }", "[]", "N/m",
        "force of the fluid on boundaries and the solid (by its region), each alone or summed"},
       [](const Value& v, Reading&, Parameters& p) { read_forces(v, p); }}};
  return keys;
}

}  // namespace

void read_output(const Value& value, Reading& reading, Parameters& parameters)
{
  read_keys(value, output_keys(), reading, parameters);
}

std::vector<Section> output_sections()
{
  return {section("[output]", "", output_keys()),
          section("[output] probes = { NAME = { ... } }", "", probe_keys())};
}

}  // namespace blockfsi::case_file
