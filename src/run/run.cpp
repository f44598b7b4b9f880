#include "run/run.hpp"

#include "linalg/communicator.hpp"
#include "output/table.hpp"
#include "run/failure.hpp"
#include "run/handover.hpp"
#include "run/interrupt.hpp"
#include "run/progress.hpp"
#include "run/refused.hpp"
#include "run/results.hpp"
#include "run/simulation.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <optional>
#include <string_view>
#include <utility>

namespace blockfsi::run
{

namespace
{

/// Prints on process 0.
template <class... Arguments>
void say(fmt::format_string<Arguments...> format, Arguments&&... arguments)
{
  if (linalg::part().rank != 0)
    return;
  fmt::print(format, std::forward<Arguments>(arguments)...);
  std::fflush(stdout);
}

/// Continues from the newest checkpoint in the folder.
void restart(Simulation& simulation, const std::filesystem::path& checkpoints)
{
  const Part me = linalg::part();
  std::int64_t step = -1;
  std::string problem;
  if (me.rank == 0)
  {
    try
    {
      step = output::latest_complete(checkpoints, me.size).value_or(-1);
      if (step < 0)
        problem = fmt::format("there is no complete checkpoint in '{}'; run without --restart",
                              checkpoints.string());
    }
    catch (const Error& error)
    {
      problem = error.what();
    }
  }
  step = linalg::from_first(step);
  if (step < 0)
    throw Error(me.rank == 0 ? problem : "no checkpoint");
  simulation.restore(output::read_rank(checkpoints, step, me));
  say("continuing after step {} (t = {:g} s)\n", step, simulation.time());
}

void write_checkpoint(Simulation& simulation, const std::filesystem::path& checkpoints, std::uint64_t run)
{
  const Stopwatch watch(simulation.timings(), Task::output);
  output::write_rank(checkpoints, simulation.step(), linalg::part(), simulation.save(), run);
  linalg::barrier();
  if (linalg::part().rank == 0)
    output::remove_old(checkpoints);
}

/// Whether fields are due at a time that is a multiple of `every`.
bool fields_due(const Simulation& simulation)
{
  const double every = simulation.description().output.every;
  if (every <= 0.0)
    return false;
  const double step = simulation.description().time.step;
  const double now = simulation.time() / every + 1e-9;
  return std::floor(now) > std::floor(now - step / every);
}

void introduce(const Simulation& simulation, const std::filesystem::path& folder)
{
  const case_file::Case& description = simulation.description();
  if (!description.title.empty())
    say("{}\n", description.title);
  if (const FluidSide* fluid = simulation.fluid())
    say("fluid: {} cells of order {}, {} unknowns\n", fluid->mesh().total_cell_count, fluid->mesh().order,
        fluid->unknown_count());
  if (const SolidSide* solid = simulation.solid())
    say("solid: {} cells of order {}, {} unknowns\n", solid->mesh().total_cell_count, solid->mesh().order,
        solid->unknown_count());
  say("results: {}\n", folder.string());
}

void conclude(const Simulation& simulation, const std::filesystem::path& folder)
{
  say("results are in {}\n", folder.string());
  for (const std::string_view table : {"probes.csv", "forces.csv", "quality.csv"})
    if (std::filesystem::exists(folder / table))
      say("  {:<12} one row per step\n", table);
  say("  fields.pvd   open in ParaView; colour by velocity, press play\n");
  const std::filesystem::path& path = simulation.description().path;
  if (simulation.finished() && std::filesystem::exists(path.parent_path() / "reference.csv"))
    say("next: ./dev verify --finished {} --directory {}\n", path.string(), folder.string());
}

/// Where a run writes, and the number that tells it from other runs.
struct Place
{
  std::filesystem::path folder;
  std::filesystem::path checkpoints;
  std::uint64_t run;
};

Place make_place(const std::filesystem::path& folder)
{
  const auto now = linalg::from_first(std::chrono::system_clock::now().time_since_epoch().count());
  return {folder, folder / "checkpoint", static_cast<std::uint64_t>(now)};
}

/// What a run begins with.
enum class Begin
{
  rest,
  checkpoint,
  transfer  ///< from another layout; it was done already
};

/// Whether another layout takes over after a step that went well.
bool is_due(const std::optional<case_file::Second>& second, const Simulation& simulation,
            const StepReport& report)
{
  constexpr double rounding = 1e-9;
  return second && !simulation.finished() &&
         (report.quality.scaled_jacobian < second->below ||
          (second->at && simulation.time() > *second->at - rounding * simulation.description().time.step));
}

/// Does one step after the other, until the end, a failure or a signal, or until another layout takes over;
/// how they ended.
Outcome step_through(Simulation& simulation, Results& results, const InterruptGuard& guard,
                     const Place& place, const Observer& observer,
                     const std::optional<case_file::Second>& second)
{
  const int checkpoint_every = simulation.description().output.checkpoint_every;
  Progress progress(simulation);
  Outcome ending;
  while (!simulation.finished())
  {
    const StepReport report = simulation.advance();
    if (!report.ok)
    {
      progress.end();
      if (second && report.refused)
      {
        say("{}; another layout takes over\n", report.failure);
        ending.switches = true;
        return ending;
      }
      std::string picture;
      if (report.refused)
      {
        draw_refused(place.folder / refused_picture, simulation, *report.refused);
        picture =
            fmt::format("; {} shows the blocks around the cell", (place.folder / refused_picture).string());
      }
      if (linalg::part().rank == 0)
        fmt::print(stderr, "blockfsi: {}; the last good state (t = {:g} s) is in the results{}\n",
                   report.failure, simulation.time(), picture);
      ending.exit = Exit::failed;
      ending.failure = report.failure;
      return ending;
    }
    {
      const Stopwatch watch(simulation.timings(), Task::output);
      results.add_step(report);
      if (fields_due(simulation))
        results.add_fields();
    }
    if (report.pieces > 1)
    {
      progress.end();
      say("step {} was done in {} pieces: {}\n", simulation.step(), report.pieces, report.failure);
    }
    progress.step(report);
    if (observer)
      observer(simulation, report);
    if (linalg::any(guard.requested()))
    {
      progress.end();
      say("interrupted after step {}; continue with --restart\n", simulation.step());
      ending.exit = Exit::interrupted;
      return ending;
    }
    if (is_due(second, simulation, report))
    {
      progress.end();
      ending.switches = true;
      return ending;
    }
    if (simulation.step() % checkpoint_every == 0)
      write_checkpoint(simulation, place.checkpoints, place.run);
  }
  progress.end();
  return ending;
}

Outcome carry_out(Simulation& simulation, Begin begin, const Place& place,
                  std::chrono::steady_clock::time_point start, const Observer& observer,
                  const std::optional<case_file::Second>& second)
{
  const case_file::Case& description = simulation.description();
  const InterruptGuard guard;
  if (begin == Begin::checkpoint)
    restart(simulation, place.checkpoints);
  else if (linalg::part().rank == 0)
    output::remove_all(place.checkpoints);
  introduce(simulation, place.folder);
  Results results(place.folder, simulation, begin == Begin::checkpoint);
  const bool is_new = begin != Begin::checkpoint && description.time.scheme != fem::Scheme::steady;
  if (is_new && description.output.every > 0.0)
    results.add_fields();

  const std::int64_t first_step = simulation.step();
  Outcome outcome = step_through(simulation, results, guard, place, observer, second);
  if (outcome.exit != Exit::interrupted)
  {
    const Stopwatch watch(simulation.timings(), Task::output);
    results.add_fields();
  }
  write_checkpoint(simulation, place.checkpoints, place.run);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  say("{}", timing_summary(simulation.timings(), wall.count(), simulation.step() - first_step));
  conclude(simulation, place.folder);
  outcome.steps = simulation.step() - first_step;
  outcome.time = simulation.time();
  outcome.wall = wall.count();
  outcome.timings = simulation.timings();
  return outcome;
}

void require_solvable(const case_file::Case& description)
{
  if (!description.fluid && !description.solid)
    throw Error({description.path.string()}, "there is nothing to solve: the case has neither [fluid] nor "
                                             "[solid]; `blockfsi mesh` makes its mesh");
  if (description.layout.dim != 2)
    throw Error(
        {description.path.string()},
        "only blocks of two dimensions can be simulated; `blockfsi mesh` makes the mesh, and `blockfsi "
        "compare --prescribed` moves it");
}

/// Carries the state to the second layout and writes what that cost; false if its mesh is not valid.
bool hand_over(const Handover& handover, const Simulation& first, Simulation& next,
               const std::filesystem::path& folder)
{
  const double before = first.fluid()->quality().scaled_jacobian;
  const HandoverReport report = handover.carry(first, next);
  if (!report.failure.empty())
  {
    fmt::print(
        stderr,
        "blockfsi: '{}' cannot take over at t = {:g} s: {}; the last good state is in the results of the "
        "first layout\n",
        next.description().path.string(), first.time(), report.failure);
    return false;
  }
  say("{} takes over at t = {:g} s: least scaled Jacobian {:.3g} -> {:.3g}, transfer error of the velocity "
      "{:.2g}, of the pressure {:.2g}\n",
      next.description().path.string(), first.time(), before, report.quality.scaled_jacobian,
      report.velocity_error, report.pressure_error);
  const FlowIntegrals& old = report.before;
  const FlowIntegrals& now = report.after;
  output::Table table(folder / "transfer.csv",
                      {"step", "time", "scaled_jacobian_before", "scaled_jacobian", "velocity_error",
                       "pressure_error", "area_before", "area", "momentum_x_before", "momentum_x",
                       "momentum_y_before", "momentum_y", "outflow_before", "outflow", "divergence_before",
                       "divergence"});
  table.append(first.step(), std::array{first.time(), before, report.quality.scaled_jacobian,
                                        report.velocity_error, report.pressure_error, old.area, now.area,
                                        old.momentum[0], now.momentum[0], old.momentum[1], now.momentum[1],
                                        old.outflow, now.outflow, old.divergence, now.divergence});
  return true;
}

/// Runs a case and, when that is due, its second layout, whose results lie in a folder of its name.
Exit run_both(const case_file::Case& description, const RunOptions& options)
{
  const case_file::Second& second = *description.second;
  const case_file::Case other = case_file::read(second.path);
  require_solvable(description);
  require_solvable(other);
  if (linalg::part().size > 1)
    throw Error(second.where, "[switch] works with one process; leave out mpirun");
  if (other.second)
    throw Error(second.where,
                "[switch] to: the second case has a section [switch], too; one switch is possible");
  const std::filesystem::path folder = result_folder(description, options);
  const Place place = make_place(folder);
  const Place next_place = make_place(folder / second.path.stem());
  const auto now = [] { return std::chrono::steady_clock::now(); };
  if (options.restart && output::latest_complete(next_place.checkpoints, 1))
  {
    Simulation next(other);
    return carry_out(next, Begin::checkpoint, next_place, now(), {}, std::nullopt).exit;
  }
  Simulation first(description);
  Simulation next(other);
  const Handover handover(first, next);
  output::remove_all(next_place.checkpoints);
  const Begin begin = options.restart ? Begin::checkpoint : Begin::rest;
  const Outcome outcome = carry_out(first, begin, place, now(), {}, second);
  if (!outcome.switches)
    return outcome.exit;
  if (!hand_over(handover, first, next, next_place.folder))
    return Exit::failed;
  return carry_out(next, Begin::transfer, next_place, now(), {}, std::nullopt).exit;
}

}  // namespace

std::filesystem::path result_folder(const case_file::Case& description, const RunOptions& options)
{
  if (!options.directory.empty())
    return options.directory;
  const std::filesystem::path beside = description.path.parent_path();
  return beside / (description.output.directory.empty() ? "results" : description.output.directory);
}

Outcome run_observed(const case_file::Case& description, const RunOptions& options, const Observer& observer)
{
  require_solvable(description);
  const Place place = make_place(result_folder(description, options));
  const auto start = std::chrono::steady_clock::now();
  Simulation simulation(description);
  try
  {
    return carry_out(simulation, options.restart ? Begin::checkpoint : Begin::rest, place, start, observer,
                     std::nullopt);
  }
  catch (const std::exception& error)
  {
    end_unless_all_failed(error);
    throw;
  }
}

Exit run(const case_file::Case& description, const RunOptions& options)
{
  return description.second ? run_both(description, options) : run_observed(description, options, {}).exit;
}

}  // namespace blockfsi::run
