#include "run/run.hpp"

#include "linalg/communicator.hpp"
#include "output/checkpoint.hpp"
#include "run/failure.hpp"
#include "run/handover.hpp"
#include "run/interrupt.hpp"
#include "run/layouts.hpp"
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
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

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

/// Where a run writes, and the number that tells it from other runs.
struct Place
{
  std::filesystem::path folder;
  std::filesystem::path checkpoints;
  std::uint64_t run;
  std::filesystem::path case_path;   ///< of the whole run, whichever layout it is in
  std::filesystem::path run_folder;  ///< the same
};

Place make_place(const std::filesystem::path& folder, const case_file::Case& description,
                 const std::filesystem::path& run_folder)
{
  const auto now = linalg::from_first(std::chrono::system_clock::now().time_since_epoch().count());
  return {folder, folder / "checkpoint", static_cast<std::uint64_t>(now), description.path, run_folder};
}

void conclude(const Simulation& simulation, const Place& place)
{
  const std::filesystem::path& folder = place.folder;
  say("results are in {}\n", folder.string());
  for (const std::string_view table : {"probes.csv", "forces.csv", "quality.csv"})
    if (std::filesystem::exists(folder / table))
      say("  {:<12} one row per step\n", table);
  say("  fields.pvd   open in ParaView; colour by velocity, press play\n");
  const std::filesystem::path& path = place.case_path;
  if (simulation.finished() && std::filesystem::exists(path.parent_path() / "reference.csv"))
    say("next: ./dev verify --finished {} --directory {}\n", path.string(), place.run_folder.string());
}

/// What a run begins with.
enum class Begin
{
  rest,
  checkpoint,
  transfer  ///< from another layout; it was done already
};

/// Whether another layout, if there is one, takes over from the accepted state.
bool is_due(const case_file::Switch* next, const Simulation& simulation)
{
  constexpr double rounding = 1e-9;
  return next && !simulation.finished() &&
         (simulation.fluid()->quality().scaled_jacobian < next->below ||
          (next->at && simulation.time() > *next->at - rounding * simulation.description().time.step));
}

/// Tells why the last step failed, with a picture of a mesh that was refused.
Outcome end_failed(const Simulation& simulation, const StepReport& report, const Place& place)
{
  std::string picture;
  if (report.refused)
  {
    draw_refused(place.folder / refused_picture, simulation, *report.refused);
    picture = fmt::format("; {} shows the blocks around the cell", (place.folder / refused_picture).string());
  }
  if (linalg::part().rank == 0)
    fmt::print(stderr, "blockfsi: {}; the last good state (t = {:g} s) is in the results{}\n", report.failure,
               simulation.time(), picture);
  Outcome ending;
  ending.exit = Exit::failed;
  ending.failure = report.failure;
  return ending;
}

