#include "command/exit.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <new>

namespace blockfsi::command
{

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

}  // namespace blockfsi::command
