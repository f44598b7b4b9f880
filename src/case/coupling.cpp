#include "case/sections.hpp"
#include "coupling/predictor.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <variant>

namespace blockfsi::case_file
{

namespace
{

using coupling::Aitken;
using coupling::Constant;
using coupling::IqnIls;
using coupling::IqnImvj;
using coupling::Parameters;

const Parameters defaults;

constexpr Range relaxation_range = {
    .low = 0.0, .high = 1.0, .low_allowed = false, .words = "a number > 0 and <= 1"};
constexpr Range fraction = {.low = 0.0, .high = 1.0, .high_allowed = false, .words = "a number >= 0 and < 1"};
constexpr Range small = {
    .low = 0.0, .high = 1.0, .low_allowed = false, .high_allowed = false, .words = "a number > 0 and < 1"};

/// Keys of a method that keeps columns.
template <typename Method>
const Keys<Method>& quasi_newton_keys()
{
  static const Keys<Method> keys = {
      {{"reuse", "whole number", fmt::format("{}", Method{}.reuse), "", "time steps whose columns are kept"},
       [](const Value& v, Reading& r, Method& a) { a.reuse = integer(v, r.constants, 0, 1000); }},
      {{"filter", "number", fmt::format("{}", Method{}.filter), "-",
        "columns that are new by less than this fraction are dropped"},
       [](const Value& v, Reading& r, Method& a) { a.filter = number(v, r.constants, fraction); }},
      {{"initial", "number", fmt::format("{}", Method{}.initial), "-", "relaxation while no column is known"},
       [](const Value& v, Reading& r, Method& a) { a.initial = number(v, r.constants, relaxation_range); }}};
  return keys;
}

const Keys<Aitken>& aitken_keys()
{
  static const Keys<Aitken> keys = {
      {{"initial", "number", fmt::format("{}", Aitken{}.initial), "-", "first relaxation of a step, at most"},
       [](const Value& v, Reading& r, Aitken& a) { a.initial = number(v, r.constants, relaxation_range); }}};
  return keys;
}

const Keys<Constant>& constant_keys()
{
  static const Keys<Constant> keys = {{{"relaxation", "number", fmt::format("{}", Constant{}.relaxation), "-",
                                        "fraction of the correction taken"},
                                       [](const Value& v, Reading& r, Constant& a)
                                       { a.relaxation = number(v, r.constants, relaxation_range); }}};
  return keys;
}

template <typename Method>
void read_accelerator(const Value& value, const Keys<Method>& keys, Reading& reading, Parameters& parameters)
{
  Method method;
  read_keys(value, keys, reading, method);
  parameters.accelerator = method;
}

const Keys<Parameters>& accelerator_keys()
{
  static const Keys<Parameters> keys = {
      {{"iqn_ils", "table", "", "", "interface quasi-Newton by least squares over all columns kept"},
       [](const Value& v, Reading& r, Parameters& p)
       { read_accelerator(v, quasi_newton_keys<IqnIls>(), r, p); }},
      {{"iqn_imvj", "table", "", "", "interface quasi-Newton with a Jacobian carried from step to step"},
       [](const Value& v, Reading& r, Parameters& p)
       { read_accelerator(v, quasi_newton_keys<IqnImvj>(), r, p); }},
      {{"aitken", "table", "", "", "Aitken's dynamic relaxation"},
       [](const Value& v, Reading& r, Parameters& p) { read_accelerator(v, aitken_keys(), r, p); }},
      {{"constant", "table", "", "", "constant relaxation"},
       [](const Value& v, Reading& r, Parameters& p) { read_accelerator(v, constant_keys(), r, p); }}};
  return keys;
}

std::optional<int> read_predictor(const Value& value, Reading& reading)
{
  const auto* word = std::get_if<std::string>(&value.content);
  if (word == nullptr)
    return integer(value, reading.constants, 0, coupling::highest_order);
  if (*word != "automatic")
    fail(value, fmt::format("found {}, allowed is \"automatic\" or a whole number from 0 to {}", found(value),
                            coupling::highest_order));
  return std::nullopt;
}

const Keys<Parameters>& coupling_keys()
{
  static const Keys<Parameters> keys = {
      {{"accelerator", "table", "{ iqn_ils = {} }", "", "how fluid and solid are brought into agreement"},
       [](const Value& v, Reading& r, Parameters& p) { read_one(v, accelerator_keys(), r, p); }},
      {{"tolerance", "number", fmt::format("{}", defaults.tolerance), "-",
        "disagreement of the interface relative to the displacement of the step"},
       [](const Value& v, Reading& r, Parameters& p) { p.tolerance = number(v, r.constants, small); }},
      {{"iterations", "whole number", fmt::format("{}", defaults.iterations), "", "at most in one step"},
       [](const Value& v, Reading& r, Parameters& p) { p.iterations = integer(v, r.constants, 1, 10000); }},
      {{"predictor", "whole number or \"automatic\"", "automatic", "",
        fmt::format(
            "order of the polynomial that extrapolates the interface to the first guess of a step, 0 to {}; "
            "automatic is the one that would have done best in the last steps",
            coupling::highest_order)},
       [](const Value& v, Reading& r, Parameters& p) { p.predictor = read_predictor(v, r); }}};
  return keys;
}

}  // namespace

void read_coupling(const Value& value, Reading& reading, Parameters& parameters)
{
  read_keys(value, coupling_keys(), reading, parameters);
}

std::vector<Section> coupling_sections()
{
  return {section("[coupling]", "of fluid and solid", coupling_keys()),
          section("[coupling] accelerator = { ... }", "one key of", accelerator_keys()),
          section("[coupling] accelerator = { iqn_ils = { ... } }", "", quasi_newton_keys<IqnIls>()),
          section("[coupling] accelerator = { iqn_imvj = { ... } }", "", quasi_newton_keys<IqnImvj>()),
          section("[coupling] accelerator = { aitken = { ... } }", "", aitken_keys()),
          section("[coupling] accelerator = { constant = { ... } }", "", constant_keys())};
}

}  // namespace blockfsi::case_file