/// Does one step after the other, until the end, a failure or a signal, or until another layout takes over;
/// how they ended. A run that continues may have been interrupted when the other layout was due.
Outcome step_through(Simulation& simulation, Results& results, const InterruptGuard& guard,
                     const Place& place, const Observer& observer, Begin begin, const case_file::Switch* next)
{
  const int checkpoint_every = simulation.description().output.checkpoint_every;
  Progress progress(simulation);
  Outcome ending;
  if (begin == Begin::checkpoint && is_due(next, simulation))
  {
    ending.switches = true;
    return ending;
  }
  while (!simulation.finished())
  {
    const StepReport report = simulation.advance();
    if (!report.ok)
    {
      progress.end();
      if (!next || !report.refused)
        return end_failed(simulation, report, place);
      say("{}; another layout takes over\n", report.failure);
      ending.switches = true;
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
    if (is_due(next, simulation))
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
                  const case_file::Switch* next)
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
  Outcome outcome = step_through(simulation, results, guard, place, observer, begin, next);
  if (outcome.exit != Exit::interrupted)
  {
    const Stopwatch watch(simulation.timings(), Task::output);
    results.add_fields();
  }
  write_checkpoint(simulation, place.checkpoints, place.run);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  say("{}", timing_summary(simulation.timings(), wall.count(), simulation.step() - first_step));
  conclude(simulation, place);
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

/// Carries the state to the next layout and writes what that cost; false if it cannot go on.
bool hand_over(const Handover& handover, const Simulation& from, Simulation& next,
               const std::filesystem::path& folder)
{
  const HandoverReport report = handover.carry(from, next);
  if (!report.failure.empty())
  {
    if (linalg::part().rank == 0)
      fmt::print(
          stderr,
          "blockfsi: '{}' cannot take over at t = {:g} s: {}; the last good state is in the results of "
          "the layout before\n",
          next.description().path.string(), from.time(), report.failure);
    return false;
  }
  say("{} takes over at t = {:g} s: least scaled Jacobian {:.3g} -> {:.3g}, transfer error of the velocity "
      "{:.2g}, of the pressure {:.2g}\n",
      next.description().path.string(), from.time(), from.fluid()->quality().scaled_jacobian,
      report.quality.scaled_jacobian, report.velocity_error, report.pressure_error);
  if (linalg::part().rank == 0)
    write_transfer(folder, from, report);
  return true;
}

/// The cases of all layouts, the given one first.
std::vector<case_file::Case> read_layouts(const case_file::Case& description)
{
  std::vector<case_file::Case> result = {description};
  for (const case_file::Switch& next : description.switches)
  {
    if (!result.emplace_back(case_file::read(next.path)).switches.empty())
      throw Error(next.where,
                  fmt::format("[switch] to: '{}' has a section [switch], too; name all layouts here, "
                              "in a [[switch]] for each",
                              next.path.string()));
  }
  for (const case_file::Case& layout : result)
    require_solvable(layout);
  return result;
}

/// The last layout that has a checkpoint, or the first. One that was written by another number of processes
/// counts, too: the restart tells.
std::size_t last_begun(const std::vector<Place>& places)
{
  std::int64_t last = 0;
  if (linalg::part().rank == 0)
    for (std::size_t i = 1; i < places.size(); ++i)
      try
      {
        if (output::latest_complete(places[i].checkpoints, linalg::part().size))
          last = static_cast<std::int64_t>(i);
      }
      catch (const Error&)
      {
        last = static_cast<std::int64_t>(i);
      }
  return static_cast<std::size_t>(linalg::from_first(last));
}

/// Runs a case whose blocks change. All layouts are made before the first step, which finds what does not
/// fit.
Exit run_layouts(const case_file::Case& description, const RunOptions& options)
{
  const std::vector<case_file::Case> cases = read_layouts(description);
  const std::vector<case_file::Switch>& switches = description.switches;
  const std::filesystem::path run_folder = result_folder(description, options);
  std::vector<Place> places;
  for (const std::filesystem::path& folder : layout_folders(description, run_folder))
    places.push_back(make_place(folder, description, run_folder));

  std::size_t at = options.restart ? last_begun(places) : 0;
  std::vector<std::unique_ptr<Simulation>> layouts(cases.size());
  std::vector<std::optional<Handover>> handovers(cases.size());
  for (std::size_t i = at; i < cases.size(); ++i)
  {
    layouts[i] = std::make_unique<Simulation>(cases[i]);
    if (i > at)
      handovers[i].emplace(*layouts[i - 1], *layouts[i], switches[i - 1].where);
    if (i > at && linalg::part().rank == 0)
      forget(places[i].folder);
  }
  Begin begin = options.restart ? Begin::checkpoint : Begin::rest;
  for (;; ++at)
  {
    const case_file::Switch* next = at < switches.size() ? &switches[at] : nullptr;
    const Outcome outcome =
        carry_out(*layouts[at], begin, places[at], std::chrono::steady_clock::now(), {}, next);
    if (!outcome.switches)
      return outcome.exit;
    if (!hand_over(*handovers[at + 1], *layouts[at], *layouts[at + 1], places[at + 1].folder))
      return Exit::failed;
    layouts[at].reset();
    begin = Begin::transfer;
  }
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
  const std::filesystem::path folder = result_folder(description, options);
  const Place place = make_place(folder, description, folder);
  const auto start = std::chrono::steady_clock::now();
  Simulation simulation(description);
  try
  {
    return carry_out(simulation, options.restart ? Begin::checkpoint : Begin::rest, place, start, observer,
                     nullptr);
  }
  catch (const std::exception& error)
  {
    end_unless_all_failed(error);
    throw;
  }
}

Exit run(const case_file::Case& description, const RunOptions& options)
{
  return description.switches.empty() ? run_observed(description, options, {}).exit
                                      : run_layouts(description, options);
}

}  // namespace blockfsi::run
