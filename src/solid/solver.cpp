#include "solid/solver.hpp"

#include "fem/boundary.hpp"
#include "fem/nodal.hpp"
#include "linalg/communicator.hpp"

#include <algorithm>
#include <cmath>

namespace blockfsi::solid
{

namespace
{

/// Dead load on a side.
struct DeadTraction
{
  static constexpr int unknowns = 2;
  static constexpr int data = 0;

  const Traction* traction;
  double time;
  double factor;

  template <class S>
  std::array<S, 2> operator()(const fem::SideInput<S, 2, 0>& in) const
  {
    return {S(-factor * traction->value[0](in.x[0], in.x[1], 0.0, time)),
            S(-factor * traction->value[1](in.x[0], in.x[1], 0.0, time))};
  }
};

}  // namespace

/// What Newton's method asks of the body during one solution.
struct Solver::Problem
{
  Solver& solver;
  Body body;
  std::span<const double> origin;
  std::span<const double> constant;  ///< part of the residual that does not change; null: none

  std::array<fem::NodalField, 2> data() const
  {
    return {{{origin.data(), 2}, {solver.body_force_.data(), 2}}};
  }

  void residual(std::span<const double> d, std::span<double> r) const
  {
    if (constant.empty())
      std::fill(r.begin(), r.end(), 0.0);
    else
      std::copy(constant.begin(), constant.end(), r.begin());
    const auto fields = data();
    solver.cells_.add_residual(body, solver.X_, d, fields, r);
  }

  void tangent(std::span<const double> d, std::span<double> matrices) const
  {
    const auto fields = data();
    solver.cells_.tangent(body, solver.X_, d, fields, matrices);
  }

  /// Factors do not outlive a solution, so there is nothing to remember.
  void remember(std::span<const double>) const {}

