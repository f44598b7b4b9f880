#pragma once

#include "linalg/numbering.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace blockfsi::linalg
{

enum class Status
{
  ok,
  singular,      ///< the factorisation failed
  not_finite,    ///< the solution has nan or inf
  not_converged  ///< an iterative solver, chosen by PETSc's options, did not reach its tolerance
};

/// A distributed sparse system made of cell matrices, solved with factors that are kept until renewed.
///
/// Local degree of freedom = local node * components + component. Fixed ones are not solved for: their
/// increment is zero.
class System
{
public:
  /// `cell_nodes`: local nodes of the cells, shape (cell_count, nodes_per_cell);
  /// `fixed`: nonzero for each fixed local degree of freedom, shape (node_count * components);
  /// `prefix`: of PETSc's options for this system, such as "fluid_".
  /// Default solver: MUMPS, ordering PORD.
  System(const Numbering& numbering, int components, std::span<const std::int32_t> cell_nodes,
         int nodes_per_cell, std::span<const std::uint8_t> fixed, const std::string& prefix);
  System(System&&) noexcept;
  System& operator=(System&&) noexcept;
  ~System();

  /// The cell matrices, shape (cell_count, n, n) with n = nodes_per_cell * components, to be written by the
  /// caller.
  std::span<double> cell_matrices();

  /// Adds up the cell matrices: the first half of renewing the factors.
  void assemble();
  /// Factorises the assembled matrix.
  [[nodiscard]] Status factorise();
  /// Solves with the factors at hand.
  ///   residual: local contributions, shape (node_count * components); ghosts are added to their owners;
  ///   increment: the solution at all local nodes, ghosts included, same shape, written.
  [[nodiscard]] Status solve(std::span<const double> residual, std::span<double> increment);

private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace blockfsi::linalg
