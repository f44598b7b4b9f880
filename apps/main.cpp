#include "mesh_options.hpp"

#include "case/case.hpp"
#include "case/describe.hpp"
#include "core/error.hpp"
#include "linalg/communicator.hpp"
#include "linalg/session.hpp"
#include "run/compare.hpp"
#include "run/failure.hpp"
#include "run/layouts.hpp"
#include "run/reference.hpp"
#include "run/run.hpp"
#include "run/verify.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
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
  blockfsi::CaseArguments of;
  std::string directory;
  bool restart = false;
  blockfsi::MeshArguments mesh;
  std::string level = "full";
  bool finished = false;
  std::vector<std::string> motions;
  std::vector<double> times;
  bool prescribed = false;
};

blockfsi::case_file::Case read(const Arguments& arguments)
{
  return blockfsi::case_file::read(arguments.of.path, arguments.of.overrides);
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
             ? blockfsi::run::compare_prescribed(arguments.of.path, arguments.of.overrides, options)
             : blockfsi::run::compare_runs(arguments.of.path, arguments.of.overrides, options);
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
  if (blockfsi::linalg::part().size > 1)
    throw blockfsi::Error("blockfsi mesh works with one process; leave out mpirun");
  return blockfsi::make_case_mesh(arguments.of, arguments.mesh);
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
  const auto folders =
      blockfsi::run::reached_folders(description, blockfsi::run::result_folder(description, options));
  const auto comparisons = blockfsi::run::compare(reference, folders, arguments.level);
  fmt::print("{}", blockfsi::run::report(comparisons));
  return blockfsi::run::all_ok(comparisons) ? Exit::done : Exit::missed;
}

CLI::App* add_run(CLI::App& app, Arguments& arguments)
{
  CLI::App* command = app.add_subcommand("run", "run a case");
  blockfsi::add_case(*command, arguments.of);
  command->add_option("--directory", arguments.directory, "folder of the results");
  command->add_flag("--restart", arguments.restart, "continue from the newest checkpoint");
  return command;
}

CLI::App* add_compare(CLI::App& app, Arguments& arguments)
{
  CLI::App* command =
      app.add_subcommand("compare", "run a case with several ways of moving its mesh, side by side");
  blockfsi::add_case(*command, arguments.of);
  command
      ->add_option("--motion", arguments.motions,
                   "names with commas between: keys of [motion], NAMEs of [compare.NAME], fixed, incremental")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--directory", arguments.directory, "folder of the results");
  command->add_option("--times", arguments.times, "times at which to draw the meshes, with commas between")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag("--prescribed", arguments.prescribed,
                    "without a fluid: bend the flap of section [prescribed]");
  return command;
}

CLI::App* add_check(CLI::App& app, Arguments& arguments)
{
  CLI::App* command = app.add_subcommand("check", "find the mistakes of a case without solving");
  blockfsi::add_case(*command, arguments.of);
  return command;
}

CLI::App* add_mesh(CLI::App& app, Arguments& arguments)
{
  CLI::App* command = app.add_subcommand("mesh", "make the mesh of a case and report its quality");
  blockfsi::add_case(*command, arguments.of);
  blockfsi::add_mesh_options(*command, arguments.mesh);
  return command;
}

CLI::App* add_verify(CLI::App& app, Arguments& arguments)
{
  CLI::App* command =
      app.add_subcommand("verify", "run a case and compare it with the reference.csv beside it");
  blockfsi::add_case(*command, arguments.of);
  command->add_option("--directory", arguments.directory, "folder of the results");
  command->add_option("--level", arguments.level, "references of the full or the short form")
      ->check(CLI::IsMember({"full", "short"}));
  command->add_flag("--finished", arguments.finished, "take the results that are there instead of running");
  return command;
}

/// A command that reads a case.
struct Command
{
  CLI::App* parser;
  Exit (*execute)(const Arguments& arguments);
};

Exit execute(const Command& command, const Arguments& arguments)
{
  const blockfsi::linalg::Session session;
  try
  {
    return command.execute(arguments);
  }
  catch (const std::exception& error)
  {
    blockfsi::run::end_unless_all_failed(error);
    if (blockfsi::linalg::part().rank == 0)
      fmt::print(stderr, "{}\n", blockfsi::run::message_of(error));
    return blockfsi::run::exit_of(error);
  }
}

Exit dispatch(int count, char** values)
{
  CLI::App app("blockfsi: fluid-structure interaction with the mesh generator inside the solver");
  app.require_subcommand(1);
  Arguments arguments;
  const std::array commands{
      Command{add_run(app, arguments), run}, Command{add_compare(app, arguments), compare},
      Command{add_check(app, arguments), check}, Command{add_mesh(app, arguments), mesh},
      Command{add_verify(app, arguments), verify}};
  app.add_subcommand("describe", "explain every key of a case file");
  try
  {
    app.parse(count, values);
  }
  catch (const CLI::ParseError& error)
  {
    // CLI11 prints help or the mistake and tells which it was.
    return app.exit(error) == 0 ? Exit::done : Exit::user_error;
  }
  for (const Command& command : commands)
    if (*command.parser)
      return execute(command, arguments);
  fmt::print("{}", blockfsi::case_file::describe());
  return Exit::done;
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
