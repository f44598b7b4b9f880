#include "run/failure.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

using namespace blockfsi;

TEST_CASE("mistakes of the user and refusals of the file system are user errors")
{
  const Error mistake("the density is -1; it must be positive");
  CHECK(run::exit_of(mistake) == run::Exit::user_error);
  CHECK(run::message_of(mistake) == mistake.what());
  const std::filesystem::filesystem_error refusal("cannot copy",
                                                  std::make_error_code(std::errc::file_exists));
  CHECK(run::exit_of(refusal) == run::Exit::user_error);
}

TEST_CASE("everything else is a mistake of the program and says so")
{
  const std::logic_error error("size mismatch");
  CHECK(run::exit_of(error) == run::Exit::internal_error);
  CHECK(run::message_of(error) == "blockfsi: internal error: size mismatch");
}

TEST_CASE("an error of the only process ends nobody else")
{
  run::end_unless_all_failed(Error("wrong"));
}
