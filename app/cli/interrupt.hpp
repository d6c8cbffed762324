// Ctrl+C and SIGTERM ask a run to stop; its outputs are closed properly.
#pragma once

#include <atomic>

namespace pf::app {

/// While it lives, the first SIGINT or SIGTERM sets flag(); the second ends the program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  const std::atomic<bool>& flag() const;
};

}  // namespace pf::app
