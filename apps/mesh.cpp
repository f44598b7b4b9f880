// blockfsi-mesh: the command `blockfsi mesh` as a program without solvers, PETSc and MPI.

#include "mesh_options.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>

int main(int count, char** values)
{
  try
  {
    CLI::App app("blockfsi-mesh: makes the mesh of a case and reports its quality");
    blockfsi::CaseArguments of;
    blockfsi::MeshArguments arguments;
    blockfsi::add_case(app, of);
    blockfsi::add_mesh_options(app, arguments);
    try
    {
      app.parse(count, values);
    }
    catch (const CLI::ParseError& error)
    {
      // CLI11 prints help or the mistake and tells which it was.
      return app.exit(error) == 0 ? 0 : static_cast<int>(blockfsi::command::Exit::user_error);
    }
    return static_cast<int>(blockfsi::make_case_mesh(of, arguments));
  }
  catch (const std::exception& error)
  {
    fmt::print(stderr, "{}\n", blockfsi::command::message_of(error));
    return static_cast<int>(blockfsi::command::exit_of(error));
  }
}
