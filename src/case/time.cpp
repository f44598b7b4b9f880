#include "case/sections.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace blockfsi::case_file
{

namespace
{

using fem::TimeParameters;

const TimeParameters defaults;

constexpr std::array<std::string_view, 3> schemes = {"steady", "backward-euler", "crank-nicolson"};

/// More steps are taken for a slip of the pen.
constexpr double most_steps = 1e9;

const Keys<TimeParameters>& time_keys()
{
  static const Keys<TimeParameters> keys = {
      {{"scheme", "\"crank-nicolson\", \"backward-euler\" or \"steady\"",
        std::string(schemes[static_cast<std::size_t>(defaults.scheme)]), "", "how a run advances"},
       [](const Value& v, Reading&, TimeParameters& p)
       { p.scheme = static_cast<fem::Scheme>(choice(v, schemes)); }},
      {{"end", "number", "required unless steady", "s", "simulated time at the end"},
       [](const Value& v, Reading& r, TimeParameters& p) { p.end = number(v, r.constants, positive); }},
      {{"step", "number", "required unless steady", "s", "size of a time step"},
       [](const Value& v, Reading& r, TimeParameters& p) { p.step = number(v, r.constants, positive); }},
      {{"start_up", "whole number", fmt::format("{}", defaults.start_up), "",
        "first steps that are each done as two backward Euler half steps"},
       [](const Value& v, Reading& r, TimeParameters& p)
       { p.start_up = integer(v, r.constants, 0, 1000000); }},
      {{"ringing_decay", "number", "20 steps", "s", "time in which ringing from step to step falls by e"},
       [](const Value& v, Reading& r, TimeParameters& p)
       { p.ringing_decay = number(v, r.constants, not_negative); }},
      {{"cuts", "whole number", fmt::format("{}", defaults.cuts), "",
        "how often a step that fails, because the mesh folds or an iteration does not converge, is halved "
        "before the run ends"},
       [](const Value& v, Reading& r, TimeParameters& p) { p.cuts = integer(v, r.constants, 0, 20); }}};
  return keys;
}

const Description& describe_key(std::string_view name)
{
  for (const Key<TimeParameters>& key : time_keys())
    if (key.says.name == name)
      return key.says;
  return time_keys().front().says;
}

const Keys<std::string>& petsc_keys()
{
  static const Keys<std::string> keys = {
      {{"options", "text", "", "", "options passed to PETSc as on its command line, \"-name value ...\""},
       [](const Value& v, Reading&, std::string& options)
       {
         options = text(v);
         const auto first = options.find_first_not_of(' ');
         if (first != std::string::npos && options[first] != '-')
           fail(v, fmt::format("found {}, allowed are options that begin with '-'", found(v)));
       }}};
  return keys;
}

}  // namespace

void read_time(const Value& value, Reading& reading, TimeParameters& parameters)
{
  read_keys(value, time_keys(), reading, parameters);
  if (parameters.scheme == fem::Scheme::steady)
    return;
  for (const char* name : {"end", "step"})
    if (!value.find(name))
      missing_key(value, describe_key(name));
  if (parameters.step > parameters.end)
    fail(*value.find("step"),
         fmt::format("found {} s, allowed is at most the end, {} s", parameters.step, parameters.end));
  const double steps = parameters.end / parameters.step;
  if (steps > most_steps)
    fail(*value.find("step"),
         fmt::format("found {} s, which makes {:.3g} steps to the end; allowed are {:.0g}", parameters.step,
                     steps, most_steps));
  if (std::abs(steps - std::round(steps)) > 1e-6 * steps)
    fail(*value.find("step"),
         fmt::format("found {} s, but the end, {} s, is not a whole number of such steps; {:.6g} s would fit",
                     parameters.step, parameters.end, parameters.end / std::ceil(steps)));
}

std::vector<Section> time_sections()
{
  return {section("[time]", "", time_keys())};
}

void read_petsc(const Value& value, Reading& reading, std::string& options)
{
  read_keys(value, petsc_keys(), reading, options);
}

std::vector<Section> petsc_sections()
{
  return {section("[petsc]", "linear solvers", petsc_keys())};
}

}  // namespace blockfsi::case_file
