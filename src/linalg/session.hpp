#pragma once

#include <string>

namespace blockfsi::linalg
{

/// PETSc and MPI from construction to destruction: one per program, made in main.
class Session
{
public:
  /// `options` are PETSc's, separated by blanks, such as "-fluid_ksp_type gmres".
  explicit Session(const std::string& options = {});
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();
};

/// Adds options of PETSc; later ones win. To be called before the solvers are made.
void add_options(const std::string& options);

}  // namespace blockfsi::linalg
