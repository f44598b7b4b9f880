#include "mesh_options.hpp"

#include "core/error.hpp"
#include "element/nodes.hpp"

#include <CLI/CLI.hpp>

namespace blockfsi
{

void add_case(CLI::App& command, CaseArguments& arguments)
{
  command.add_option("case", arguments.path, "case file (TOML)")->required();
  command.add_option("--set", arguments.overrides, "replace a value of the case: section.key=value (TOML)")
      ->allow_extra_args(false);
}

void add_mesh_options(CLI::App& command, MeshArguments& arguments)
{
  CLI::Option* const of = command.get_option("case")->required(false);
  command
      .add_option(
          "--list", arguments.list,
          "instead of a mesh: the edges and faces of a CAD file (.step, .stp, .iges, .igs), by number")
      ->excludes(of);
  command.add_option("-o,--output", arguments.options.output,
                     "file to write: .vtu (VTK, ParaView) or .msh (Gmsh)");
  std::vector<std::string> names;
  for (const auto& [name, target] : command::conversions())
    names.push_back(name);
  command
      .add_option("--convert", arguments.conversions,
                  "cut all cells into triangles (2 of a quadrilateral; triangles4: 4), quadrilaterals, "
                  "tetrahedra or hexahedra; several with commas between: one after the other")
      ->check(CLI::IsMember(names))
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--order", arguments.options.order, "order of the cells instead of the case's")
      ->check(CLI::Range(1, element::largest_order));
  command.add_option("--picture", arguments.options.picture,
                     "draw the blocks: .svg in the plane; in space .vtu, their edges");
  command.add_flag("--sizes", arguments.options.sizes, "list the cells along every edge of the blocks");
}

command::Exit make_case_mesh(const CaseArguments& of, const MeshArguments& arguments)
{
  if (!arguments.list.empty())
    return command::list_cad(arguments.list);
  if (of.path.empty())
    throw Error("a case is needed, or --list and a CAD file; --help lists all options");
  command::MeshOptions options = arguments.options;
  for (const std::string& name : arguments.conversions)
    for (const auto& [known, target] : command::conversions())
      if (name == known)
        options.steps.push_back(target);
  return command::make_mesh(of.path, of.overrides, options);
}

}  // namespace blockfsi
