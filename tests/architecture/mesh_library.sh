#!/bin/sh
# mesh_library.sh BUILD PROGRAM ARCHIVE...: the program runs, and neither it, nor the archives, nor the commands that
# compiled them know of PETSc or MPI.
set -eu
build=$1
program=$2
shift 2
"$program"
if nm --undefined-only "$@" 2>/dev/null | grep -E 'Petsc|MPI_'; then
  echo "the mesh library calls PETSc or MPI"
  exit 1
fi
if ldd "$program" | grep -E 'petsc|mpi'; then
  echo "the mesh library is linked to PETSc or MPI"
  exit 1
fi
if grep -E '"command".*-c [^ ]*/src/(core|element|geometry|mesh|block|output)/' "$build/compile_commands.json" |
  grep -iE -e '-(I|isystem) ?[^ ]*(petsc|mpi)'; then
  echo "the mesh library is compiled with PETSc or MPI in sight"
  exit 1
fi
echo "the mesh library stands without PETSc and MPI"
