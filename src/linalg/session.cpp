#include "linalg/session.hpp"

#include "linalg/petsc.hpp"

#include <cstdlib>

extern "C" void openblas_set_num_threads(int count) __attribute__((weak));

namespace blockfsi::linalg
{

Session::Session(const std::string& options)
{
  // One thread per process: with its default OpenBLAS makes the many small products 50 times slower.
  if (openblas_set_num_threads != nullptr)
    openblas_set_num_threads(1);
  // Open MPI would start a helper process beside a program that runs without mpirun.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  petsc::check(PetscInitializeNoArguments());
  // Errors come back as codes; signals are the program's own business.
  petsc::check(PetscPopSignalHandler());
  add_options(options);
}

Session::~Session()
{
  PetscFinalize();
}

void add_options(const std::string& options)
{
  petsc::check(PetscOptionsInsertString(nullptr, options.c_str()));
}

}  // namespace blockfsi::linalg
