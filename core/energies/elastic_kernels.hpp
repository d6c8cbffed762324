// What the parts of the elastic energy share.
#pragma once

#include "core/grid/stencil.hpp"
#include "core/math/projected.hpp"

namespace pf {

inline std::size_t index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

/// Some batches of a block at a deformed state, few enough to stay in a first-level cache.
template <int D>
struct ElasticChunk {
  static constexpr int most_batches = 128 / lane_count<D>, most = most_batches * lane_count<D>;
  int batch_begin, batch_end;  ///< of the plan
  int begin, end;              ///< particles
  Mat<D> F[most], P[most];
  double psi[most];
};

/// body(chunk) for consecutive pieces of a block.
template <int D, class Body>
void for_each_chunk(const Plan<D>& plan, const Block<D>& block, Body&& body) {
  ElasticChunk<D> chunk;
  for (int i = block.batch_begin; i < block.batch_end; i = chunk.batch_end) {
    chunk.batch_begin = i;
    chunk.batch_end = std::min(block.batch_end, i + ElasticChunk<D>::most_batches);
    const Batch& last = plan.batches()[index(chunk.batch_end - 1)];
    chunk.begin = plan.batches()[index(i)].first;
    chunk.end = last.first + last.count;
    body(chunk);
  }
}

/// body(material, first, count) for the particles [begin, end) of a block, material by material.
template <int D, class Body>
void for_each_material(const Plan<D>& plan, const Block<D>& block, int begin, int end, Body&& body) {
  for (int r = block.run_begin; r < block.run_end; ++r) {
    const MaterialRun& run = plan.runs()[index(r)];
    const int first = std::max(begin, run.begin), last = std::min(end, run.end);
    if (first < last) body(run.material, first, index(last - first));
  }
}

/// Whether `project` marks a node of the cell of a batch.
template <int D>
bool meets(const Plan<D>& plan, const Block<D>& block, const Batch& batch, const Projected& project) {
  const int K = plan.nodes_per_axis(), edge = block_edge + K - 1;
  const std::int32_t* const first = plan.node_table(block) + batch.node;
  for (int z = 0; z < (D == 3 ? K : 1); ++z)
    for (int y = 0; y < K; ++y)
      if (project.at(std::span(first + edge * (y + edge * z), index(K)))) return true;
  return false;
}

/// Adds s_i = |flux grad N_i| of a batch (THEORY T4) to the cell's nodes. Sizes are not linear, so there is no
/// factorisation over the axes; roots are taken in single precision, of numbers made near one: a yardstick need not be
/// exact.
template <int D, int K, bool Dense>
inline void scatter_sizes(const Wide<lane_count<D>> (*flux)[D], const Wide<lane_count<D>>* w, double* out) {
  constexpr int lanes = lane_count<D>, edge = Stencil<D, K, 1>::edge, z = D - 1;
  using Lane = Wide<lanes>;
  Lane square{}, whole, T[D][D];
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c) square += flux[a][c] * flux[a][c];
  for (int lane = 0; lane < lanes; ++lane) whole[lane] = __builtin_sqrt(square[lane]);
  const Lane inverse = whole > 0 ? 1 / whole : Lane{};
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c) T[a][c] = flux[a][c] * inverse;
  const auto add = [&](int offset, const Lane& sum) {
    Narrow<lanes> root = __builtin_convertvector(sum, Narrow<lanes>);
    for (int lane = 0; lane < lanes; ++lane) root[lane] = __builtin_sqrtf(root[lane]);
    out[offset] += sum_lanes(Lane(whole * widen<lanes>(root)));
  };
  if constexpr (Dense) {
    for (int n = 0; n < (D == 2 ? K * K : K * K * K); ++n) {
      Lane grad[D], sum{};
      node_gradient<D, K, true>(w, n, grad);
      for (int a = 0; a < D; ++a) {
        Lane f = T[a][0] * grad[0];
        for (int c = 1; c < D; ++c) f += T[a][c] * grad[c];
        sum += f * f;
      }
      add(node_offset<D, K>(n), sum);
    }
    return;
  }
  const Lane *const N = w, *const dN = w + D * K;
  for (int k = 0; k < (D == 3 ? K : 1); ++k)
    for (int j = 0; j < K; ++j) {
      Lane along[D], across[D];  // what dN_i and N_i of the first axis are multiplied with
      for (int a = 0; a < D; ++a) {
        along[a] = T[a][0] * N[K + j];
        across[a] = T[a][1] * dN[K + j];
        if constexpr (D == 3) {
          along[a] *= N[z * K + k];
          across[a] = across[a] * N[z * K + k] + T[a][z] * (N[K + j] * dN[z * K + k]);
        }
      }
      for (int i = 0; i < K; ++i) {
        Lane sum{};
        for (int a = 0; a < D; ++a) {
          const Lane f = along[a] * dN[i] + across[a] * N[i];
          sum += f * f;
        }
        add(i + edge * (j + edge * k), sum);
      }
    }
}

}  // namespace pf
