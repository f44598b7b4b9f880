#pragma once

#include "core/timing.hpp"
#include "linalg/system.hpp"

#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace blockfsi::linalg
{

enum class NewtonStatus
{
  converged,
  too_many_iterations,
  diverged,   ///< increments grew with fresh factors, or became nan
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
  /// Increments must shrink by this factor per iteration, or the factors are renewed. At 0.3 an iteration with old
  /// factors (a residual and a back substitution) still wins half a digit for a fraction of the price of renewing.
  double slowest_rate = 0.3;
};

/// Whether the factors at hand may still be used; part of what a restart needs.
struct Factors
{
  bool stale = true;
};

/// Newton's method with factors that are kept, over iterations and over calls, as long as the increments shrink
/// fast enough. With fresh factors in every iteration it is Newton's method proper.
///
/// `problem` has: tangent(z, cell_matrices), remember(z) called when factors are renewed,
/// residual(z, r) which overwrites r, and size(increment, z), the relative size of an increment
/// (the same on all processes). On success z is the solution; the error left is about tolerance.
template <class Problem>
[[nodiscard]] NewtonReport newton(const NewtonLimits& limits, System& system, Factors& factors, Problem& problem,
                                  std::span<double> z, Timings& timings)
{
  NewtonReport report;
  std::vector<double> residual(z.size());
  std::vector<double> increment(z.size());
  double before = 0.0;
  int growing = 0;
  const auto end_with = [&report](NewtonStatus status)
  {
    report.status = status;
    return report;
  };
  while (report.iterations < limits.iterations)
  {
    bool fresh = false;
    if (factors.stale)
    {
      {
        const Stopwatch watch(timings, Task::assembly);
        problem.tangent(std::as_const(z), system.cell_matrices());
        system.assemble();
      }
      const Stopwatch watch(timings, Task::factorisation);
      problem.remember(std::as_const(z));
      ++report.renewals;
      if (system.factorise() != Status::ok)
        return end_with(NewtonStatus::singular);
      factors.stale = false;
      fresh = true;
    }
    {
      const Stopwatch watch(timings, Task::assembly);
      problem.residual(std::as_const(z), residual);
    }
    {
      const Stopwatch watch(timings, Task::solve);
      if (system.solve(residual, increment) != Status::ok)
      {
        factors.stale = true;
        return end_with(NewtonStatus::diverged);
      }
    }
    ++report.iterations;
    report.increment = problem.size(increment, std::as_const(z));
    const double rate = before > 0.0 ? report.increment / before : 0.0;
    if (!std::isfinite(report.increment))
    {
      factors.stale = true;
      return end_with(NewtonStatus::diverged);
    }
    if (!fresh && rate > 1.0)
    {
      // The old factors led astray: do not take this increment.
      factors.stale = true;
      continue;
    }
    for (std::size_t i = 0; i < z.size(); ++i)
      z[i] -= increment[i];
    const bool small = report.increment <= limits.tolerance;
    const bool error_small = before > 0.0 && rate < 0.5 && report.increment * rate / (1.0 - rate) <= limits.tolerance;
    if (rate > limits.slowest_rate)
      factors.stale = true;
    if (small || error_small)
      return end_with(NewtonStatus::converged);
    growing = rate > 1.0 ? growing + 1 : 0;
    if (growing > 4)
      return end_with(NewtonStatus::diverged);
    before = report.increment;
  }
  factors.stale = true;
  return end_with(NewtonStatus::too_many_iterations);
}

}  // namespace blockfsi::linalg
