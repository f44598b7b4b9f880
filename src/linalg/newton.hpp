#pragma once

#include "core/timing.hpp"
#include "linalg/system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace blockfsi::linalg
{

enum class NewtonStatus
{
  converged,
  too_many_iterations,
  diverged,  ///< increments grew with fresh factors, or became nan
  singular
};

struct NewtonReport
{
  NewtonStatus status = NewtonStatus::converged;
  int iterations = 0;
  int renewals = 0;        ///< how often the factors were made anew
  double increment = 0.0;  ///< relative size of the last increment
};

struct NewtonLimits
{
  double tolerance = 1e-8;
  int iterations = 25;
  /// Factors are renewed when more iterations than this seem to be left. Renewing costs about as much as so
  /// many residuals and back substitutions.
  double patience = 5.0;
};

/// Whether the factors at hand may still be used; part of what a restart needs.
struct Factors
{
  bool stale = true;
};

/// Iterations until increments that shrink by `rate` each reach the tolerance.
inline double iterations_left(double increment, double rate, double tolerance)
{
  if (rate >= 1.0)
    return std::numeric_limits<double>::infinity();
  return rate > 0.0 ? std::log(std::min(1.0, tolerance / increment)) / std::log(rate) : 0.0;
}

/// Makes the factors anew at z; false if the matrix is singular.
template <class Problem>
[[nodiscard]] bool renew(System& system, Factors& factors, Problem& problem, std::span<const double> z,
                         Timings& timings)
{
  {
    const Stopwatch watch(timings, Task::assembly);
    problem.tangent(z, system.cell_matrices());
    system.assemble();
  }
  const Stopwatch watch(timings, Task::factorisation);
  problem.remember(z);
  factors.stale = system.factorise() != Status::ok;
  return !factors.stale;
}

/// The increment at z with the factors at hand; false if it is not finite.
template <class Problem>
[[nodiscard]] bool increment_at(System& system, Problem& problem, std::span<const double> z,
                                std::span<double> residual, std::span<double> increment, Timings& timings)
{
  {
    const Stopwatch watch(timings, Task::assembly);
    problem.residual(z, residual);
  }
  const Stopwatch watch(timings, Task::solve);
  return system.solve(residual, increment) == Status::ok;
}

/// Newton's method with factors that are kept, over iterations and over calls, as long as the increments
/// shrink fast enough. With fresh factors in every iteration it is Newton's method proper.
///
/// `problem` has: tangent(z, cell_matrices), remember(z) called when factors are renewed,
/// residual(z, r) which overwrites r, and size(increment, z), the relative size of an increment
/// (the same on all processes). On success z is the solution; the error left is about tolerance.
template <class Problem>
[[nodiscard]] NewtonReport newton(const NewtonLimits& limits, System& system, Factors& factors,
                                  Problem& problem, std::span<double> z, Timings& timings)
{
  NewtonReport report;
  std::vector<double> residual(z.size());
  std::vector<double> increment(z.size());
  double before = 0.0;
  int growing = 0;
  const auto end_with = [&report, &factors](NewtonStatus status)
  {
    report.status = status;
    if (status != NewtonStatus::converged)
      factors.stale = true;
    return report;
  };
  while (report.iterations < limits.iterations)
  {
    const bool fresh = factors.stale;
    if (fresh && !renew(system, factors, problem, z, timings))
      return end_with(NewtonStatus::singular);
    report.renewals += fresh ? 1 : 0;
    if (!increment_at(system, problem, z, residual, increment, timings))
      return end_with(NewtonStatus::diverged);
    ++report.iterations;
    report.increment = problem.size(increment, std::as_const(z));
    if (!std::isfinite(report.increment))
      return end_with(NewtonStatus::diverged);
    const double rate = before > 0.0 ? report.increment / before : 0.0;
    factors.stale =
        before > 0.0 && iterations_left(report.increment, rate, limits.tolerance) > limits.patience;
    if (!fresh && rate > 1.0)
      continue;  // the old factors led astray: do not take this increment
    for (std::size_t i = 0; i < z.size(); ++i)
      z[i] -= increment[i];
    // With a steady rate the error left is the sum of the increments to come.
    const bool little_left =
        before > 0.0 && rate < 0.5 && report.increment * rate / (1.0 - rate) <= limits.tolerance;
    if (report.increment <= limits.tolerance || little_left)
      return end_with(NewtonStatus::converged);
    growing = rate > 1.0 ? growing + 1 : 0;
    if (growing > 4)
      return end_with(NewtonStatus::diverged);
    before = report.increment;
  }
  return end_with(NewtonStatus::too_many_iterations);
}

}  // namespace blockfsi::linalg
