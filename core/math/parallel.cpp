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
  inside_.store(open, std::memory_order_release);
  generation_.fetch_add(1, std::memory_order_release);
  generation_.notify_all();
  work();
  // Nobody joins any more. Helpers that the system has not woken yet are not waited for: on a busy machine that would
  // cost a time slice a loop.
  int left = inside_.fetch_sub(open, std::memory_order_acq_rel) - open;
  for (int spin = 0; left != 0; ++spin) {
    if (spin < spins_before_sleep)
      pause_briefly();
    else
      inside_.wait(left, std::memory_order_acquire);
    left = inside_.load(std::memory_order_acquire);
  }
}

bool Parallel::join() {
  int inside = inside_.load(std::memory_order_acquire);
  while (inside >= open)
    if (inside_.compare_exchange_weak(inside, inside + 1, std::memory_order_acq_rel)) return true;
  return false;
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
    if (!join()) continue;
    work();
    if (inside_.fetch_sub(1, std::memory_order_acq_rel) == 1) inside_.notify_all();
  }
}

}  // namespace pf
