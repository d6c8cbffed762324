#include "core/energies/explicit_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/grid/stencil.hpp"

namespace pf {

namespace {

constexpr int group = 64;  ///< particles a call of a law

/// Largest sum_i N_i'^2 / N_i over a cell, in units of 1/dx^2. Averaging makes it no larger.
template <int D>
double sharpness(const Plan<D>& plan) {
  constexpr double linear = 64.0 / 7, quadratic = 6, cubic = 3.14;
  bool ended = false;  // there splines are linear, or nearly so
  for (int a = 0; a < D; ++a) ended = ended || plan.edges(a).any();
  const int degree = plan.nodes_per_axis() - (plan.dense() ? 2 : 1);
  return degree <= 1 || ended ? linear : degree == 2 ? quadratic : cubic;
}

/// Largest row sum of V (F_n A F_n^T)_{ac,bc} / m over the axes c, of particles [first, last) of one material
/// [(m/s)^2].
template <int D>
double largest_speed2(const Law<D>& law, const Particles<D>& particles, std::size_t first, std::size_t last) {
  constexpr int components = tangent_components<D>;
  alignas(64) float values[components * group] = {};
  float* place[group];
  for (int k = 0; k < group; ++k) place[k] = values + k;
  double most = 0;
  for (; first < last; first += group) {
    const std::size_t n = std::min<std::size_t>(group, last - first);
    const std::span<const Mat<D>> F{particles.F.data() + first, n};
    law.grid_tangent(F, F, {particles.volume0.data() + first, n}, false, {place, n}, group);
    for (std::size_t k = 0; k < n; ++k)
      for (int c = 0; c < D; ++c)
        for (int a = 0; a < D; ++a) {
          double sum = 0;
          for (int b = 0; b < D; ++b) {
            const int row = std::min(a, b) + D * c, column = std::max(a, b) + D * c;
            sum += std::abs(values[static_cast<std::size_t>(packed_tangent_index<D>(row, column) * group) + k]);
          }
          most = std::max(most, sum / particles.mass[first + k]);
        }
  }
  return most;
}

}  // namespace

template <int D>
double explicit_limit(const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws, Parallel& parallel,
                      Work& work) {
  std::vector<double> of_block(plan.blocks().size(), 0.0);
  for_each_block(plan, parallel, [&](const Block<D>& block, int b) {
    double& most = of_block[static_cast<std::size_t>(b)];
    for (int r = block.run_begin; r < block.run_end; ++r) {
      const MaterialRun& run = plan.runs()[static_cast<std::size_t>(r)];
      most = std::max(most, largest_speed2<D>(*laws[run.material], particles, static_cast<std::size_t>(run.begin),
                                              static_cast<std::size_t>(run.end)));
    }
  });
  work.tangent += particles.size();
  double speed2 = 0;
  for (const double s : of_block) speed2 = std::max(speed2, s);
  if (!(speed2 > 0)) return std::numeric_limits<double>::infinity();
  return 2 * plan.spacing() / std::sqrt(sharpness(plan) * speed2);
}

template double explicit_limit<2>(const Plan<2>&, const Particles<2>&, const Laws<2>&, Parallel&, Work&);
template double explicit_limit<3>(const Plan<3>&, const Particles<3>&, const Laws<3>&, Parallel&, Work&);

}  // namespace pf
