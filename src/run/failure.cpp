#include "run/failure.hpp"

#include "core/error.hpp"
#include "linalg/communicator.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace blockfsi::run
{

namespace
{

/// How long others may take to fail as well [s].
constexpr double patience = 2.0;

}  // namespace

Exit exit_of(const std::exception& error)
{
  const bool is_mistake = dynamic_cast<const Error*>(&error) != nullptr ||
                          dynamic_cast<const std::filesystem::filesystem_error*>(&error) != nullptr;
  return is_mistake ? Exit::user_error : Exit::internal_error;
}

std::string message_of(const std::exception& error)
{
  if (exit_of(error) == Exit::user_error)
    return error.what();
  return fmt::format("blockfsi: internal error: {}", error.what());
}

void end_unless_all_failed(const std::exception& error)
{
  if (linalg::all_arrive(patience))
    return;
  fmt::print(stderr, "{}\n", message_of(error));
  linalg::abort(static_cast<int>(exit_of(error)));
}

}  // namespace blockfsi::run
