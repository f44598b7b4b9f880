#include "command/exit.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

using namespace blockfsi;

TEST_CASE("mistakes of the user and refusals of the file system are user errors")
{
  const Error mistake("the density is -1; it must be positive");
  CHECK(command::exit_of(mistake) == command::Exit::user_error);
  CHECK(command::message_of(mistake) == mistake.what());
  const std::filesystem::filesystem_error refusal("cannot copy",
                                                  std::make_error_code(std::errc::file_exists));
  CHECK(command::exit_of(refusal) == command::Exit::user_error);
}

TEST_CASE("everything else is a mistake of the program and says so")
{
  const std::logic_error error("size mismatch");
  CHECK(command::exit_of(error) == command::Exit::internal_error);
  CHECK(command::message_of(error) == "blockfsi: internal error: size mismatch");
}
