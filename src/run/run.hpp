#pragma once

#include "case/case.hpp"
#include "command/exit.hpp"
#include "core/timing.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace blockfsi::run
{

using command::Exit;

struct RunOptions
{
  bool restart = false;             ///< continue from the newest checkpoint
  std::filesystem::path directory;  ///< of the results; empty: as the case says
};

/// The folder of results: from the options, the case, or "results" beside the case file.
std::filesystem::path result_folder(const case_file::Case& description, const RunOptions& options);

/// How a run went, for those who set runs side by side.
struct Outcome
{
  Exit exit = Exit::done;
  std::string failure;     ///< why it failed
  bool switches = false;   ///< another layout takes over
  std::int64_t steps = 0;  ///< done in this run
  double time = 0.0;       ///< at its end [s]
  double wall = 0.0;       ///< time it took [s]
  Timings timings;
};

class Simulation;
struct StepReport;

/// Called after every accepted step; may be empty.
using Observer = std::function<void(const Simulation&, const StepReport&)>;

/// Runs a case as `run` does, and tells how it went.
[[nodiscard]] Outcome run_observed(const case_file::Case& description, const RunOptions& options,
                                   const Observer& observer);

/// Runs a case to its end, with progress on the terminal and results in its folder.
[[nodiscard]] Exit run(const case_file::Case& description, const RunOptions& options);

}  // namespace blockfsi::run
