#include "core/bench/machine.hpp"

#include <fstream>

#include "core/bench/clock.hpp"
#include "core/grid/wide.hpp"
#include "core/math/parallel.hpp"

namespace pf::bench {

namespace {

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

double triad_rate(double bytes, int threads) {
  Parallel parallel(threads);
  const auto n = static_cast<std::ptrdiff_t>(bytes / 24);
  std::vector<double> a(static_cast<std::size_t>(n), 0), b(a.size(), 1), c(a.size(), 2);
  // Small arrays are passed over many times, a piece each thread, so that starting the loop does not count.
  const int passes = std::max(1, static_cast<int>(2e8 / bytes));
  double scale = 0.5;
  const auto body = [&] {
    parallel(threads, [&](int t) {
      const std::ptrdiff_t begin = n * t / threads, end = n * (t + 1) / threads;
      double *const pa = a.data(), *const pb = b.data(), *const pc = c.data();
      for (int pass = 0; pass < passes; ++pass) {
        for (std::ptrdiff_t i = begin; i < end; ++i) pa[i] = pb[i] + scale * pc[i];
        __asm__ volatile("" ::: "memory");
      }
    });
    scale += 0.1;
  };
  const Timing time = measure(
      threads == 1, 0.3, 3, [] {}, body);
  return 24.0 * static_cast<double>(n) * passes / time.least;
}

double fma_rate(int threads) {
  Parallel parallel(threads);
  // As many chains as two units of four cycles' latency want, and no more than sixteen registers hold.
  constexpr int chains = 12, length = 4'000'000;
  constexpr int width = native_bytes / sizeof(double);
  using Lanes = Wide<width>;
  std::vector<double> kept(static_cast<std::size_t>(threads) * 8);
  const auto body = [&] {
    parallel(threads, [&](int t) {
      Lanes x[chains];
      for (int k = 0; k < chains; ++k) x[k] = Lanes{} + (1.0 + k);
      const Lanes factor = Lanes{} + (1 - 1e-9), term = Lanes{} + 1e-9;
      for (int i = 0; i < length; ++i) {
#pragma GCC unroll 12
        for (Lanes& chain : x) chain = chain * factor + term;
      }
      Lanes sum{};
      for (const Lanes& chain : x) sum += chain;
      for (int lane = 0; lane < width; ++lane) kept[static_cast<std::size_t>(t) * 8] += sum[lane];
    });
  };
  const Timing time = measure(
      threads == 1, 0.3, 3, [] {}, body);
  return 2.0 * width * chains * length * threads / time.least;
}

}  // namespace

Machine measure_machine(int threads, bool quick) {
  Machine machine;
  machine.cpu = cpu_name();
  machine.threads = threads;
  for (const double bytes : {1e6, 48e6, quick ? 96e6 : 768e6})
    machine.triad.push_back({bytes, triad_rate(bytes, 1), triad_rate(bytes, threads)});
  machine.fma_one_thread = fma_rate(1);
  machine.fma_all_threads = fma_rate(threads);
  return machine;
}

}  // namespace pf::bench
