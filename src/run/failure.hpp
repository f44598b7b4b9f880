#pragma once

#include "command/exit.hpp"

#include <exception>

namespace blockfsi::run
{

using command::exit_of;
using command::message_of;

/// Tells of an error and ends all processes, unless all have failed: the others would wait for this one for
/// ever. To be called while nothing is destroyed yet, because processes must destroy together what they
/// share.
void end_unless_all_failed(const std::exception& error);

}  // namespace blockfsi::run
