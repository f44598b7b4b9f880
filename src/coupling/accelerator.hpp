#pragma once

#include "coupling/parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::coupling
{

/// All that an accelerator remembers, as plain arrays: a copy of it undoes a step, written to a checkpoint it
/// makes a restarted run continue bit for bit.
struct History
{
  /// Differences of successive residuals and of successive answers, oldest first, shape (column count, size).
  std::vector<double> V, W;
  /// Columns of each accepted step that has any, oldest first; the last entry belongs to the step under way.
  std::vector<std::int32_t> columns_per_step = {0};
  /// d~ - d and d~ of the last iteration of the step under way, shape (size); empty before its first.
  std::vector<double> last_residual, last_answer;
  double omega = 0.0;  ///< Aitken's last relaxation [-]; 0 before the first step

  bool operator==(const History&) const = default;
};

/// Solves d = H(d) with few evaluations of H, the fluid followed by the solid. In each iteration the solvers
/// answer d~ = H(d) with the residual r = d~ - d, and the next input is
///   constant:  d + omega r
///   Aitken:    d + omega_k r_k,  omega_k = -omega_{k-1} r_{k-1}.(r_k - r_{k-1}) / |r_k - r_{k-1}|^2
///              (Kuettler & Wall 2008, eq. 44); a step starts with min(|last omega|, initial)
///   IQN-ILS:   d~ + W c,  c = argmin |V c + r|  (Degroote, Bathe & Vierendeels 2009), columns newest first,
///              those that hardly differ from newer ones left out (filter QR2, Haelterman et al. 2016)
///   IQN-IMVJ:  d~ - J r,  J = J_- + (W - J_- V) V^+, with V, W of the step under way and J_- the J of the
///              step before, 0 before the first step kept (Bogaers, Kok, Reddy & Franz 2014)
/// Where a formula breaks down (no column, equal residuals, a step that would leave d where it is), the
/// answer is d + initial r. Vectors are those of the whole interface; every process that calls with the same
/// numbers gets the same numbers.
class Acceleration
{
public:
  /// `size` is the number of unknowns of the interface. Throws Error if a parameter is out of range.
  Acceleration(const Parameters& parameters, std::size_t size);

  /// To be called before the first iteration of a step. Forgets a step that was not accepted.
  void start_step();

  /// Replaces the input d by the next one, given the answer d_tilde to it. Both of shape (size).
  void next(std::span<double> d, std::span<const double> d_tilde);

  /// Takes note of an answer that needs no next input, so that the last iteration of a step teaches as well.
  void observe(std::span<const double> d, std::span<const double> d_tilde);

  /// Keeps what the step taught for the `reuse` steps to come.
  void accept_step();

  /// What is remembered now, in the middle of a step as well.
  const History& history() const { return history_; }

  /// Continues from a history of the same interface. Throws Error if its size is another one.
  void restore(History history);

private:
  void add_column(std::span<const double> residual, std::span<const double> answer);

  Accelerator method_;
  std::size_t size_;
  History history_;
};

}  // namespace blockfsi::coupling
