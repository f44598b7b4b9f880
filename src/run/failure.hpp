#pragma once

#include "run/run.hpp"

#include <exception>
#include <string>

namespace blockfsi::run
{

/// How a program ends after an exception: Exit::user_error for an Error and what the file system refuses.
Exit exit_of(const std::exception& error);

/// What to tell the user about it.
std::string message_of(const std::exception& error);

/// Tells it and ends all processes, unless all have failed: the others would wait for this one for ever. To
/// be called while nothing is destroyed yet, because processes must destroy together what they share.
void end_unless_all_failed(const std::exception& error);

}  // namespace blockfsi::run
