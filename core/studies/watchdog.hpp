// Ends a run from outside: when its time is up, or when the user cancels.
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

namespace pf {

/// While it lives, a thread looks every few milliseconds; flag() is what a run polls.
class Watchdog {
 public:
  Watchdog(double seconds, const std::atomic<bool>* cancel) : cancel_(cancel) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    thread_ = std::jthread([this, deadline](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        if (std::chrono::steady_clock::now() >= deadline) timed_out_ = true;
        if (timed_out_ || cancelled()) flag_ = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
    });
  }
  const std::atomic<bool>* flag() const { return &flag_; }
  /// Ask the run to stop for a reason of one's own.
  void stop() { flag_ = true; }
  bool timed_out() const { return timed_out_; }
  bool cancelled() const { return cancel_ != nullptr && cancel_->load(); }

 private:
  const std::atomic<bool>* cancel_;
  std::atomic<bool> flag_{false}, timed_out_{false};
  std::jthread thread_;
};

}  // namespace pf
