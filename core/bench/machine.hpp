// What this machine can do at best: the two limits that every kernel is compared with.
#pragma once

#include <string>
#include <vector>

namespace pf::bench {

/// a = b + s c, 24 bytes an entry, over three arrays of together `bytes`.
struct Triad {
  double bytes = 0, one_thread = 0, all_threads = 0;  ///< [B], [B/s]
};

struct Machine {
  std::string cpu;
  int threads = 1;
  std::vector<Triad> triad;                        ///< for a second-level cache, a third-level cache, memory
  double fma_one_thread = 0, fma_all_threads = 0;  ///< double precision [flop/s]; one fused operation is two flops
  double bandwidth(int used_threads) const {
    return used_threads == 1 ? triad.back().one_thread : triad.back().all_threads;
  }
  double flops(int used_threads) const { return used_threads == 1 ? fma_one_thread : fma_all_threads; }
};

/// `threads` >= 1: what "all" means. Uses 768 MB for the moment, 96 MB when `quick`.
Machine measure_machine(int threads, bool quick);

}  // namespace pf::bench
