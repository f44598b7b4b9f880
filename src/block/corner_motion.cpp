#include "block/corner_motion.hpp"

#include "block/corner_rules.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace blockfsi::block
{

namespace
{

constexpr int max_halvings = 3;

Eigen::MatrixXd constant_rule(const CornerGraph& graph, CornerRule rule)
{
  if (rule == CornerRule::automatic)
    rule = graph.dim == 2 ? CornerRule::elastic : CornerRule::radial;
  if (rule == CornerRule::elastic)
    return elastic_rule(graph);
  if (rule == CornerRule::radial)
    return radial_rule(graph);
  return Eigen::MatrixXd::Zero(unknown_numbers(graph).back(),
                               static_cast<Eigen::Index>(graph.corners.size()) * graph.dim);
}

std::variant<CornerEnergy<2>, CornerEnergy<3>> make_energy(const CornerGraph& graph,
                                                           const EnergyParameters& parameters)
{
  if (graph.dim == 2)
    return CornerEnergy<2>(graph, parameters);
  return CornerEnergy<3>(graph, parameters);
}

}  // namespace

NonlinearParameters nonlinear_defaults(int dim)
{
  NonlinearParameters parameters;
  if (dim == 3)
  {
    parameters.energy.distortion.power = 4;
    parameters.energy.tether = 1.0;
  }
  return parameters;
}

CornerMotion::CornerMotion(CornerGraph graph, CornerRule rule)
    : graph_(std::move(graph)), matrix_(constant_rule(graph_, rule)), y_(matrix_.rows())
{
  assert(rule != CornerRule::nonlinear);
}

CornerMotion::CornerMotion(CornerGraph graph, const NonlinearParameters& parameters)
    : CornerMotion(std::move(graph), parameters.start)
{
  nonlinear_.emplace(Nonlinear{make_energy(graph_, parameters.energy), parameters,
                               std::vector<double>(graph_.interface_count * graph_.dim, 0.0),
                               Eigen::VectorXd::Zero(matrix_.rows())});
}

/// Unknowns of the constant rule; U is memory of the right size.
Eigen::VectorXd CornerMotion::constant(std::span<const double> d, std::span<double> U) const
{
  displace_corners(graph_, d.data(), Eigen::VectorXd::Zero(matrix_.rows()).eval().data(), U.data());
  return matrix_ * Eigen::Map<const Eigen::VectorXd>(U.data(), static_cast<Eigen::Index>(U.size()));
}

CornerReport CornerMotion::follow(std::span<const double> d, std::span<double> U)
{
  assert(d.size() == graph_.interface_count * graph_.dim && U.size() == graph_.corners.size() * graph_.dim);
  CornerReport report;
  report.converged = true;
  if (nonlinear_)
  {
    if (!std::equal(d.begin(), d.end(), nonlinear_->d.begin()))
      report = search(d, U, 0);
    displace_corners(graph_, d.data(), nonlinear_->y.data(), U.data());
    return report;
  }
  y_.setZero();
  displace_corners(graph_, d.data(), y_.data(), U.data());
  y_.noalias() = matrix_ * Eigen::Map<const Eigen::VectorXd>(U.data(), static_cast<Eigen::Index>(U.size()));
  displace_corners(graph_, d.data(), y_.data(), U.data());
  return report;
}

CornerReport CornerMotion::search(std::span<const double> d, std::span<double> U, int depth)
{
  Nonlinear& state = *nonlinear_;
  const std::vector<double> last_d = state.d;
  const Eigen::VectorXd last_y = state.y;
  const Eigen::VectorXd constant_y = constant(d, U);
  const Eigen::VectorXd change = constant_y - constant(last_d, U);
  CornerReport report = std::visit(
      [&](auto& energy)
      {
        energy.bend(d);
        displace_corners(graph_, d.data(), constant_y.data(), U.data());
        energy.tether(U);
        double best_energy = std::numeric_limits<double>::infinity();
        double best_least = -std::numeric_limits<double>::infinity();
        for (const Eigen::VectorXd& start : {last_y, Eigen::VectorXd(last_y + change), constant_y})
        {
          double least = 0.0;
          displace_corners(graph_, d.data(), start.data(), U.data());
          const double value = energy.value(U, 0.0, least);
          if (value < best_energy ||
              (best_energy == std::numeric_limits<double>::infinity() && least > best_least))
          {
            best_energy = value;
            best_least = least;
            state.y = start;
          }
        }
        return minimise(energy, d, state.y, state.parameters.tolerance * graph_.size,
                        state.parameters.max_iterations);
      },
      state.energy);
  if (!report.converged && depth < max_halvings)
  {
    std::vector<double> middle(d.size());
    for (std::size_t i = 0; i < d.size(); ++i)
      middle[i] = 0.5 * (last_d[i] + d[i]);
    state.y = last_y;
    const CornerReport first = search(middle, U, depth + 1);
    const CornerReport second = search(d, U, depth + 1);
    report = {second.converged, report.iterations + first.iterations + second.iterations,
              1 + first.halvings + second.halvings, second.least, second.energy};
  }
  state.d.assign(d.begin(), d.end());
  return report;
}

std::vector<double> CornerMotion::memory() const
{
  if (!nonlinear_)
    return {};
  std::vector<double> memory = nonlinear_->d;
  memory.insert(memory.end(), nonlinear_->y.begin(), nonlinear_->y.end());
  return memory;
}

void CornerMotion::recall(std::span<const double> memory)
{
  const std::size_t wanted = this->memory().size();
  if (memory.size() != wanted)
    throw Error(fmt::format("what was remembered of moving corners has {} entries where {} are needed",
                            memory.size(), wanted));
  if (!nonlinear_)
    return;
  const auto unknowns = memory.begin() + static_cast<std::ptrdiff_t>(nonlinear_->d.size());
  std::copy(memory.begin(), unknowns, nonlinear_->d.begin());
  std::copy(unknowns, memory.end(), nonlinear_->y.begin());
}

}  // namespace blockfsi::block
