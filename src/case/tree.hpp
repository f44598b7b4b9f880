#pragma once

#include "core/error.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace blockfsi::case_file
{

struct Field;

/// A value of the case file with the place where it stands.
struct Value
{
  using Table = std::vector<Field>;  ///< in the order of the file
  using List = std::vector<Value>;

  Location where;
  std::string path;  ///< as errors name it: "[fluid] inlet.velocity"
  /// Dates, which no key wants, are held as std::monostate.
  std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Table> content;
  bool braced = false;  ///< a table written as { ... }

  /// The field of a table, or nullptr if there is none or this is no table.
  const Value* find(std::string_view name) const;
};

/// A key of a table and its value.
struct Field
{
  std::string name;
  Location where;
  Value value;
};

/// What stands there, in words for an error: -1, "text", true, a list of 3, a table.
std::string found(const Value& value);

/// Throws Error at the value: "[fluid] density: message".
[[noreturn]] void fail(const Value& value, std::string_view message);

/// Reads a TOML file and replaces values by those of `overrides`, assignments "key.path=value" in TOML syntax
/// whose place is the file "--set". Throws Error for what is not TOML.
Value load(const std::filesystem::path& path, const std::vector<std::string>& overrides);

}  // namespace blockfsi::case_file
