#include "case/case.hpp"
#include "case/describe.hpp"
#include "element/nodes.hpp"
#include "linalg/communicator.hpp"
#include "linalg/session.hpp"
#include "run/compare.hpp"
#include "run/failure.hpp"
#include "run/mesh.hpp"
#include "run/reference.hpp"
#include "run/run.hpp"
#include "run/verify.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace
{

using blockfsi::run::Exit;

struct Arguments
{
  std::string case_path;
  std::vector<std::string> overrides;
  std::string directory;
  bool restart = false;
  blockfsi::run::MeshOptions mesh;
  std::vector<std::string> conversions;
  std::string level = "full";
  bool finished = false;
  std::vector<std::string> motions;
  std::vector<double> times;
  bool prescribed = false;
};

blockfsi::case_file::Case read(const Arguments& arguments)
{
  return blockfsi::case_file::read(arguments.case_path, arguments.overrides);
}

Exit run(const Arguments& arguments)
{
  const blockfsi::case_file::Case description = read(arguments);
  blockfsi::linalg::add_options(description.petsc_options);
  return blockfsi::run::run(description, {arguments.restart, arguments.directory});
}

Exit compare(const Arguments& arguments)
{
  const blockfsi::run::CompareOptions options{arguments.motions, arguments.directory, arguments.times};
  blockfsi::linalg::add_options(read(arguments).petsc_options);
  return arguments.prescribed
             ? blockfsi::run::compare_prescribed(arguments.case_path, arguments.overrides, options)
             : blockfsi::run::compare_runs(arguments.case_path, arguments.overrides, options);
}

Exit check(const Arguments& arguments)
{
  const blockfsi::case_file::Case description = read(arguments);
  if (blockfsi::linalg::part().rank == 0)
    fmt::print("{}: no mistakes found\n", description.path.string());
  return Exit::done;
}

Exit mesh(const Arguments& arguments)
{
  blockfsi::run::MeshOptions options = arguments.mesh;
  for (const std::string& name : arguments.conversions)
    for (const auto& [known, target] : blockfsi::run::conversions())
      if (name == known)
        options.steps.push_back(target);
  return blockfsi::run::make_mesh(read(arguments), options);
}

/// Runs the case unless its finished output is to be taken, and compares it with the references beside it.
Exit verify(const Arguments& arguments)
{
  const blockfsi::case_file::Case description = read(arguments);
  const blockfsi::run::RunOptions options{false, arguments.directory};
  const std::filesystem::path reference = description.path.parent_path() / "reference.csv";
  // Mistakes in the references are better found before a long run than after it.
  blockfsi::run::read_references(reference);
  if (!arguments.finished)
  {
    blockfsi::linalg::add_options(description.petsc_options);
    const Exit ran = blockfsi::run::run(description, options);
    if (ran != Exit::done)
      return ran;
  }
  if (blockfsi::linalg::part().rank != 0)
    return Exit::done;
  const auto comparisons =
      blockfsi::run::compare(reference, blockfsi::run::result_folder(description, options), arguments.level);
  fmt::print("{}", blockfsi::run::report(comparisons));
  return blockfsi::run::all_ok(comparisons) ? Exit::done : Exit::missed;
}

void add_case(CLI::App& command, Arguments& arguments)
{
  command.add_option("case", arguments.case_path, "case file (TOML)")->required();
  command.add_option("--set", arguments.overrides, "replace a value of the case: section.key=value (TOML)")
      ->allow_extra_args(false);
}

void add_mesh_options(CLI::App& command, Arguments& arguments)
{
  add_case(command, arguments);
  command.add_option("-o,--output", arguments.mesh.output,
                     "file to write: .vtu (VTK, ParaView) or .msh (Gmsh)");
  std::vector<std::string> names;
  for (const auto& [name, target] : blockfsi::run::conversions())
    names.push_back(name);
  command
      .add_option("--convert", arguments.conversions,
                  "cut all cells into triangles (2 of a quadrilateral; triangles4: 4), quadrilaterals, "
                  "tetrahedra or hexahedra; several with commas between: one after the other")
      ->check(CLI::IsMember(names))
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--order", arguments.mesh.order, "order of the cells instead of the case's")
      ->check(CLI::Range(1, blockfsi::element::largest_order));
  command.add_option("--picture", arguments.mesh.picture,
                     "draw the blocks: .svg in the plane; in space .vtu, their edges");
  command.add_flag("--sizes", arguments.mesh.sizes, "list the cells along every edge of the blocks");
}

Exit dispatch(int count, char** values)
{
  CLI::App app("blockfsi: fluid-structure interaction with the mesh generator inside the solver");
  app.require_subcommand(1);
  Arguments arguments;

  CLI::App* run_command = app.add_subcommand("run", "run a case");
  add_case(*run_command, arguments);
  run_command->add_option("--directory", arguments.directory, "folder of the results");
  run_command->add_flag("--restart", arguments.restart, "continue from the newest checkpoint");

  CLI::App* compare_command =
      app.add_subcommand("compare", "run a case with several ways of moving its mesh, side by side");
  add_case(*compare_command, arguments);
  compare_command
      ->add_option("--motion", arguments.motions,
                   "names with commas between: keys of [motion], NAMEs of [compare.NAME], fixed, incremental")
      ->delimiter(',')
      ->allow_extra_args(false);
  compare_command->add_option("--directory", arguments.directory, "folder of the results");
  compare_command
      ->add_option("--times", arguments.times, "times at which to draw the meshes, with commas between")
      ->delimiter(',')
      ->allow_extra_args(false);
  compare_command->add_flag("--prescribed", arguments.prescribed,
                            "without a fluid: bend the flap of section [prescribed]");

  CLI::App* check_command = app.add_subcommand("check", "find the mistakes of a case without solving");
  add_case(*check_command, arguments);

  CLI::App* mesh_command = app.add_subcommand("mesh", "make the mesh of a case and report its quality");
  add_mesh_options(*mesh_command, arguments);

  CLI::App* verify_command =
      app.add_subcommand("verify", "run a case and compare it with the reference.csv beside it");
  add_case(*verify_command, arguments);
  verify_command->add_option("--directory", arguments.directory, "folder of the results");
  verify_command->add_option("--level", arguments.level, "references of the full or the short form")
      ->check(CLI::IsMember({"full", "short"}));
  verify_command->add_flag("--finished", arguments.finished,
                           "take the results that are there instead of running");

  CLI::App* describe_command = app.add_subcommand("describe", "explain every key of a case file");

  try
  {
    app.parse(count, values);
  }
  catch (const CLI::ParseError& error)
  {
    // CLI11 prints help or the mistake and tells which it was.
    return app.exit(error) == 0 ? Exit::done : Exit::user_error;
  }
  if (*describe_command)
  {
    fmt::print("{}", blockfsi::case_file::describe());
    return Exit::done;
  }
  const blockfsi::linalg::Session session;
  try
  {
    if (*run_command)
      return run(arguments);
    if (*verify_command)
      return verify(arguments);
    if (*compare_command)
      return compare(arguments);
    return *check_command ? check(arguments) : mesh(arguments);
  }
  catch (const std::exception& error)
  {
    blockfsi::run::end_unless_all_failed(error);
    if (blockfsi::linalg::part().rank == 0)
      fmt::print(stderr, "{}\n", blockfsi::run::message_of(error));
    return blockfsi::run::exit_of(error);
  }
}

}  // namespace

int main(int count, char** values)
{
  try
  {
    return static_cast<int>(dispatch(count, values));
  }
  catch (const std::exception& error)
  {
    fmt::print(stderr, "{}\n", blockfsi::run::message_of(error));
    return static_cast<int>(blockfsi::run::exit_of(error));
  }
}
