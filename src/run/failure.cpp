#include "run/failure.hpp"

#include "linalg/communicator.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace blockfsi::run
{

namespace
{

/// How long others may take to fail as well [s].
constexpr double patience = 2.0;

}  // namespace

void end_unless_all_failed(const std::exception& error)
{
  if (linalg::all_arrive(patience))
    return;
  fmt::print(stderr, "{}\n", message_of(error));
  linalg::abort(static_cast<int>(exit_of(error)));
}

}  // namespace blockfsi::run
