#include "case/key.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace blockfsi::case_file
{

void unknown_key(const Field& field, const std::vector<std::string>& known)
{
  const char* what = field.value.path == "[" + field.name + "]" ? "section" : "key";
  throw Error(field.where,
              fmt::format("{}: unknown {}{}", field.value.path, what, suggestion(field.name, known)));
}

void missing_key(const Value& table, const Description& key)
{
  const std::string unit = key.unit.empty() ? "" : fmt::format(" [{}]", key.unit);
  fail(table, fmt::format("the key '{}' is missing: {}{}", key.name, key.meaning, unit));
}

}  // namespace blockfsi::case_file
