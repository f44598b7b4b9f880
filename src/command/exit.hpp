#pragma once

#include <exception>
#include <string>

namespace blockfsi::command
{

/// How a command ends; the exit code of the program.
enum class Exit
{
  done = 0,
  missed = 1,  ///< verify: a quantity misses its reference
  user_error = 2,
  failed = 3,  ///< the numbers did not work out; the last good state is written
  internal_error = 70,
  interrupted = 130  ///< by SIGINT or SIGTERM; a checkpoint is written
};

/// How a program ends after an exception: Exit::user_error for an Error and what the file system refuses.
Exit exit_of(const std::exception& error);

/// What to tell the user about it.
std::string message_of(const std::exception& error);

}  // namespace blockfsi::command
