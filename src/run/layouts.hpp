#pragma once

#include "case/case.hpp"
#include "run/handover.hpp"

#include <filesystem>
#include <vector>

namespace blockfsi::run
{

/// Folders of results of all layouts of a case: that of the run and, in it, one for each case file that may
/// take over, of its name.
std::vector<std::filesystem::path> layout_folders(const case_file::Case& description,
                                                  const std::filesystem::path& run_folder);

/// Those of them that the run has come to.
std::vector<std::filesystem::path> reached_folders(const case_file::Case& description,
                                                   const std::filesystem::path& run_folder);

/// Forgets that a run has come to a folder.
void forget(const std::filesystem::path& folder);

/// Writes into the folder what it cost to take over from a simulation: by that it counts as reached.
void write_transfer(const std::filesystem::path& folder, const Simulation& from,
                    const HandoverReport& report);

}  // namespace blockfsi::run
