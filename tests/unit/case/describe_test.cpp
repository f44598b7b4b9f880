#include "case/describe.hpp"

#include "case/case.hpp"
#include "case/tree.hpp"

#include "geometry/cad.hpp"

#include <doctest/doctest.h>

#include <algorithm>
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
    {"coupling.accelerator={ iqn_imvj = { reuse = 3, filter = 0.1, initial = 0.5 } }"},
    {"coupling.accelerator={ constant = { relaxation = 0.5 } }"},
    {"solid.root={ displacement = [0, 0] }"},
    {"solid.root={ traction = 0 }"},
    {"solid.root={ free = true }"}};

/// Tables whose keys are names that the user chooses.
bool holds_names(const std::string& path)
{
  for (const char* table : {"[let]", "[boundaries]", "[geometry]", "[compare]"})
    if (path == table)
      return true;
  // Pieces, points, blocks, edges and faces have names.
  for (const char* kind : {"lattice",   "box",     "disc", "annulus", "channel",  "ball",   "shell",
                           "extrude",   "revolve", "copy", "mirror",  "tubes",    "points", "quads",
                           "triangles", "hexes",   "tets", "prisms",  "pyramids", "edges",  "faces"})
    if (path == std::string("[blocks] ") + kind || path == std::string("[blocks.") + kind + "]")
      return true;
  return path == "[output] probes" || path == "[output] forces" || path.ends_with(" place") ||
         path.find(" regenerate.follows") != std::string::npos || path.ends_with("nodes");
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

/// Adds all keys of a file, which must be accepted; sections are no keys.
void add_keys(const std::filesystem::path& file, const std::vector<std::string>& overrides,
              std::set<std::string>& keys)
{
  case_file::read(file, overrides);
  const case_file::Value root = case_file::load(file, overrides);
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

std::set<std::string> parsed_keys()
{
  std::set<std::string> keys;
  for (const std::vector<std::string>& overrides : variations)
    add_keys(everything, overrides, keys);
  for (const char* file : {"everything_3d.toml", "everything_plane.toml", "curves.toml"})
    add_keys(everything.parent_path() / file, {}, keys);
  if (geometry::reads_cad())
    add_keys(everything.parent_path() / "curves_cad.toml", {}, keys);
  else
    keys.insert({"step", "iges", "file", "edge"});
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
