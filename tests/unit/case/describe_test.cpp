#include "case/describe.hpp"

#include "case/case.hpp"
#include "case/tree.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

using namespace blockfsi;

namespace
{

const std::filesystem::path everything =
    std::filesystem::path(BLOCKFSI_TESTS_FOLDER) / "unit" / "case" / "everything.toml";

/// What cannot stand in one file with everything else.
const std::vector<std::vector<std::string>> variations = {
    {},
    {"coupling.accelerator={ aitken = { initial = 0.5 } }"},
    {"coupling.accelerator={ constant = { relaxation = 0.5 } }"},
    {"solid.root={ displacement = [0, 0] }"},
    {"solid.root={ traction = 0 }"},
    {"solid.root={ free = true }"}};

/// Tables whose keys are names that the user chooses.
bool holds_names(const std::string& path)
{
  for (const char* table : {"[let]", "[blocks.points]", "[blocks.quads]", "[blocks.edges]", "[boundaries]",
                            "[geometry]", "[compare]"})
    if (path == table)
      return true;
  return path == "[output] probes" || path == "[output] forces" || path.ends_with(" place") ||
         path.find(" regenerate.follows") != std::string::npos || path == "[blocks.lattice]" ||
         path.ends_with("convolution.nodes");
}

void collect(const case_file::Value& value, const std::set<std::string>& names, std::set<std::string>& keys)
{
  if (const auto* list = std::get_if<case_file::Value::List>(&value.content))
    for (const case_file::Value& entry : *list)
      collect(entry, names, keys);
  if (const auto* table = std::get_if<case_file::Value::Table>(&value.content))
    for (const case_file::Field& field : *table)
    {
      const bool is_boundary =
          (value.path == "[fluid]" || value.path == "[solid]") && names.contains(field.name);
      if (!holds_names(value.path) && !is_boundary)
        keys.insert(field.name);
      collect(field.value, names, keys);
    }
}

/// All keys of the file in all its variations, which must be accepted; sections are no keys.
std::set<std::string> parsed_keys()
{
  std::set<std::string> keys;
  for (const std::vector<std::string>& overrides : variations)
  {
    case_file::read(everything, overrides);
    const case_file::Value root = case_file::load(everything, overrides);
    std::set<std::string> boundaries;
    for (const case_file::Field& field : std::get<case_file::Value::Table>(root.find("boundaries")->content))
      boundaries.insert(field.name);
    for (const case_file::Field& section : std::get<case_file::Value::Table>(root.content))
    {
      collect(section.value, boundaries, keys);
      if (!std::holds_alternative<case_file::Value::Table>(section.value.content))
        keys.insert(section.name);
    }
  }
  return keys;
}

std::set<std::string> described_keys()
{
  std::set<std::string> keys;
  std::istringstream lines(case_file::describe());
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  ") && line[2] != ' ' && line.find(": ") != std::string::npos)
      keys.insert(line.substr(2, line.find(": ") - 2));
  keys.erase("NAME");
  return keys;
}

std::string listed(const std::set<std::string>& keys)
{
  std::string text;
  for (const std::string& key : keys)
    text += key + "\n";
  return text;
}

}  // namespace

TEST_CASE("describe lists every key that a case may have, and no other")
{
  CHECK(listed(described_keys()) == listed(parsed_keys()));
}

TEST_CASE("describe gives type, default, unit and meaning")
{
  const std::string text = case_file::describe();
  CHECK(text.find("  density: density\n      number [kg/m^3]; required\n") != std::string::npos);
  CHECK(text.find("  order: polynomial order of the cells, 1 to 8\n      whole number; default: 2\n") !=
        std::string::npos);
}
