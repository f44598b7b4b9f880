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
};

void add_case(CLI::App& command, CaseArguments& arguments);
void add_mesh_options(CLI::App& command, MeshArguments& arguments);

/// Reads the case and makes its mesh.
command::Exit make_case_mesh(const CaseArguments& of, const MeshArguments& arguments);

}  // namespace blockfsi
