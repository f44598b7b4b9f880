#include "run/interrupt.hpp"

namespace blockfsi::run
{

namespace
{

volatile std::sig_atomic_t signalled = 0;

void note(int)
{
  signalled = 1;
}

}  // namespace

InterruptGuard::InterruptGuard()
{
  signalled = 0;
  struct sigaction action = {};
  action.sa_handler = note;
  sigemptyset(&action.sa_mask);
  // The default comes back with the first signal: a second one ends the process.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, &old_interrupt_);
  sigaction(SIGTERM, &action, &old_terminate_);
}

InterruptGuard::~InterruptGuard()
{
  sigaction(SIGINT, &old_interrupt_, nullptr);
  sigaction(SIGTERM, &old_terminate_, nullptr);
}

bool InterruptGuard::requested() const
{
  return signalled != 0;
}

}  // namespace blockfsi::run
