// From the grid to particles and back, of velocities alone: what a transfer leaves of them (Transfer::carry).
#pragma once

#include "core/transfers/moments.hpp"
#include "core/transfers/ride.hpp"

namespace pf {

/// `Velocities` as in ride(): what particles make of node velocities `v`, gathered and scattered in one pass.
template <int D, class Velocities>
void carry_velocities(const Plan<D>& plan, const Particles<D>& particles, const Vector& v, Parallel& parallel,
                      Vector& momentum, const Velocities& velocities) {
  using Lane = Wide<lane_count<D>>;
  momentum.setZero(v.size());
  with_nodes_per_axis(plan, [&](auto k) {
    constexpr int K = k;
    constexpr bool dense = decltype(k)::dense, affine = Velocities::affine;
    using S = Stencil<D, K, D, dense>;
    for_each_block_coloured(plan, parallel, [&](const Block<D>& block, int) {
      double nodes[S::nodes * D], result[S::nodes * D] = {};
      load_block<D, K, D>(plan, block, v.data(), nodes);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan.batches()[static_cast<std::size_t>(i)];
        Lane room[2 * D * K], value[D], C[D * D], flux[D][D], moments[S::values * (dense ? D : 1)];
        const Lane* const w = plan.weights(i, room);
        velocities.template ride<K, dense>({plan, particles, block, batch, w}, nodes + batch.node * D, value, C);
        const Lane m = load_lane<Lane>(particles.mass.data() + static_cast<std::size_t>(batch.first), batch.count);
        for (int a = 0; a < D; ++a) value[a] *= m;
        if constexpr (affine) {
          for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b) flux[a][b] = m * C[a + D * b];
          moment_weights<D, K, dense>(plan, particles, block, batch, w, moments);
        }
        S::template scatter<true, affine>(value, flux, w, moments, result + batch.node * D);
      }
      add_block<D, K, D>(plan, block, result, momentum.data());
    });
  });
}

}  // namespace pf
