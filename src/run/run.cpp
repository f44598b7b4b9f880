#include "run/run.hpp"

#include "linalg/communicator.hpp"
#include "run/failure.hpp"
#include "run/interrupt.hpp"
#include "run/progress.hpp"
#include "run/refused.hpp"
#include "run/results.hpp"
#include "run/simulation.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
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

/// Does one step after the other, until the end, a failure or a signal; a failure's reason goes to `failure`.
Exit step_through(Simulation& simulation, Results& results, const InterruptGuard& guard, const Place& place,
                  const Observer& observer, std::string& failure)
{
  const int checkpoint_every = simulation.description().output.checkpoint_every;
  Progress progress(simulation);
  while (!simulation.finished())
  {
    const StepReport report = simulation.advance();
    if (!report.ok)
    {
      progress.end();
      failure = report.failure;
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
      return Exit::failed;
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
      return Exit::interrupted;
    }
    if (simulation.step() % checkpoint_every == 0)
      write_checkpoint(simulation, place.checkpoints, place.run);
  }
  progress.end();
  return Exit::done;
}

Outcome carry_out(Simulation& simulation, bool is_restart, const Place& place,
                  std::chrono::steady_clock::time_point start, const Observer& observer)
{
  const case_file::Case& description = simulation.description();
  const InterruptGuard guard;
  if (is_restart)
    restart(simulation, place.checkpoints);
  else if (linalg::part().rank == 0)
    output::remove_all(place.checkpoints);
  introduce(simulation, place.folder);
  Results results(place.folder, simulation, is_restart);
  const bool starts_from_rest = !is_restart && description.time.scheme != fem::Scheme::steady;
  if (starts_from_rest && description.output.every > 0.0)
    results.add_fields();

  const std::int64_t first_step = simulation.step();
  Outcome outcome;
  outcome.exit = step_through(simulation, results, guard, place, observer, outcome.failure);
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
  if (!description.fluid && !description.solid)
    throw Error({description.path.string()}, "there is nothing to solve: the case has neither [fluid] nor "
                                             "[solid]; `blockfsi mesh` makes its mesh");
  if (description.layout.dim != 2)
    throw Error(
        {description.path.string()},
        "only blocks of two dimensions can be simulated; `blockfsi mesh` makes the mesh, and `blockfsi "
        "compare --prescribed` moves it");
  const std::filesystem::path folder = result_folder(description, options);
  const auto start = std::chrono::steady_clock::now();
  const auto now = linalg::from_first(std::chrono::system_clock::now().time_since_epoch().count());
  Simulation simulation(description);
  try
  {
    return carry_out(simulation, options.restart,
                     {folder, folder / "checkpoint", static_cast<std::uint64_t>(now)}, start, observer);
  }
  catch (const std::exception& error)
  {
    end_unless_all_failed(error);
    throw;
  }
}

Exit run(const case_file::Case& description, const RunOptions& options)
{
  return run_observed(description, options, {}).exit;
}

}  // namespace blockfsi::run
