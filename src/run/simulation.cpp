#include "run/simulation.hpp"

#include "linalg/communicator.hpp"
#include "run/interfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace blockfsi::run
{

namespace
{

/// Steps in which ringing falls by e where the case does not say a time.
constexpr double default_ringing_decay = 20.0;

std::string explain(std::string_view what, const linalg::NewtonReport& report)
{
  switch (report.status)
  {
  case linalg::NewtonStatus::too_many_iterations:
    return fmt::format(
        "Newton's method for the {} needs more than {} iterations (last relative increment {:.2g})", what,
        report.iterations, report.increment);
  case linalg::NewtonStatus::diverged:
    if (report.iterations == 0)
      return fmt::format(
          "the first linear solution for the {} failed: a prescribed value or the state is not finite, "
          "or an iterative solver did not converge",
          what);
    return fmt::format(
        "Newton's method for the {} diverged after {} iterations (last relative increment {:.2g})", what,
        report.iterations, report.increment);
  case linalg::NewtonStatus::singular:
    return fmt::format("the matrix of the {} is singular", what);
  default:
    return {};
  }
}

}  // namespace

Simulation::Simulation(const case_file::Case& description)
    : case_(description), skeleton_(block::make_skeleton(description.layout))
{
  const Interfaces interfaces = match_interfaces(case_, skeleton_);
  const auto& own = interfaces.own;
  const block::Skeleton& solid_skeleton = own ? own->skeleton : skeleton_;
  for (const std::int64_t node : interfaces.solid)
    interface_points_.insert(interface_points_.end(),
                             {solid_skeleton.x[2 * node], solid_skeleton.x[2 * node + 1]});
  if (case_.fluid)
    fluid_ = std::make_unique<FluidSide>(case_, skeleton_, interfaces.fluid, interfaces.transfer, timings_);
  if (case_.solid)
    solid_ = std::make_unique<SolidSide>(own ? own->layout : case_.layout, solid_skeleton, *case_.solid,
                                         interfaces.solid, timings_);
  if (own)
    solid_skeleton_x_ = own->skeleton.x;
  if (fluid_ && solid_)
    acceleration_ = std::make_unique<coupling::Acceleration>(case_.coupling, interface_points_.size());
  past_.d.emplace_back(interface_points_.size(), 0.0);
}

Simulation::~Simulation() = default;

std::int64_t Simulation::step_count() const
{
  if (case_.time.scheme == fem::Scheme::steady)
    return 1;
  return start_step_ + std::max(0LL, std::llround((case_.time.end - start_time_) / case_.time.step));
}

std::int64_t Simulation::unknown_count() const
{
  return (fluid_ ? fluid_->unknown_count() : 0) + (solid_ ? solid_->unknown_count() : 0);
}

std::string Simulation::when() const
{
  if (case_.time.scheme == fem::Scheme::steady)
    return "in the steady solution";
  return fmt::format("in step {} (t = {:g} s to {:g} s)", step_ + 1, time_, time_ + case_.time.step);
}

/// The parts of the next step if it is cut into pieces: each is one, or two backward Euler half steps at the
/// start. The geometry is that of the middle also for backward Euler: so what flows in is exactly what the
/// volume grows by.
std::vector<fem::TimeStep> Simulation::substeps(int pieces) const
{
  const fem::TimeParameters& time = case_.time;
  if (time.scheme == fem::Scheme::steady)
    return {{0.0, 0.0, 1.0, 1.0}};
  const bool starts = time.scheme == fem::Scheme::crank_nicolson && step_ < time.start_up;
  const int count = starts ? 2 * pieces : pieces;
  const double dt = time.step / count;
  const double decay = time.ringing_decay > 0.0 ? time.ringing_decay : default_ringing_decay * time.step;
  const bool implicit = starts || time.scheme == fem::Scheme::backward_euler;
  std::vector<fem::TimeStep> result;
  for (int k = 0; k < count; ++k)
    result.push_back({time_ + k * dt, dt, implicit ? 1.0 : std::min(1.0, 0.5 + dt / (4.0 * decay)), 0.5});
  return result;
}

bool Simulation::try_pieces(int pieces, StepReport& report)
{
  report.pieces = pieces;
  report.refused.reset();
  report.failure.clear();
  const std::vector<fem::TimeStep> steps = substeps(pieces);
  return std::all_of(steps.begin(), steps.end(),
                     [&](const fem::TimeStep& step) { return substep(step, report); });
}

StepReport Simulation::advance()
{
  StepReport report;
  // A part of the step that went well, factors and the accelerator's columns do not outlive its failure.
  const output::Arrays before = save();
  const int cuts = case_.time.scheme == fem::Scheme::steady ? 0 : case_.time.cuts;
  std::string failure;
  for (int cut = 0;; ++cut)
  {
    if (try_pieces(1 << cut, report))
      break;
    failure = report.failure;
    restore(before);
    if (cut == cuts)
    {
      report.ok = false;
      if (cut > 0)
        report.failure += fmt::format(", also with the step cut into {}", report.pieces);
      return report;
    }
  }
  report.failure = failure;
  ++step_;
  if (case_.time.scheme != fem::Scheme::steady)
    time_ = start_time_ + static_cast<double>(step_ - start_step_) * case_.time.step;
  if (fluid_)
  {
    report.quality = fluid_->quality();
    report.certified = fluid_->certify().all_valid();
  }
  return report;
}

bool Simulation::substep(const fem::TimeStep& step, StepReport& report)
{
  if (fluid_)
    fluid_->begin(step);
  if (solid_)
    solid_->begin(step);
  if (fluid_ && solid_)
  {
    if (!couple(step, report))
      return false;
  }
  else if (fluid_)
  {
    if (!solve_fluid(report))
      return false;
  }
  else if (solid_ && !solve_solid({}, report))
    return false;
  if (fluid_)
    fluid_->accept();
  if (solid_)
    solid_->accept();
  return true;
}

bool Simulation::couple(const fem::TimeStep& step, StepReport& report)
{
  std::vector<double> d(interface_points_.size());
  coupling::predict(case_.coupling.predictor, past_, step.step, d);
  const coupling::Limits limits{case_.coupling.tolerance, case_.coupling.iterations, 0.0};
  const coupling::Report coupled =
      coupling::solve_partitioned([&](std::span<const double> input, std::span<double> answer)
                                  { return evaluate(input, answer, report); },
                                  *acceleration_, limits, d, past_.d.front());
  report.coupling_iterations += coupled.iterations;
  if (coupled.status != coupling::Status::converged)
  {
    if (report.failure.empty())
      report.failure =
          fmt::format("the coupling of fluid and solid did not converge {}: after {} iterations the "
                      "interface is off by {:.2g} of its displacement in the step",
                      when(), coupled.iterations, coupled.residuals.empty() ? NAN : coupled.residuals.back());
    return false;
  }
  coupling::remember(past_, d, step.step);
  return true;
}

bool Simulation::evaluate(std::span<const double> d, std::span<double> answer, StepReport& report)
{
  const motion::Report moved = fluid_->move(d);
  report.renewals += moved.factorisations;
  if (!moved.ok)
  {
    report.failure = fmt::format("{} {}", moved.failure, when());
    return false;
  }
  if (!accept_mesh(report))
    return false;
  if (!solve_fluid(report))
    return false;
  std::vector<double> load(answer.size());
  fluid_->load(load);
  if (!solve_solid(load, report))
    return false;
  solid_->displacement(answer);
  return true;
}

/// Whether the flow may be solved on the mesh as it was moved: every cell must be proved valid.
bool Simulation::accept_mesh(StepReport& report)
{
  const mesh::Validity validity = fluid_->certify_moved();
  if (validity.all_valid())
    return true;
  const mesh::Quality& quality = fluid_->quality();
  const bool folded = quality.scaled_jacobian <= 0.0;
  report.refused = {folded ? quality.cell : validity.cell,
                    folded ? quality.block : validity.block,
                    {fluid_->x_moved().begin(), fluid_->x_moved().end()}};
  report.failure = fmt::format(
      "the fluid mesh {} {}: cell {} of {} {}", folded ? "folds over" : "is not proved valid", when(),
      report.refused->cell,
      report.refused->block >= 0 ? case_.layout.blocks[report.refused->block].name : std::string("?"),
      folded ? fmt::format("has a scaled Jacobian of {:.3g}", quality.scaled_jacobian)
             : fmt::format("may fold between its nodes (least scaled Jacobian at samples {:.3g})",
                           quality.scaled_jacobian));
  return false;
}

bool Simulation::solve_fluid(StepReport& report)
{
  return account("flow", fluid_->solve(), report.fluid_iterations, report);
}

bool Simulation::solve_solid(std::span<const double> load, StepReport& report)
{
  return account("solid", solid_->solve(load), report.solid_iterations, report);
}

bool Simulation::account(std::string_view what, const linalg::NewtonReport& solved, int& iterations,
                         StepReport& report) const
{
  iterations += solved.iterations;
  report.renewals += solved.renewals;
  if (solved.status == linalg::NewtonStatus::converged)
    return true;
  report.failure = explain(what, solved) + " " + when();
  return false;
}

}  // namespace blockfsi::run
