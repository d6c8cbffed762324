// Gather and scatter with weights that are no products of the axes' own: those of domains that rotate and shear. The
// same interface as the stencil of core/grid/stencil.hpp; as many multiplications, more memory.
#pragma once

#include "core/grid/stencil.hpp"

namespace pf {

/// `N`: K^D numbers, x fastest; `dN`: as many for each axis.
template <int D, int K, int C>
struct Stencil<D, K, C, true> {
  static constexpr int edge = block_edge + K - 1;
  static constexpr int values = D == 2 ? K * K : K * K * K;
  static constexpr int nodes = D == 2 ? edge * edge : edge * edge * edge;
  using Lane = Wide<lane_count<D>>;

  template <bool Value, bool Gradient>
  static inline __attribute__((always_inline)) void gather(const double* u, const Lane* N, const Lane* dN, Lane* value,
                                                           Lane (*gradient)[D]) {
    Lane v[C] = {}, g[C][D] = {};
    for (int n = 0, k = 0; k < (D == 3 ? K : 1); ++k)
      for (int j = 0; j < K; ++j) {
        const double* const row = u + edge * (j + edge * k) * C;
        for (int i = 0; i < K; ++i, ++n)
          for (int c = 0; c < C; ++c) {
            const Lane node = spread<Lane>(row[i * C + c]);
            if constexpr (Value) v[c] += N[n] * node;
            if constexpr (Gradient)
              for (int b = 0; b < D; ++b) g[c][b] += dN[b * values + n] * node;
          }
      }
    for (int c = 0; c < C; ++c) {
      if constexpr (Value) value[c] = v[c];
      if constexpr (Gradient)
        for (int b = 0; b < D; ++b) gradient[c][b] = g[c][b];
    }
  }

  template <bool Value, bool Flux, int plain = 0>
  static inline __attribute__((always_inline)) void scatter(const Lane* value, const Lane (*flux)[D], const Lane* N,
                                                            const Lane* dN, double* out) {
    for (int n = 0, k = 0; k < (D == 3 ? K : 1); ++k)
      for (int j = 0; j < K; ++j) {
        Lane row[K * C];
        for (int i = 0; i < K; ++i, ++n)
          for (int c = 0; c < C; ++c) {
            Lane sum{};
            if constexpr (Value) sum += N[n] * value[c];
            if (Flux && c < C - plain)
              for (int b = 0; b < D; ++b) sum += dN[b * values + n] * flux[c][b];
            row[i * C + c] = sum;
          }
        add_lane_sums<K * C>(row, out + edge * (j + edge * k) * C);
      }
  }
};

}  // namespace pf
