#include "run/failure.hpp"

#include "core/error.hpp"
#include "linalg/communicator.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <new>

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
  // Most likely a mesh that is far too fine.
  const bool is_too_large = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  return is_mistake || is_too_large ? Exit::user_error : Exit::internal_error;
}

std::string message_of(const std::exception& error)
{
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "the memory of this machine does not suffice for the case; lower the divisions or the order in "
           "[blocks], or "
           "use more machines with mpirun";
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
