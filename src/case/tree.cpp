#include "case/tree.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

namespace blockfsi::case_file
{

namespace
{

constexpr const char* override_file = "--set";

Location location(const toml::source_region& region, const std::string& file)
{
  if (file == override_file)
    return {file, 0, 0};
  return {file, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

/// How many names of a path make the section in brackets; the rest are keys.
std::size_t section_depth(const std::vector<std::string>& names)
{
  if (names.size() >= 2 && names[0] == "compare")
    return 2;
  if (names.size() < 2 || names[0] != "blocks")
    return 1;
  if (names[1] == "lattice")
    return 3;
  return names[1] == "points" || names[1] == "quads" || names[1] == "edges" ? 2 : 1;
}

std::string path_text(const std::vector<std::string>& names)
{
  const std::size_t depth = section_depth(names);
  std::string section;
  std::string key;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    std::string& text = i < depth ? section : key;
    text += (text.empty() ? "" : ".") + names[i];
  }
  return "[" + section + "]" + (key.empty() ? "" : " " + key);
}

/// Turns the nodes of toml++ into our tree, so that nothing else depends on that library.
class Converter
{
public:
  explicit Converter(std::string file) : file_(std::move(file)) {}

  Value value(const toml::node& node, std::vector<std::string>& names) const
  {
    Value result;
    result.where = location(node.source(), file_);
    // A key above all sections stands for itself.
    result.path = names.size() == 1 && !node.is_table() ? names[0] : path_text(names);
    if (const auto* text = node.as_string())
      result.content = text->get();
    else if (const auto* integer = node.as_integer())
      result.content = integer->get();
    else if (const auto* number = node.as_floating_point())
      result.content = number->get();
    else if (const auto* flag = node.as_boolean())
      result.content = flag->get();
    else if (const auto* array = node.as_array())
      result.content = list(*array, names);
    else if (const auto* table = node.as_table())
    {
      result.content = fields(*table, names);
      result.braced = table->is_inline();
    }
    return result;
  }

private:
  Value::List list(const toml::array& array, std::vector<std::string>& names) const
  {
    Value::List result;
    for (const toml::node& node : array)
      result.push_back(value(node, names));
    return result;
  }

  Value::Table fields(const toml::table& table, std::vector<std::string>& names) const
  {
    Value::Table result;
    for (const auto& [key, node] : table)
    {
      names.emplace_back(key.str());
      result.push_back({std::string(key.str()), location(key.source(), file_), value(node, names)});
      names.pop_back();
    }
    // toml++ sorts by name.
    std::stable_sort(
        result.begin(), result.end(),
        [](const Field& a, const Field& b)
        { return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column); });
    return result;
  }

  std::string file_;
};

Value parse(std::string_view text, const std::string& file)
{
  try
  {
    const toml::table table = toml::parse(text, file);
    std::vector<std::string> names;
    Value value = Converter(file).value(table, names);
    value.where = {file, 0, 0};
    return value;
  }
  catch (const toml::parse_error& error)
  {
    throw Error(location(error.source(), file), fmt::format("this is not TOML: {}", error.description()));
  }
}

/// Puts the fields of `changes` over those of `table`; a table written in braces replaces a whole table.
void merge(Value::Table& table, const Value::Table& changes)
{
  for (const Field& change : changes)
  {
    const auto old = std::find_if(table.begin(), table.end(),
                                  [&](const Field& field) { return field.name == change.name; });
    if (old == table.end())
    {
      table.push_back(change);
      continue;
    }
    auto* inner = std::get_if<Value::Table>(&old->value.content);
    const auto* inner_changes = std::get_if<Value::Table>(&change.value.content);
    if (inner && inner_changes && !change.value.braced)
      merge(*inner, *inner_changes);
    else
      *old = change;
  }
}

void override_values(Value& root, const std::string& assignment)
{
  Value changes;
  try
  {
    changes = parse(assignment, override_file);
  }
  catch (const Error& error)
  {
    throw Error(
        Location{override_file, 0, 0},
        fmt::format(
            "found '{}', allowed is an assignment key.path=value in TOML syntax, such as time.end=0.1 "
            "or time.scheme=\"steady\" (texts need quotes); {}",
            assignment, error.message()));
  }
  merge(std::get<Value::Table>(root.content), std::get<Value::Table>(changes.content));
}

}  // namespace

const Value* Value::find(std::string_view name) const
{
  const auto* table = std::get_if<Table>(&content);
  if (!table)
    return nullptr;
  const auto field =
      std::find_if(table->begin(), table->end(), [&](const Field& f) { return f.name == name; });
  return field == table->end() ? nullptr : &field->value;
}

std::string found(const Value& value)
{
  if (const auto* flag = std::get_if<bool>(&value.content))
    return *flag ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&value.content))
    return fmt::format("{}", *integer);
  if (const auto* number = std::get_if<double>(&value.content))
    return fmt::format("{}", *number);
  if (const auto* text = std::get_if<std::string>(&value.content))
    return fmt::format("\"{}\"", *text);
  if (const auto* list = std::get_if<Value::List>(&value.content))
    return fmt::format("a list of {}", list->size());
  return std::holds_alternative<Value::Table>(value.content) ? "a table" : "a date or time";
}

void fail(const Value& value, std::string_view message)
{
  throw Error(value.where, fmt::format("{}: {}", value.path, message));
}

Value load(const std::filesystem::path& path, const std::vector<std::string>& overrides)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path))
    throw Error(Location{path.string(), 0, 0}, "cannot be read; give the path of a case file in TOML format");
  std::ostringstream text;
  text << stream.rdbuf();
  Value root = parse(text.str(), path.string());
  for (const std::string& assignment : overrides)
    override_values(root, assignment);
  return root;
}

}  // namespace blockfsi::case_file
