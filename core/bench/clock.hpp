// How long something takes: repeated, the median and the least.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace pf::bench {

struct Timing {
  double median = 0, least = 0;  ///< [s]
  int repeats = 0;
};

/// Seconds of this thread on a processor when it works alone (other programs' share of the machine does not count), of
/// the wall clock when it has helpers.
inline double seconds(bool alone) {
  if (!alone) return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Once to warm up, then at least `least_repeats` times and until `budget` seconds are used. `before` runs ahead of
/// each repeat and is not timed.
template <class Before, class Body>
Timing measure(bool alone, double budget, int least_repeats, Before&& before, Body&& body) {
  before();
  body();
  std::vector<double> times;
  double used = 0;
  while (static_cast<int>(times.size()) < least_repeats || (used < budget && times.size() < 1000)) {
    before();
    const double begin = seconds(alone);
    body();
    times.push_back(seconds(alone) - begin);
    used += times.back();
  }
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], times.front(), static_cast<int>(times.size())};
}

}  // namespace pf::bench
