#include "app/cli/interrupt.hpp"

#include <csignal>
#include <ctime>

namespace pf::app {

namespace {

// A signal handler can reach nothing else.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

std::atomic<long long> first_at{0};  // [ms]
static_assert(std::atomic<long long>::is_always_lock_free);

long long now_ms() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);  // one of the calls that a handler may make
  return 1000LL * t.tv_sec + t.tv_nsec / 1'000'000;
}

/// The first asks the run to end. A later one ends the program, unless it follows at once: what stops a whole process
/// group, as timeout(1) does, tells the program twice.
void on_signal(int signal) {
  constexpr long long at_once = 500;
  if (!interrupted.exchange(true)) {
    first_at.store(now_ms());
  } else if (now_ms() - first_at.load() > at_once) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

InterruptGuard::InterruptGuard() {
  interrupted.store(false);
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& InterruptGuard::flag() const {
  return interrupted;
}

}  // namespace pf::app
