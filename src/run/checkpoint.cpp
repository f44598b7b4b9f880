#include "run/simulation.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace blockfsi::run
{

namespace
{

[[noreturn]] void refuse(std::string_view why)
{
  throw Error(fmt::format("the checkpoint belongs to another case: {}; start anew without --restart", why));
}

/// An array of a checkpoint that must have as many entries as this run has.
std::vector<double> take(const output::Arrays& arrays, const std::string& name, std::size_t size)
{
  std::vector<double> values = output::get<std::vector<double>>(arrays, name);
  if (values.size() != size)
    refuse(fmt::format("its array '{}' has {} entries where this case needs {}", name, values.size(), size));
  return values;
}

void put(output::Arrays& arrays, const std::string& prefix, const fluid::State& state)
{
  arrays[prefix + "u"] = state.u;
  arrays[prefix + "change"] = state.change;
  arrays[prefix + "p"] = state.p;
  arrays[prefix + "p_before"] = state.p_before;
  arrays[prefix + "times"] = std::vector<double>{state.time, state.p_time, state.p_before_time};
}

fluid::State fluid_state(const output::Arrays& arrays, const std::string& prefix, std::size_t nodes)
{
  fluid::State state;
  state.u = take(arrays, prefix + "u", 2 * nodes);
  state.change = take(arrays, prefix + "change", 2 * nodes);
  state.p = take(arrays, prefix + "p", nodes);
  state.p_before = take(arrays, prefix + "p_before", nodes);
  const std::vector<double> times = take(arrays, prefix + "times", 3);
  state.time = times[0];
  state.p_time = times[1];
  state.p_before_time = times[2];
  return state;
}

void put(output::Arrays& arrays, const std::string& prefix, const fluid::Solver::Linearisation& kept)
{
  const fem::TimeStep& step = kept.step;
  arrays[prefix + "step"] =
      std::vector<double>{kept.stale ? 1.0 : 0.0, step.t, step.step, step.theta, step.geometry};
  arrays[prefix + "z"] = kept.z;
  arrays[prefix + "x"] = kept.x;
  arrays[prefix + "w"] = kept.w;
  arrays[prefix + "u_old"] = kept.u_old;
}

fluid::Solver::Linearisation fluid_linearisation(const output::Arrays& arrays, const std::string& prefix)
{
  using Values = std::vector<double>;
  const Values step = take(arrays, prefix + "step", 5);
  return {step[0] != 0.0,
          {step[1], step[2], step[3], step[4]},
          output::get<Values>(arrays, prefix + "z"),
          output::get<Values>(arrays, prefix + "x"),
          output::get<Values>(arrays, prefix + "w"),
          output::get<Values>(arrays, prefix + "u_old")};
}

}  // namespace

output::Arrays Simulation::save() const
{
  output::Arrays arrays;
  arrays["skeleton"] = skeleton_.x;
  arrays["solid.skeleton"] = solid_skeleton_x_;
  arrays["step"] = std::vector<std::int64_t>{step_, start_step_};
  arrays["time"] = std::vector<double>{time_, start_time_, case_.time.step};
  if (fluid_)
  {
    put(arrays, "fluid.", fluid_->state());
    put(arrays, "fluid.linearisation.", fluid_->solver().linearisation());
    arrays["fluid.mesh_memory"] = fluid_->mesh_memory();
  }
  if (solid_)
  {
    arrays["solid.d"] = solid_->state().d;
    arrays["solid.v"] = solid_->state().v;
  }
  if (acceleration_)
  {
    const coupling::History& history = acceleration_->history();
    arrays["coupling.V"] = history.V;
    arrays["coupling.W"] = history.W;
    arrays["coupling.columns"] = history.columns_per_step;
    arrays["coupling.residual"] = history.last_residual;
    arrays["coupling.answer"] = history.last_answer;
    arrays["coupling.omega"] = std::vector<double>{history.omega};
    for (std::size_t i = 0; i < past_.d.size(); ++i)
      arrays[fmt::format("interface.{}", i)] = past_.d[i];
    arrays["interface.step"] = std::vector<double>{past_.step, static_cast<double>(past_.d.size())};
  }
  return arrays;
}

void Simulation::restore(const output::Arrays& arrays)
{
  using Values = std::vector<double>;
  if (output::get<Values>(arrays, "skeleton") != skeleton_.x ||
      output::get<Values>(arrays, "solid.skeleton") != solid_skeleton_x_)
    refuse("its blocks or divisions are others");
  const Values clock = take(arrays, "time", 3);
  const bool same_steps = clock[2] == case_.time.step;
  const auto steps = output::get<std::vector<std::int64_t>>(arrays, "step");
  if (steps.size() < 2)
    refuse("it was written by another version");
  step_ = steps[0];
  time_ = clock[0];
  start_step_ = same_steps ? steps[1] : step_;
  start_time_ = same_steps ? clock[1] : time_;
  if (acceleration_)
  {
    coupling::History history;
    history.V = output::get<Values>(arrays, "coupling.V");
    history.W = output::get<Values>(arrays, "coupling.W");
    history.columns_per_step = output::get<std::vector<std::int32_t>>(arrays, "coupling.columns");
    history.last_residual = output::get<Values>(arrays, "coupling.residual");
    history.last_answer = output::get<Values>(arrays, "coupling.answer");
    history.omega = take(arrays, "coupling.omega", 1)[0];
    acceleration_->restore(std::move(history));
    const Values step = take(arrays, "interface.step", 2);
    if (step[1] < 1.0)
      refuse("it was written by another version");
    past_ = {{}, step[0]};
    for (std::size_t i = 0; i < static_cast<std::size_t>(step[1]); ++i)
      past_.d.push_back(take(arrays, fmt::format("interface.{}", i), interface_points_.size()));
  }
  if (fluid_)
  {
    fluid_->restore(fluid_state(arrays, "fluid.", fluid_->mesh().node_count()), past_.d.front(),
                    output::get<Values>(arrays, "fluid.mesh_memory"));
    fluid_->solver().restore(fluid_linearisation(arrays, "fluid.linearisation."));
  }
  if (solid_)
  {
    const std::size_t size = 2 * solid_->mesh().node_count();
    solid_->restore({take(arrays, "solid.d", size), take(arrays, "solid.v", size), time_});
  }
}

}  // namespace blockfsi::run
