// Gather and scatter between a block's nodes and a batch of particles, one axis after the other (sum factorisation):
// 3D quadratic takes 27 + 9 + 3 weighted sums a component instead of 4 * 27.
#pragma once

#include <type_traits>

#include "core/grid/plan.hpp"
#include "core/grid/wide.hpp"

namespace pf {

/// D dimensions, K nodes an axis, C components a node. `u` and `out` point at the cell's first node in a block-local
/// lattice of edge block_edge + K - 1, components interleaved. `N`, `dN`: [axis * K + node], a lane a particle.
/// `Dense`: weights of each node by itself (core/grid/dense_stencil.hpp).
template <int D, int K, int C, bool Dense = false>
struct Stencil {
  static constexpr int edge = block_edge + K - 1;
  /// Numbers in N, and where dN begins among a batch's weights.
  static constexpr int values = D * K;
  static constexpr int nodes = D == 2 ? edge * edge : edge * edge * edge;
  using Lane = Wide<lane_count<D>>;

  /// value[c] = sum_i N_i u_ic and, with Gradient, gradient[c][b] = sum_i dN_i/dx_b u_ic.
  template <bool Value, bool Gradient>
  static inline __attribute__((always_inline)) void gather(const double* u, const Lane* N, const Lane* dN, Lane* value,
                                                           Lane (*gradient)[D]) {
    for (int c = 0; c < C; ++c) {
      Lane v{}, gx{}, gy{}, gz{};
      for (int k = 0; k < (D == 3 ? K : 1); ++k) {
        Lane s{}, sx{}, sy{};
        for (int j = 0; j < K; ++j) {
          Lane r{}, rx{};
          for (int i = 0; i < K; ++i) {
            const Lane node = spread<Lane>(u[(i + edge * (j + edge * k)) * C + c]);
            r += N[i] * node;
            if constexpr (Gradient) rx += dN[i] * node;
          }
          s += N[K + j] * r;
          if constexpr (Gradient) {
            sx += N[K + j] * rx;
            sy += dN[K + j] * r;
          }
        }
        if constexpr (D == 3) {
          v += N[2 * K + k] * s;
          if constexpr (Gradient) {
            gx += N[2 * K + k] * sx;
            gy += N[2 * K + k] * sy;
            gz += dN[2 * K + k] * s;
          }
        } else {
          v = s;
          gx = sx;
          gy = sy;
        }
      }
      if constexpr (Value) value[c] = v;
      if constexpr (Gradient) {
        gradient[c][0] = gx;
        gradient[c][1] = gy;
        if constexpr (D == 3) gradient[c][2] = gz;
      }
    }
  }

