#pragma once

// The command `mesh` as both programs offer it.

#include "command/exit.hpp"
#include "command/mesh.hpp"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace blockfsi
{

struct CaseArguments
{
  std::string path;
  std::vector<std::string> overrides;
};

struct MeshArguments
{
  command::MeshOptions options;
  std::vector<std::string> conversions;  ///< names of command::conversions
  std::string list;                      ///< CAD file whose edges and faces are listed; empty: make a mesh
};

void add_case(CLI::App& command, CaseArguments& arguments);
/// `command` has the case already, which it need not be given then.
void add_mesh_options(CLI::App& command, MeshArguments& arguments);

/// Reads the case and makes its mesh, or lists a CAD file. Throws Error if there is neither.
command::Exit make_case_mesh(const CaseArguments& of, const MeshArguments& arguments);

}  // namespace blockfsi
