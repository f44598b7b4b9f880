#include "case/sections.hpp"

#include <fmt/format.h>

namespace blockfsi::case_file
{

namespace
{

using coupling::Aitken;
using coupling::Constant;
using coupling::IqnIls;
using coupling::Parameters;

const Parameters defaults;

constexpr Range relaxation_range = {
    .low = 0.0, .high = 1.0, .low_allowed = false, .words = "a number > 0 and <= 1"};
constexpr Range fraction = {.low = 0.0, .high = 1.0, .high_allowed = false, .words = "a number >= 0 and < 1"};
constexpr Range small = {
    .low = 0.0, .high = 1.0, .low_allowed = false, .high_allowed = false, .words = "a number > 0 and < 1"};

const Keys<IqnIls>& iqn_ils_keys()
{
  static const Keys<IqnIls> keys = {
      {{"reuse", "whole number", fmt::format("{}", IqnIls{}.reuse), "", "time steps whose columns are kept"},
       [](const Value& v, Reading& r, IqnIls& a) { a.reuse = integer(v, r.constants, 0, 1000); }},
      {{"filter", "number", fmt::format("{}", IqnIls{}.filter), "-",
        "columns that are new by less than this fraction are dropped"},
       [](const Value& v, Reading& r, IqnIls& a) { a.filter = number(v, r.constants, fraction); }},
      {{"initial", "number", fmt::format("{}", IqnIls{}.initial), "-", "relaxation while no column is known"},
       [](const Value& v, Reading& r, IqnIls& a) { a.initial = number(v, r.constants, relaxation_range); }}};
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
      {{"iqn_ils", "table", "", "", "interface quasi-Newton by least squares"},
       [](const Value& v, Reading& r, Parameters& p) { read_accelerator(v, iqn_ils_keys(), r, p); }},
      {{"aitken", "table", "", "", "Aitken's dynamic relaxation"},
       [](const Value& v, Reading& r, Parameters& p) { read_accelerator(v, aitken_keys(), r, p); }},
      {{"constant", "table", "", "", "constant relaxation"},
       [](const Value& v, Reading& r, Parameters& p) { read_accelerator(v, constant_keys(), r, p); }}};
  return keys;
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
      {{"predictor", "whole number", fmt::format("{}", defaults.predictor), "",
        "order of the extrapolation of the interface, 0 to 2"},
       [](const Value& v, Reading& r, Parameters& p) { p.predictor = integer(v, r.constants, 0, 2); }}};
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
          section("[coupling] accelerator = { iqn_ils = { ... } }", "", iqn_ils_keys()),
          section("[coupling] accelerator = { aitken = { ... } }", "", aitken_keys()),
          section("[coupling] accelerator = { constant = { ... } }", "", constant_keys())};
}

}  // namespace blockfsi::case_file
