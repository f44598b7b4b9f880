#include "fluid/solver.hpp"

#include "fem/boundary.hpp"
#include "fem/nodal.hpp"
#include "fluid/flow.hpp"
#include "linalg/communicator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace blockfsi::fluid
{

namespace
{

/// Flow through a side in the first component, the speed along it in the second.
struct Flux
{
  static constexpr int unknowns = 3;
  static constexpr int data = 0;

  template <class S>
  std::array<S, 3> operator()(const fem::SideInput<S, 3, 0>& in) const
  {
    const S outward = in.value[0] * in.normal[0] + in.value[1] * in.normal[1];
    return {outward, std::hypot(in.value[0], in.value[1]), S(0.0)};
  }
};

/// Net flow through the boundary of an enclosed fluid, relative to the speed along it, that counts as none:
/// boundary values are interpolated at the nodes only.
constexpr double balance_tolerance = 1e-2;

std::vector<std::uint8_t> fixed_everywhere(const Conditions& conditions, const mesh::Mesh& mesh,
                                           const linalg::Numbering& numbering)
{
  std::vector<std::uint8_t> fixed = fixed_unknowns(conditions, mesh);
  fem::agree(numbering, fixed, 3);
  return fixed;
}

}  // namespace

std::vector<double> State::pressure_now() const
{
  std::vector<double> result = p;
  const double span = p_time - p_before_time;
  if (span > 0.0)
    for (std::size_t i = 0; i < p.size(); ++i)
      result[i] += (time - p_time) / span * (p[i] - p_before[i]);
  return result;
}

/// What Newton's method asks of the flow during one solution.
struct Solver::Problem
{
  Solver& solver;
  fem::TimeStep step;
  std::span<const double> u_old;
  MeshMotion motion;

  Flow flow() const
  {
    const Parameters& parameters = solver.parameters_;
    const bool steady = step.step == 0.0;
    const double fixed = parameters.stabilisation_time;
    const int order = solver.mesh_->order;
    return {.density = parameters.density,
            .viscosity = parameters.viscosity,
            .rate = steady ? 0.0 : 1.0 / (step.theta * step.step),
            .step_frequency = steady ? 0.0 : 2.0 / (fixed > 0.0 ? fixed : step.step),
            .order = order,
            .inverse_constant = inverse_constant(order)};
  }

  std::array<fem::NodalField, 3> data() const
  {
    return {{{u_old.data(), 2}, {motion.w.data(), 2}, {solver.body_force_.data(), 2}}};
  }

  /// Calls visit(physics, sides) for each open boundary.
  template <class Visit>
  void for_open_boundaries(Visit visit) const
  {
    const Parameters& parameters = solver.parameters_;
    const double t = step.t + step.theta * step.step;
    for (const BoundaryCondition& condition : parameters.boundaries)
    {
      OpenBoundary open{.density = parameters.density,
                        .viscosity = parameters.viscosity,
                        .backflow = parameters.backflow,
                        .do_nothing = false,
                        .traction = {}};
      if (const auto* traction = std::get_if<Traction>(&condition.condition))
        open.traction = [traction, t](const std::array<double, 2>& x, const std::array<double, 2>&)
        {
          return std::array<double, 2>{traction->value[0](x[0], x[1], 0.0, t),
                                       traction->value[1](x[0], x[1], 0.0, t)};
        };
      else if (const auto* outflow = std::get_if<Outflow>(&condition.condition))
      {
        open.do_nothing = true;
        open.traction = [outflow, t](const std::array<double, 2>& x, const std::array<double, 2>& n)
        {
          const double pressure = outflow->pressure(x[0], x[1], 0.0, t);
          return std::array<double, 2>{-pressure * n[0], -pressure * n[1]};
        };
      }
      else
        continue;
      const auto found = solver.mesh_->boundaries.find(condition.boundary);
      if (found != solver.mesh_->boundaries.end())
        visit(open, std::span<const mesh::Side>(found->second));
    }
  }

  void residual(std::span<const double> z, std::span<double> r) const
  {
    std::fill(r.begin(), r.end(), 0.0);
    const auto fields = data();
    solver.cells_.add_residual(flow(), motion.x, z, fields, r);
    const std::array<fem::NodalField, 1> velocity = {{{motion.w.data(), 2}}};
    for_open_boundaries([&](const OpenBoundary& open, std::span<const mesh::Side> sides)
                        { solver.sides_.add_residual(open, sides, motion.x, z, velocity, r); });
  }

  void tangent(std::span<const double> z, std::span<double> matrices) const
  {
    const auto fields = data();
    solver.cells_.tangent(flow(), motion.x, z, fields, matrices);
    const std::array<fem::NodalField, 1> velocity = {{{motion.w.data(), 2}}};
    for_open_boundaries([&](const OpenBoundary& open, std::span<const mesh::Side> sides)
                        { solver.sides_.add_tangent(open, sides, motion.x, z, velocity, matrices); });
  }

  void remember(std::span<const double> z) const
  {
    Linearisation& kept = solver.linearisation_;
    kept.step = step;
    kept.z.assign(z.begin(), z.end());
    kept.x.assign(motion.x.begin(), motion.x.end());
    kept.w.assign(motion.w.begin(), motion.w.end());
    kept.u_old.assign(u_old.begin(), u_old.end());
  }

  /// Larger of the relative increments of velocity and pressure, in the root of the mean of squares.
  double size(std::span<const double> increment, std::span<const double> z) const
  {
    std::array<double, 4> sums{};
    for (const std::int32_t node : solver.numbering_->owned())
    {
      const std::size_t i = 3 * static_cast<std::size_t>(node);
      sums[0] += increment[i] * increment[i] + increment[i + 1] * increment[i + 1];
      sums[1] += z[i] * z[i] + z[i + 1] * z[i + 1];
      sums[2] += increment[i + 2] * increment[i + 2];
      sums[3] += z[i + 2] * z[i + 2];
    }
    linalg::sum(sums);
    const double count = static_cast<double>(solver.numbering_->total_count());
    const double density = solver.parameters_.density;
    // A pressure is small if it is small against the dynamic pressure too. A fluid at rest under pressure has
    // round-off for a velocity: small against what the pressure could bring about.
    const double dynamic_pressure = density * sums[1] / count;
    const double pressure = std::max(std::sqrt(sums[3] / count), dynamic_pressure);
    const double velocity = std::max(std::sqrt(sums[1] / count), 1e-3 * std::sqrt(pressure / density));
    const auto ratio = [](double part, double whole) {
      return whole > 0.0 ? part / whole : part > 0.0 ? 1.0 : 0.0;
    };
    return std::max(ratio(std::sqrt(sums[0] / count), velocity), ratio(std::sqrt(sums[2] / count), pressure));
  }
};

Solver::Solver(const Parameters& parameters, const mesh::Mesh& mesh, const linalg::Numbering& numbering,
               std::span<const double> x, Timings& timings)
    : parameters_(parameters), mesh_(&mesh), numbering_(&numbering), timings_(&timings),
      x0_(x.begin(), x.end()), cells_(mesh, fem::quadrature_points(mesh.order)),
      sides_(mesh, fem::quadrature_points(mesh.order)),
      conditions_(find_conditions(parameters, mesh, numbering, x)), body_force_(2 * mesh.node_count(), 0.0),
      system_(numbering, 3, mesh.cells, mesh.nodes_per_cell(), fixed_everywhere(conditions_, mesh, numbering),
              "fluid_")
{
}

State Solver::initial() const
{
  const std::size_t count = mesh_->node_count();
  State state;
  state.u.resize(2 * count);
  fem::evaluate_at_nodes(parameters_.initial_velocity, x0_, 0.0, state.u);
  state.change.assign(2 * count, 0.0);
  state.p.assign(count, 0.0);
  state.p_before.assign(count, 0.0);
  return state;
}

void Solver::guess(const fem::TimeStep& step, const State& old, std::span<double> z) const
{
  for (std::size_t node = 0; node < mesh_->node_count(); ++node)
  {
    for (int c = 0; c < 2; ++c)
      z[3 * node + c] = old.u[2 * node + c] + step.theta * old.change[2 * node + c];
    z[3 * node + 2] = old.p[node];
  }
}

void Solver::apply_conditions(const fem::TimeStep& step, const State& old, const MeshMotion& motion,
                              std::span<double> z) const
{
  const double end = step.t + step.step;
  for (const Prescribed& entry : conditions_.prescribed)
  {
    const std::size_t i = 2 * static_cast<std::size_t>(entry.node) + entry.component;
    double& value = z[3 * static_cast<std::size_t>(entry.node) + entry.component];
    if (entry.kind == Prescribed::Kind::interface)
    {
      value = motion.w[i];
      continue;
    }
    const double* x = &x0_[2 * static_cast<std::size_t>(entry.node)];
    const double at_end =
        entry.kind == Prescribed::Kind::expression ? entry.value(x[0], x[1], 0.0, end) : 0.0;
    value = step.theta * at_end + (1.0 - step.theta) * old.u[i];
  }
}

void Solver::check_balance(const fem::TimeStep& step, const MeshMotion& motion, std::span<const double> z)
{
  std::vector<double> residual(z.size(), 0.0);
  for (const auto& [name, sides] : mesh_->boundaries)
    sides_.add_residual(Flux{}, sides, motion.x, z, {}, residual);
  std::array<double, 2> sums{};
  for (std::size_t i = 0; i < residual.size(); i += 3)
    for (std::size_t c = 0; c < 2; ++c)
      sums[c] += residual[i + c];
  linalg::sum(sums);
  if (std::abs(sums[0]) > balance_tolerance * sums[1])
    throw Error(
        parameters_.boundaries.front().where,
        fmt::format(
            "all boundaries of the fluid prescribe the velocity, but at t = {:g} s {:.3g} m^2/s more {} "
            "than {}; give one boundary outflow or traction",
            step.t + step.step, std::abs(sums[0]), sums[0] < 0.0 ? "flows in" : "flows out",
            sums[0] < 0.0 ? "out" : "in"));
}

void Solver::compute_body_force(const fem::TimeStep& step, std::span<const double> x)
{
  fem::evaluate_at_nodes(parameters_.body_force, x, step.t + step.theta * step.step, body_force_);
}

linalg::NewtonReport Solver::solve(const fem::TimeStep& step, const State& old, const MeshMotion& motion,
                                   std::span<double> z)
{
  apply_conditions(step, old, motion, z);
  if (conditions_.enclosed)
    check_balance(step, motion, z);
  compute_body_force(step, motion.x);
  // Factors of another kind of step are worthless.
  const fem::TimeStep& kept = linearisation_.step;
  if (kept.theta * kept.step != step.theta * step.step)
    factors_.stale = true;
  Problem problem{*this, step, old.u, motion};
  const linalg::NewtonLimits limits{parameters_.newton.tolerance, parameters_.newton.iterations};
  const linalg::NewtonReport report = linalg::newton(limits, system_, factors_, problem, z, *timings_);
  linearisation_.stale = factors_.stale;
  return report;
}

std::vector<double> Solver::reaction(const fem::TimeStep& step, const State& old, const MeshMotion& motion,
                                     std::span<const double> z)
{
  const Stopwatch watch(*timings_, Task::transfer);
  std::vector<double> result(z.size());
  compute_body_force(step, motion.x);
  Problem{*this, step, old.u, motion}.residual(z, result);
  numbering_->add_from_ghosts(result, 3);
  return result;
}

State Solver::finish(const fem::TimeStep& step, const State& old, std::span<const double> z) const
{
  State state = old;
  for (std::size_t node = 0; node < mesh_->node_count(); ++node)
  {
    for (int c = 0; c < 2; ++c)
    {
      const std::size_t i = 2 * node + c;
      state.u[i] = (z[3 * node + c] - (1.0 - step.theta) * old.u[i]) / step.theta;
      state.change[i] = state.u[i] - old.u[i];
    }
    state.p[node] = z[3 * node + 2];
  }
  // The pressure before the first step is not known.
  const bool first = old.p_time == old.p_before_time;
  state.p_before = first ? state.p : old.p;
  state.p_before_time = old.p_time;
  state.time = step.t + step.step;
  state.p_time = step.t + step.theta * step.step;
  return state;
}

void Solver::restore(const Linearisation& linearisation)
{
  factors_.stale = linearisation.stale || linearisation.z.empty();
  if (!factors_.stale)
  {
    compute_body_force(linearisation.step, linearisation.x);
    Problem problem{*this, linearisation.step, linearisation.u_old, {linearisation.x, linearisation.w}};
    factors_.stale = !linalg::renew(system_, factors_, problem, linearisation.z, *timings_);
  }
  linearisation_ = linearisation;
  linearisation_.stale = factors_.stale;
}

}  // namespace blockfsi::fluid
