#pragma once

#include "case/case.hpp"

#include <filesystem>

namespace blockfsi::run
{

/// How a command ends; the exit code of the program.
enum class Exit
{
  done = 0,
  missed = 1,  ///< verify: a quantity misses its reference
  user_error = 2,
  failed = 3,  ///< the numbers did not work out; the last good state is written
  internal_error = 70,
  interrupted = 130  ///< by SIGINT or SIGTERM; a checkpoint is written
};

struct RunOptions
{
  bool restart = false;             ///< continue from the newest checkpoint
  std::filesystem::path directory;  ///< of the results; empty: as the case says
};

/// The folder of results: from the options, the case, or "results" beside the case file.
std::filesystem::path result_folder(const case_file::Case& description, const RunOptions& options);

/// Runs a case to its end, with progress on the terminal and results in its folder.
[[nodiscard]] Exit run(const case_file::Case& description, const RunOptions& options);

}  // namespace blockfsi::run
