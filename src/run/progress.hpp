#pragma once

#include "core/timing.hpp"
#include "run/simulation.hpp"

#include <chrono>
#include <string>

namespace blockfsi::run
{

/// Tells on the terminal how far a run is: a line that renews itself, or a line now and then where the output
/// is no terminal. Process 0 only.
class Progress
{
public:
  explicit Progress(const Simulation& simulation);

  /// To be called after each step.
  void step(const StepReport& report);
  /// Ends the line that renews itself, before other text.
  void end();

private:
  const Simulation* simulation_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point shown_;
  std::int64_t first_step_;
  double least_jacobian_ = 1.0;
  bool terminal_;
  bool speaks_;
  bool open_ = false;
};

/// "4 min 12 s", "2 h 5 min", "0.8 s".
std::string duration(double seconds);

/// The table of wall time by part that ends a run.
std::string timing_summary(const Timings& timings, double wall_seconds, std::int64_t steps);

}  // namespace blockfsi::run
