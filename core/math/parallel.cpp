#include "core/math/parallel.hpp"

#include <algorithm>

namespace pf {

namespace {
// Loops of a step follow each other within microseconds: look a little before going to sleep.
constexpr int spins_before_sleep = 4000;

inline void pause_briefly() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#else
  std::this_thread::yield();
#endif
}
}  // namespace

Parallel::Parallel(int threads) {
  if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  for (int i = 1; i < threads; ++i) helpers_.emplace_back([this](const std::stop_token& stop) { help(stop); });
}

Parallel::~Parallel() {
  for (std::jthread& helper : helpers_) helper.request_stop();
  generation_.fetch_add(1, std::memory_order_release);
  generation_.notify_all();
}

void Parallel::work() {
  for (int i = next_.fetch_add(1, std::memory_order_relaxed); i < pieces_;
       i = next_.fetch_add(1, std::memory_order_relaxed))
    call_(self_, i);
}

void Parallel::run(int pieces, Call call, void* self) {
  call_ = call;
  self_ = self;
  pieces_ = pieces;
  next_.store(0, std::memory_order_relaxed);
  busy_.store(static_cast<int>(helpers_.size()), std::memory_order_relaxed);
  generation_.fetch_add(1, std::memory_order_release);
  generation_.notify_all();
  work();
  for (int spin = 0;; ++spin) {
    const int left = busy_.load(std::memory_order_acquire);
    if (left == 0) return;
    if (spin < spins_before_sleep)
      pause_briefly();
    else
      busy_.wait(left, std::memory_order_acquire);
  }
}

void Parallel::help(const std::stop_token& stop) {
  unsigned seen = 0;
  for (;;) {
    unsigned now = generation_.load(std::memory_order_acquire);
    for (int spin = 0; now == seen; ++spin) {
      if (spin < spins_before_sleep)
        pause_briefly();
      else
        generation_.wait(seen, std::memory_order_acquire);
      now = generation_.load(std::memory_order_acquire);
    }
    if (stop.stop_requested()) return;
    seen = now;
    work();
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_all();
  }
}

}  // namespace pf
