#include "linalg/system.hpp"

#include "linalg/communicator.hpp"
#include "linalg/petsc.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace blockfsi::linalg
{

struct System::Data
{
  const Numbering* numbering;
  int components;
  std::vector<std::uint8_t> fixed;
  std::vector<double> values;  ///< cell matrices, then the diagonal of owned fixed unknowns
  std::size_t cell_value_count;
  std::vector<double> summed;  ///< residual with the contributions of ghosts
  petsc::Matrix matrix;
  petsc::Vector right;
  petsc::Vector solution;
  petsc::Solver solver;
};

namespace
{

struct Coordinates
{
  std::vector<PetscInt> row;
  std::vector<PetscInt> column;
};

/// Row and column of every entry of every cell matrix. PETSc ignores negative ones: fixed unknowns.
Coordinates coordinates(const Numbering& numbering, int components, std::span<const std::int32_t> cell_nodes,
                        int nodes_per_cell, std::span<const std::uint8_t> fixed)
{
  const std::size_t n = static_cast<std::size_t>(nodes_per_cell) * components;
  const std::size_t cell_count = cell_nodes.size() / nodes_per_cell;
  Coordinates result;
  result.row.reserve(cell_count * n * n);
  result.column.reserve(cell_count * n * n);
  std::vector<PetscInt> unknowns(n);
  for (std::size_t cell = 0; cell < cell_count; ++cell)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t node = cell_nodes[cell * nodes_per_cell + i / components];
      const std::size_t component = i % components;
      const bool is_fixed = fixed[node * components + component] != 0;
      unknowns[i] = is_fixed ? -1 : static_cast<PetscInt>(numbering.global(node) * components + component);
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
      {
        result.row.push_back(unknowns[i]);
        result.column.push_back(unknowns[j]);
      }
  }
  for (const std::int32_t node : numbering.owned())
    for (int component = 0; component < components; ++component)
      if (fixed[node * components + component] != 0)
      {
        result.row.push_back(numbering.global(node) * components + component);
        result.column.push_back(result.row.back());
      }
  return result;
}

void choose_solver(KSP solver, const std::string& prefix)
{
  PC preconditioner = nullptr;
  petsc::check(KSPSetOptionsPrefix(solver, prefix.c_str()));
  petsc::check(KSPSetType(solver, KSPPREONLY));
  petsc::check(KSPGetPC(solver, &preconditioner));
  petsc::check(PCSetType(preconditioner, PCLU));
  petsc::check(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS));
  // PORD needs the least work on these matrices; the default workspace of 20 % is often too small.
  for (const auto& [name, value] :
       {std::pair{"mat_mumps_icntl_7", "4"}, std::pair{"mat_mumps_icntl_14", "60"}})
  {
    PetscBool set = PETSC_FALSE;
    petsc::check(PetscOptionsHasName(nullptr, prefix.c_str(), ("-" + std::string(name)).c_str(), &set));
    if (set == PETSC_FALSE)
      petsc::check(PetscOptionsSetValue(nullptr, ("-" + prefix + name).c_str(), value));
  }
  petsc::check(KSPSetFromOptions(solver));
}

}  // namespace

System::System(const Numbering& numbering, int components, std::span<const std::int32_t> cell_nodes,
               int nodes_per_cell, std::span<const std::uint8_t> fixed, const std::string& prefix)
    : data_(std::make_unique<Data>())
{
  data_->numbering = &numbering;
  data_->components = components;
  data_->fixed.assign(fixed.begin(), fixed.end());
  Coordinates entries = coordinates(numbering, components, cell_nodes, nodes_per_cell, fixed);
  const std::size_t n = static_cast<std::size_t>(nodes_per_cell) * components;
  data_->cell_value_count = cell_nodes.size() / nodes_per_cell * n * n;
  data_->values.assign(entries.row.size(), 0.0);
  std::fill(data_->values.begin() + static_cast<std::ptrdiff_t>(data_->cell_value_count), data_->values.end(),
            1.0);

  const auto own = static_cast<PetscInt>(numbering.owned_count() * components);
  petsc::check(MatCreate(PETSC_COMM_WORLD, data_->matrix.address()));
  petsc::check(MatSetSizes(data_->matrix, own, own, PETSC_DETERMINE, PETSC_DETERMINE));
  petsc::check(MatSetType(data_->matrix, MATAIJ));
  petsc::check(MatSetPreallocationCOO(data_->matrix, static_cast<PetscCount>(entries.row.size()),
                                      entries.row.data(), entries.column.data()));
  petsc::check(MatCreateVecs(data_->matrix, data_->solution.address(), data_->right.address()));
  petsc::check(KSPCreate(PETSC_COMM_WORLD, data_->solver.address()));
  petsc::check(KSPSetOperators(data_->solver, data_->matrix, data_->matrix));
  choose_solver(data_->solver, prefix);
}

System::System(System&&) noexcept = default;
System& System::operator=(System&&) noexcept = default;
System::~System() = default;

std::span<double> System::cell_matrices()
{
  return std::span(data_->values).first(data_->cell_value_count);
}

void System::assemble()
{
  petsc::check(MatSetValuesCOO(data_->matrix, data_->values.data(), INSERT_VALUES));
}

Status System::factorise()
{
  // Without this PETSc would put the factorisation off until the next solution.
  petsc::check(KSPSetOperators(data_->solver, data_->matrix, data_->matrix));
  petsc::check(KSPSetUp(data_->solver));
  PC preconditioner = nullptr;
  PCFailedReason reason = PC_NOERROR;
  petsc::check(KSPGetPC(data_->solver, &preconditioner));
  petsc::check(PCGetFailedReason(preconditioner, &reason));
  if (!any(reason != PC_NOERROR))
    return Status::ok;
  // After a failure PETSc skips all further factorisations by MUMPS: let it start from the beginning.
  petsc::check(KSPReset(data_->solver));
  return Status::singular;
}

Status System::solve(std::span<const double> residual, std::span<double> increment)
{
  const int components = data_->components;
  data_->summed.assign(residual.begin(), residual.end());
  data_->numbering->add_from_ghosts(data_->summed, components);

  double* array = nullptr;
  petsc::check(VecGetArrayWrite(data_->right, &array));
  std::size_t k = 0;
  for (const std::int32_t node : data_->numbering->owned())
    for (int c = 0; c < components; ++c)
    {
      const std::size_t unknown = static_cast<std::size_t>(node) * components + c;
      array[k++] = data_->fixed[unknown] != 0 ? 0.0 : data_->summed[unknown];
    }
  petsc::check(VecRestoreArrayWrite(data_->right, &array));

  petsc::check(KSPSolve(data_->solver, data_->right, data_->solution));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  petsc::check(KSPGetConvergedReason(data_->solver, &reason));

  const double* result = nullptr;
  petsc::check(VecGetArrayRead(data_->solution, &result));
  k = 0;
  bool finite = true;
  for (const std::int32_t node : data_->numbering->owned())
    for (int c = 0; c < components; ++c)
    {
      finite = finite && std::isfinite(result[k]);
      increment[static_cast<std::size_t>(node) * components + c] = result[k++];
    }
  petsc::check(VecRestoreArrayRead(data_->solution, &result));
  data_->numbering->update_ghosts(increment, components);
  if (any(!finite))
    return Status::not_finite;
  // Only an iterative solver chosen by options can end without converging.
  return reason < 0 ? Status::not_converged : Status::ok;
}

}  // namespace blockfsi::linalg
