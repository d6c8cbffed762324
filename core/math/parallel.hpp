// Parallel loops with a fixed partition: the work is cut the same way whatever the number of threads, each piece
// writes its own place and sums are taken in the order of the pieces, so the threads never change a bit.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace pf {

/// A small pool: the calling thread and `threads - 1` helpers that sleep between loops.
class Parallel {
 public:
  /// `threads` <= 0: one for each hardware thread.
  explicit Parallel(int threads);
  ~Parallel();
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;

  int threads() const { return static_cast<int>(helpers_.size()) + 1; }

  /// Calls `body(piece)` once for each piece in [0, pieces), in any order, on any thread; returns when all are done.
  /// `body` must not throw and must not start another loop.
  template <class Body>
  void operator()(int pieces, Body&& body) {
    if (pieces <= 1 || helpers_.empty()) {
      for (int i = 0; i < pieces; ++i) body(i);
      return;
    }
    using Plain = std::remove_reference_t<Body>;
    run(
        pieces, [](void* self, int piece) { (*static_cast<Plain*>(self))(piece); },
        const_cast<void*>(static_cast<const void*>(&body)));
  }

 private:
  using Call = void (*)(void*, int);
  static constexpr int open = 1 << 20;
  void run(int pieces, Call call, void* self);
  void work();
  bool join();
  void help(const std::stop_token& stop);

  Call call_ = nullptr;
  void* self_ = nullptr;
  int pieces_ = 0;
  std::atomic<int> next_{0};
  std::atomic<int> inside_{0};           ///< helpers at work on the current loop, plus `open` while they may join
  std::atomic<unsigned> generation_{0};  ///< counts loops: helpers wait for it to change
  std::vector<std::jthread> helpers_;
};

/// How many entries of a long vector make one piece of a loop over it.
inline constexpr std::ptrdiff_t vector_piece = 4096;
inline int vector_pieces(std::ptrdiff_t n) {
  return static_cast<int>((n + vector_piece - 1) / vector_piece);
}

}  // namespace pf
