#include "case/field.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace blockfsi::case_file
{

Expression sampled(const Value& value, Reading& reading, std::span<const std::string_view> variables,
                   const std::string& name, bool on_boundary)
{
  Expression result = expression(value, reading.constants, variables);
  reading.samples.push_back({result, value.where, value.path, name, on_boundary});
  return result;
}

std::array<Expression, 3> sampled_vector(const Value& value, Reading& reading,
                                         std::span<const std::string_view> variables, const std::string& name,
                                         bool on_boundary)
{
  std::array<Expression, 3> result = vector(value, reading.constants, variables);
  const Value::List& entries = list(value);
  for (std::size_t i = 0; i < entries.size(); ++i)
    reading.samples.push_back({result[i], entries[i].where, entries[i].path, name, on_boundary});
  return result;
}

std::array<Expression, 3> traction(const Value& value, Reading& reading, const std::string& boundary)
{
  if (std::holds_alternative<Value::List>(value.content))
    return sampled_vector(value, reading, in_space_and_time, boundary, true);
  const bool zero = (std::holds_alternative<std::int64_t>(value.content) ||
                     std::holds_alternative<double>(value.content)) &&
                    number(value, reading.constants) == 0.0;
  if (!zero)
    fail(value,
         fmt::format("found {}, allowed is 0 or a list of two numbers or formulas in x, y, t", found(value)));
  return {};
}

void require_boundary(const Field& field, const std::vector<std::string>& keys, const Reading& reading)
{
  if (std::find(reading.boundaries.begin(), reading.boundaries.end(), field.name) != reading.boundaries.end())
    return;
  std::vector<std::string> known = reading.boundaries;
  known.insert(known.end(), keys.begin(), keys.end());
  throw Error(field.where, fmt::format("{}: neither a key nor a name in [boundaries]{}", field.value.path,
                                       suggestion(field.name, known)));
}

}  // namespace blockfsi::case_file
