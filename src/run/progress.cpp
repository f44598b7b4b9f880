#include "run/progress.hpp"

#include "linalg/communicator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace blockfsi::run
{

Progress::Progress(const Simulation& simulation)
    : simulation_(&simulation), start_(std::chrono::steady_clock::now()),
      shown_(start_ - std::chrono::hours(1)), first_step_(simulation.step()),
      terminal_(isatty(STDOUT_FILENO) != 0 && linalg::part().size == 1), speaks_(linalg::part().rank == 0)
{
}

void Progress::step(const StepReport& report)
{
  least_jacobian_ = std::min(least_jacobian_, report.quality.scaled_jacobian);
  const auto now = std::chrono::steady_clock::now();
  const double since = std::chrono::duration<double>(now - shown_).count();
  const std::int64_t done = simulation_->step();
  const std::int64_t total = simulation_->step_count();
  // Ten times a second on a terminal, every ten seconds in a log.
  if (!speaks_ || (done < total && since < (terminal_ ? 0.1 : 10.0)))
    return;
  shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double per_step = elapsed / static_cast<double>(done - first_step_);
  std::string line = fmt::format("step {}/{}  t = {:.4g} s", done, total, simulation_->time());
  if (simulation_->solid() != nullptr && simulation_->fluid() != nullptr)
    line += fmt::format("  coupling {}", report.coupling_iterations);
  line += fmt::format("  Newton {}", report.fluid_iterations + report.solid_iterations);
  if (simulation_->fluid() != nullptr)
    line +=
        fmt::format("  mesh quality {:.2f} (least {:.2f})", report.quality.scaled_jacobian, least_jacobian_);
  line += fmt::format("  {:.2g} s/step  {} left", per_step,
                      duration(per_step * static_cast<double>(total - done)));
  if (terminal_)
    fmt::print("\r\033[K{}", line);
  else
    fmt::print("{}\n", line);
  std::fflush(stdout);
  open_ = terminal_;
}

void Progress::end()
{
  if (open_)
    fmt::print("\n");
  open_ = false;
}

std::string duration(double seconds)
{
  if (seconds < 10.0)
    return fmt::format("{:.1f} s", seconds);
  const auto whole = std::lround(seconds);
  if (whole < 60)
    return fmt::format("{} s", whole);
  if (whole < 3600)
    return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string timing_summary(const Timings& timings, double wall_seconds, std::int64_t steps)
{
  std::string text =
      fmt::format("{:<16}{:>12}{:>9}{:>12}{:>14}\n", "part", "seconds", "share", "calls", "ms per step");
  double rest = wall_seconds;
  const double per_step = steps > 0 ? 1e3 / static_cast<double>(steps) : 0.0;
  const auto row = [&](std::string_view name, double seconds, const std::string& calls)
  {
    text += fmt::format("{:<16}{:>12.3f}{:>8.2f}%{:>12}{:>14.3f}\n", name, seconds,
                        100.0 * seconds / wall_seconds, calls, seconds * per_step);
  };
  for (std::size_t i = 0; i < task_names.size(); ++i)
  {
    row(task_names[i], timings.seconds[i], fmt::format("{}", timings.calls[i]));
    rest -= timings.seconds[i];
  }
  row("rest", rest, "");
  row("total", wall_seconds, "");
  return text;
}

}  // namespace blockfsi::run