  double size(std::span<const double> increment, std::span<const double> d) const
  {
    std::array<double, 2> sums{};
    for (const std::int32_t node : solver.numbering_->owned())
      for (int c = 0; c < 2; ++c)
      {
        const std::size_t i = 2 * static_cast<std::size_t>(node) + c;
        sums[0] += increment[i] * increment[i];
        sums[1] += (d[i] - increment[i]) * (d[i] - increment[i]);
      }
    linalg::sum(sums);
    if (sums[1] > 0.0)
      return std::sqrt(sums[0] / sums[1]);
    return sums[0] > 0.0 ? 1.0 : 0.0;
  }
};

std::vector<Solver::Prescribed> Solver::find_prescribed(const Parameters& parameters, const mesh::Mesh& mesh,
                                                        const linalg::Numbering& numbering)
{
  // Where boundaries meet, a fixed one wins over a prescribed displacement.
  std::vector<int> winner(2 * mesh.node_count(), 0);
  std::vector<const Displacement*> values(winner.size(), nullptr);
  for (const BoundaryCondition& condition : parameters.boundaries)
  {
    const auto* displacement = std::get_if<Displacement>(&condition.condition);
    if (std::holds_alternative<Traction>(condition.condition))
      continue;
    const int rank = displacement != nullptr ? 1 : 2;
    const std::vector<std::uint8_t> marks = fem::nodes_on(mesh, numbering, condition.boundary);
    for (std::size_t i = 0; i < winner.size(); ++i)
      if (marks[i / 2] != 0 && rank > winner[i] && !(displacement != nullptr && displacement->is_free[i % 2]))
      {
        winner[i] = rank;
        values[i] = displacement;
      }
  }
  std::vector<Prescribed> result;
  for (std::size_t i = 0; i < winner.size(); ++i)
    if (winner[i] > 0)
      result.push_back({static_cast<std::int32_t>(i / 2), static_cast<int>(i % 2),
                        values[i] != nullptr ? values[i]->value[i % 2] : Expression()});
  return result;
}

std::vector<std::uint8_t> Solver::fixed() const
{
  std::vector<std::uint8_t> marks(2 * mesh_->node_count(), 0);
  for (const Prescribed& entry : prescribed_)
    marks[2 * entry.node + entry.component] = 1;
  return marks;
}

Solver::Solver(const Parameters& parameters, const mesh::Mesh& mesh, const linalg::Numbering& numbering,
               std::span<const double> X, Timings& timings)
    : parameters_(parameters), mesh_(&mesh), numbering_(&numbering), timings_(&timings),
      X_(X.begin(), X.end()), cells_(mesh, fem::quadrature_points(mesh.order)),
      sides_(mesh, fem::quadrature_points(mesh.order)),
      prescribed_(find_prescribed(parameters, mesh, numbering)),
      material_(lame(parameters.young, parameters.poisson, parameters.plane)),
      body_force_(2 * mesh.node_count(), 0.0),
      system_(numbering, 2, mesh.cells, mesh.nodes_per_cell(), fixed(), "solid_")
{
}

State Solver::initial() const
{
  State state;
  state.d.assign(2 * mesh_->node_count(), 0.0);
  state.v.resize(state.d.size());
  fem::evaluate_at_nodes(parameters_.initial_velocity, X_, 0.0, state.v);
  return state;
}

void Solver::apply_conditions(double time, double factor, std::span<double> d) const
{
  for (const Prescribed& entry : prescribed_)
  {
    const std::size_t i = 2 * static_cast<std::size_t>(entry.node);
    d[i + entry.component] = factor * entry.value(X_[i], X_[i + 1], 0.0, time);
  }
}

void Solver::add_tractions(double time, double factor, std::span<double> residual)
{
  for (const BoundaryCondition& condition : parameters_.boundaries)
  {
    const auto* traction = std::get_if<Traction>(&condition.condition);
    const auto found = mesh_->boundaries.find(condition.boundary);
    if (traction != nullptr && found != mesh_->boundaries.end())
      sides_.add_residual(DeadTraction{traction, time, factor}, found->second, X_, residual, {}, residual);
  }
}

linalg::NewtonReport Solver::solve(const Body& body, std::span<const double> origin,
                                   std::span<const double> constant, std::span<double> d)
{
  Problem problem{*this, body, origin, constant};
  const linalg::NewtonLimits limits{parameters_.newton.tolerance, parameters_.newton.iterations, 2.0};
  return linalg::newton(limits, system_, factors_, problem, d, *timings_);
}

linalg::NewtonReport Solver::advance(const fem::TimeStep& step, const State& old,
                                     std::span<const double> load, std::span<double> d)
{
  const double theta = step.theta;
  const double time = step.t + theta * step.step;
  fem::evaluate_at_nodes(parameters_.body_force, X_, time, body_force_);
  std::vector<double> origin(old.d.size());
  for (std::size_t i = 0; i < origin.size(); ++i)
    origin[i] = old.d[i] + step.step * old.v[i];

  std::vector<double> constant(d.size(), 0.0);
  {
    const Stopwatch watch(*timings_, Task::assembly);
    // Internal forces at the start of the step.
    const Body at_start{material_, 0.0, 0.0, 1.0 - theta};
    if (theta < 1.0)
      Problem{*this, at_start, origin, {}}.residual(old.d, constant);
    add_tractions(time, 1.0, constant);
    for (const std::int32_t node : numbering_->owned())
      for (int c = 0; c < 2; ++c)
        constant[2 * node + c] -= load[2 * node + c];
  }
  apply_conditions(step.t + step.step, 1.0, d);
  const Body body{material_, parameters_.density / (theta * step.step * step.step), parameters_.density,
                  theta};
  // A thin body is stiff against stretching and soft against bending: factors of another step, in which it
  // pointed elsewhere, lead far astray.
  factors_.stale = factors_.stale || step != factored_step_;
  factored_step_ = step;
  return solve(body, origin, constant, d);
}

linalg::NewtonReport Solver::solve_static(std::span<const double> load, std::span<double> d)
{
  fem::evaluate_at_nodes(parameters_.body_force, X_, 0.0, body_force_);
  const bool from_rest =
      !linalg::any(std::any_of(d.begin(), d.end(), [](double value) { return value != 0.0; }));
  const int steps = from_rest ? parameters_.load_steps : 1;
  const std::vector<double> origin(d.size(), 0.0);
  linalg::NewtonReport report;
  for (int s = 1; s <= steps; ++s)
  {
    const double factor = static_cast<double>(s) / steps;
    std::vector<double> constant(d.size(), 0.0);
    add_tractions(0.0, factor, constant);
    for (const std::int32_t node : numbering_->owned())
      for (int c = 0; c < 2; ++c)
        constant[2 * node + c] -= factor * load[2 * node + c];
    apply_conditions(0.0, factor, d);
    const Body body{material_, 0.0, factor * parameters_.density, 1.0};
    factors_.stale = true;
    const linalg::NewtonReport one = solve(body, origin, constant, d);
    report.status = one.status;
    report.iterations += one.iterations;
    report.renewals += one.renewals;
    report.increment = one.increment;
    if (one.status != linalg::NewtonStatus::converged)
      break;
  }
  return report;
}

State Solver::finish(const fem::TimeStep& step, const State& old, std::span<const double> d) const
{
  State state;
  state.d.assign(d.begin(), d.end());
  state.v.resize(d.size());
  for (std::size_t i = 0; i < d.size(); ++i)
    state.v[i] = (d[i] - old.d[i]) / (step.theta * step.step) - (1.0 - step.theta) / step.theta * old.v[i];
  state.time = step.t + step.step;
  return state;
}

}  // namespace blockfsi::solid
