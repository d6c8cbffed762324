// Each kernel of a step measured by itself.
#pragma once

#include <string>
#include <vector>

#include "core/bench/counts.hpp"

namespace pf::bench {

struct KernelResult {
  std::string name;
  Counts counts;                ///< zero where there is no fixed number (sorting, factorising)
  double ns = 0, least_ns = 0;  ///< a particle: median and least
  int repeats = 0;
};

struct KernelCase {
  int dimension = 3;
  std::string basis;
  std::size_t particles = 0;
  int nodes = 0, threads = 1;
  double bytes = 0;  ///< of particles, plan and tangents together
  std::vector<KernelResult> kernels;
};

/// `budget`: seconds to spend on each kernel at least.
KernelCase measure_kernels(int dimension, std::string_view basis, std::size_t about_particles, int threads,
                           double budget);

}  // namespace pf::bench
