#pragma once

#include <csignal>

namespace blockfsi::run
{

/// While it lives, SIGINT and SIGTERM are noted instead of ending the process, so that the step under way can
/// be finished and saved. A second SIGINT ends the process at once.
class InterruptGuard
{
public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();

  bool requested() const;

private:
  struct sigaction old_interrupt_;
  struct sigaction old_terminate_;
};

}  // namespace blockfsi::run
