#include "run/interrupt.hpp"

#include <doctest/doctest.h>

#include <array>
#include <csignal>

using namespace blockfsi;

namespace
{

auto handler_of(int number)
{
  struct sigaction action = {};
  sigaction(number, nullptr, &action);
  return action.sa_handler;
}

}  // namespace

TEST_CASE("a signal is noted while a guard lives, and its old handling comes back afterwards")
{
  for (const int number : std::array{SIGINT, SIGTERM})
  {
    const auto before = handler_of(number);
    {
      const run::InterruptGuard guard;
      CHECK_FALSE(guard.requested());
      std::raise(number);
      CHECK(guard.requested());
    }
    CHECK((handler_of(number) == before));
  }
}

TEST_CASE("after the first signal a second one ends the process, as by default")
{
  const run::InterruptGuard guard;
  std::raise(SIGINT);
  CHECK((handler_of(SIGINT) == SIG_DFL));
}

TEST_CASE("a new guard knows nothing of the signals of an earlier one")
{
  {
    const run::InterruptGuard guard;
    std::raise(SIGINT);
  }
  CHECK_FALSE(run::InterruptGuard().requested());
}
