#pragma once

#include "run/run.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace blockfsi::run
{

struct CompareOptions
{
  std::vector<std::string> motions;  ///< names as in entries.hpp
  std::filesystem::path directory;   ///< of the results; empty: "comparison" in that of the case
  std::vector<double> times;         ///< at which meshes are drawn [s]; empty: at the end
};

/// Runs a case once for each way of moving its mesh, each into a folder of its own, and sets them side by
/// side: a table, a figure for each measure of the mesh over time, and pictures of the meshes. A run that
/// fails is a result: when and why is in the table. Exit::done unless a case has a mistake.
[[nodiscard]] Exit compare_runs(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                                const CompareOptions& options);

/// The same without a fluid, for the flap of section [prescribed]: how far each way of moving the mesh bears
/// rotation and bending, and what is left after cycles.
[[nodiscard]] Exit compare_prescribed(const std::filesystem::path& path,
                                      const std::vector<std::string>& overrides,
                                      const CompareOptions& options);

}  // namespace blockfsi::run