  /// out_ic += sum over lanes of N_i value[c] + sum_b dN_i/dx_b flux[c][b]; Value, Flux say which terms there are. The
  /// last `plain` components have no flux.
  template <bool Value, bool Flux, int plain = 0>
  static inline __attribute__((always_inline)) void scatter(const Lane* value, const Lane (*flux)[D], const Lane* N,
                                                            const Lane* dN, double* out) {
    // A row of nodes is contiguous. What does not fill a multiple of four is summed when there is enough of it.
    constexpr int rows = D == 3 ? K * K : K, whole = K * C / 4 * 4, single = K * C - whole;
    Lane rest[rows * single + 1];
#pragma GCC unroll 4
    for (int k = 0; k < (D == 3 ? K : 1); ++k) {
      Lane a[C], fx[C], fy[C];
      for (int c = 0; c < C; ++c) {
        if constexpr (D == 3) {
          a[c] = Lane{};
          if constexpr (Value) a[c] += N[2 * K + k] * value[c];
          if (Flux && c < C - plain) {
            a[c] += dN[2 * K + k] * flux[c][2];
            fx[c] = N[2 * K + k] * flux[c][0];
            fy[c] = N[2 * K + k] * flux[c][1];
          }
        } else {
          a[c] = Value ? value[c] : Lane{};
          if (Flux && c < C - plain) {
            fx[c] = flux[c][0];
            fy[c] = flux[c][1];
          }
        }
      }
#pragma GCC unroll 4
      for (int j = 0; j < K; ++j) {
        Lane row[K * C];
        for (int c = 0; c < C; ++c) {
          Lane b = N[K + j] * a[c], bx{};
          if (Flux && c < C - plain) {
            b += dN[K + j] * fy[c];
            bx = N[K + j] * fx[c];
          }
          for (int i = 0; i < K; ++i) {
            row[i * C + c] = N[i] * b;
            if (Flux && c < C - plain) row[i * C + c] += dN[i] * bx;
          }
        }
        if constexpr (whole > 0) add_lane_sums<whole>(row, out + edge * (j + edge * k) * C);
        for (int s = 0; s < single; ++s) rest[(j + K * k) * single + s] = row[whole + s];
      }
    }
    if constexpr (single > 0) {
      double sums[rows * single] = {};
      add_lane_sums<rows * single>(rest, sums);
      for (int r = 0; r < rows; ++r)
        for (int s = 0; s < single; ++s) out[edge * (r % K + edge * (r / K)) * C + whole + s] += sums[r * single + s];
    }
  }
};

/// N_i of the cell's node n, of a batch's weights.
template <int D, int K, bool Dense>
inline Wide<lane_count<D>> node_value(const Wide<lane_count<D>>* w, int n) {
  if constexpr (Dense) {
    return w[n];
  } else {
    Wide<lane_count<D>> N = w[n % K] * w[K + n / K % K];
    if constexpr (D == 3) N *= w[2 * K + n / (K * K)];
    return N;
  }
}

/// grad N_i of the cell's node n, a lane a particle.
template <int D, int K, bool Dense>
inline void node_gradient(const Wide<lane_count<D>>* w, int n, Wide<lane_count<D>>* grad) {
  const int ix = n % K, iy = n / K % K;
  if constexpr (Dense) {
    constexpr int count = D == 2 ? K * K : K * K * K;
    for (int a = 0; a < D; ++a) grad[a] = w[(1 + a) * count + n];
  } else if constexpr (D == 2) {
    grad[0] = w[D * K + ix] * w[K + iy];
    grad[1] = w[ix] * w[D * K + K + iy];
  } else {
    const int iz = n / (K * K);
    grad[0] = w[D * K + ix] * w[K + iy] * w[2 * K + iz];
    grad[1] = w[ix] * w[D * K + K + iy] * w[2 * K + iz];
    grad[2] = w[ix] * w[K + iy] * w[D * K + 2 * K + iz];
  }
}

/// Where the cell's node n stands in its block's lattice, after the cell's first node.
template <int D, int K>
constexpr int node_offset(int n) {
  constexpr int edge = block_edge + K - 1;
  return n % K + edge * (n / K % K + edge * (n / (K * K)));
}

/// Reads the nodes of a block from a node-major vector; nodes that are not active read 0.
template <int D, int K, int C>
inline void load_block(const Plan<D>& plan, const Block<D>& block, const double* from, double* local) {
  const std::int32_t* table = plan.node_table(block);
  for (int i = 0; i < Stencil<D, K, C>::nodes; ++i)
    for (int c = 0; c < C; ++c)
      local[i * C + c] = table[i] < 0 ? 0.0 : from[static_cast<std::ptrdiff_t>(table[i]) * C + c];
}

/// Adds the block's nodes to a node-major vector.
template <int D, int K, int C>
inline void add_block(const Plan<D>& plan, const Block<D>& block, const double* local, double* to) {
  const std::int32_t* table = plan.node_table(block);
  for (int i = 0; i < Stencil<D, K, C>::nodes; ++i)
    if (table[i] >= 0)
      for (int c = 0; c < C; ++c) to[static_cast<std::ptrdiff_t>(table[i]) * C + c] += local[i * C + c];
}

/// Nodes an axis, and whether the plan keeps each node's weights by itself.
template <int K, bool Dense>
struct NodesPerAxis : std::integral_constant<int, K> {
  static constexpr bool dense = Dense;
};

/// Calls f(NodesPerAxis<K, dense>) for the plan's nodes an axis.
template <int D, class Function>
decltype(auto) with_nodes_per_axis(const Plan<D>& plan, Function&& f) {
  if (plan.dense()) return plan.nodes_per_axis() == 3 ? f(NodesPerAxis<3, true>{}) : f(NodesPerAxis<4, true>{});
  switch (plan.nodes_per_axis()) {
    case 2:
      return f(NodesPerAxis<2, false>{});
    case 3:
      return f(NodesPerAxis<3, false>{});
    default:
      return f(NodesPerAxis<4, false>{});
  }
}

/// body(block) for every block; bodies may only read nodes.
template <int D, class Body>
void for_each_block(const Plan<D>& plan, Parallel& parallel, Body&& body) {
  const auto& blocks = plan.blocks();
  parallel(static_cast<int>(blocks.size()), [&](int b) { body(blocks[static_cast<std::size_t>(b)], b); });
}

/// body(block) for every block, one colour after the other: bodies may add to the block's nodes. Each node is
/// written in the order of the colours, whatever the number of threads.
template <int D, class Body>
void for_each_block_coloured(const Plan<D>& plan, Parallel& parallel, Body&& body) {
  const auto& blocks = plan.blocks();
  for (const std::vector<int>& colour : plan.colours())
    parallel(static_cast<int>(colour.size()), [&](int k) {
      const int b = colour[static_cast<std::size_t>(k)];
      body(blocks[static_cast<std::size_t>(b)], b);
    });
}

}  // namespace pf

#include "core/grid/dense_stencil.hpp"  // IWYU pragma: export
