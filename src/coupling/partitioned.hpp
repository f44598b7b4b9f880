#pragma once

#include "coupling/accelerator.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace blockfsi::coupling
{

/// When the iterations of a step end.
struct Limits
{
  double tolerance = 1e-5;          ///< |d~ - d| relative to the displacement of the step [-]
  int iterations = 50;              ///< evaluations at most
  double least_displacement = 0.0;  ///< root mean square that a step counts at least [m], for steps at rest
};

enum class Status
{
  converged,
  too_many_iterations,
  solver_failed,  ///< a solver said so
  diverged        ///< a displacement that is no number
};

/// How the iterations of a step went.
struct Report
{
  int iterations = 0;  ///< evaluations of both solvers
  std::vector<double>
      residuals;  ///< |d~ - d| relative to the displacement of the step [-], one per iteration
  Status status = Status::too_many_iterations;
};

/// |d~ - d| relative to the displacement of the step |d~ - d_start|, all norms root mean squares, with floors
/// of `least_displacement` and of 1e-6 |d~|, where rounding and the solvers' own tolerances would be
/// measured. 0 if d~ equals d, whatever the displacement.
double relative_residual(std::span<const double> d, std::span<const double> d_tilde,
                         std::span<const double> d_start, double least_displacement);

/// Iterates d = H(d) for one time step, H being the fluid followed by the solid, until
/// relative_residual <= tolerance. `evaluate(d, d_tilde)` gets the input as span<const double>, writes the
/// solid's answer into d_tilde, span<double>, and returns false if a solver failed; it must not change the
/// accepted state. `accelerator` is an Acceleration or has its start_step, next, observe and accept_step.
///   d [m], shape (size): the first guess, then the input of the last evaluation, to which the states of the
///   solvers belong;  d_start [m], shape (size): the interface at the start of the step.
/// Unless it converges, the accelerator forgets the step at the next one.
template <typename Evaluate, typename Accelerating>
[[nodiscard]] Report solve_partitioned(Evaluate&& evaluate, Accelerating& accelerator, const Limits& limits,
                                       std::span<double> d, std::span<const double> d_start)
{
  Report report;
  std::vector<double> d_tilde(d.size());
  accelerator.start_step();
  while (report.iterations < limits.iterations)
  {
    if (report.iterations > 0)
      accelerator.next(d, d_tilde);
    ++report.iterations;
    if (!evaluate(std::span<const double>(d), std::span<double>(d_tilde)))
    {
      report.status = Status::solver_failed;
      return report;
    }
    const double residual = relative_residual(d, d_tilde, d_start, limits.least_displacement);
    report.residuals.push_back(residual);
    if (residual <= limits.tolerance)
    {
      accelerator.observe(d, d_tilde);
      accelerator.accept_step();
      report.status = Status::converged;
      return report;
    }
    if (std::isnan(residual))
    {
      report.status = Status::diverged;
      return report;
    }
  }
  return report;
}

}  // namespace blockfsi::coupling
