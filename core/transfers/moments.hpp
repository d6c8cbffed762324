// Moments of a particle's weights about it: what an affine velocity is carried by (THEORY T5).
#pragma once

#include "core/grid/records.hpp"
#include "core/grid/stencil.hpp"

namespace pf {

/// x_i - x_p of the K nodes of each axis [m], [axis * K + node], a lane a particle.
template <int D, int K>
void node_distances(const Plan<D>& plan, const Particles<D>& particles, const Block<D>& block, const Batch& batch,
                    Wide<lane_count<D>>* distance) {
  const int edge = block_edge + K - 1;
  int node = batch.node;
  Wide<lane_count<D>> x[D];
  load_lanes<D>(particles.x[static_cast<std::size_t>(batch.first)].data(), batch.count, x);
  for (int a = 0; a < D; ++a, node /= edge)
    for (int r = 0; r < K; ++r)
      distance[a * K + r] =
          spread<Wide<lane_count<D>>>(
              plan.spacing() * static_cast<double>(block.corner[static_cast<std::size_t>(a)] + node % edge + r)) -
          x[a];
}

/// N (x_i - x_p) in the place of grad N: of each axis, or with dense weights of each node, for each axis.
template <int D, int K, bool Dense>
void moment_weights(const Plan<D>& plan, const Particles<D>& particles, const Block<D>& block, const Batch& batch,
                    const Wide<lane_count<D>>* w, Wide<lane_count<D>>* moments) {
  Wide<lane_count<D>> distance[D * K];
  node_distances<D, K>(plan, particles, block, batch, distance);
  if constexpr (Dense) {
    constexpr int count = D == 2 ? K * K : K * K * K;
    for (int n = 0; n < count; ++n) {
      moments[n] = w[n] * distance[n % K];
      moments[count + n] = w[n] * distance[K + n / K % K];
      if constexpr (D == 3) moments[2 * count + n] = w[n] * distance[2 * K + n / (K * K)];
    }
  } else {
    for (int r = 0; r < D * K; ++r) moments[r] = w[r] * distance[r];
  }
}

/// D_p = sum N_i (x_i - x_p)(x)(x_i - x_p), column-major: diagonal unless the weights are dense.
template <int D, int K, bool Dense>
void second_moments(const Plan<D>& plan, const Particles<D>& particles, const Block<D>& block, const Batch& batch,
                    const Wide<lane_count<D>>* w, Wide<lane_count<D>>* second) {
  Wide<lane_count<D>> distance[D * K];
  node_distances<D, K>(plan, particles, block, batch, distance);
  for (int c = 0; c < D * D; ++c) second[c] = Wide<lane_count<D>>{};
  if constexpr (Dense) {
    for (int n = 0; n < (D == 2 ? K * K : K * K * K); ++n) {
      const int r[3] = {n % K, n / K % K, n / (K * K)};
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) second[a + D * b] += w[n] * distance[a * K + r[a]] * distance[b * K + r[b]];
    }
  } else {
    for (int a = 0; a < D; ++a)
      for (int r = 0; r < K; ++r) second[a + D * a] += w[a * K + r] * distance[a * K + r] * distance[a * K + r];
  }
}

}  // namespace pf
