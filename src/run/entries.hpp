#pragma once

#include "case/case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace blockfsi::run
{

/// A case with one of several ways of moving its mesh.
struct Entry
{
  std::string name;
  case_file::Case description;
};

/// The case once per name. A name is that of a section [compare.NAME], a key of [motion] (with the settings
/// of the case's own [motion] if that has the same key, else with defaults), or one of some short names for
/// settings that are often compared. Without names: the case's own motion and all its [compare.NAME]. Throws
/// Error for unknown names, listing all, and for mistakes in the case.
std::vector<Entry> read_entries(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                                const std::vector<std::string>& names);

}  // namespace blockfsi::run
