// The elastic Hessian as a stencil matrix, in single precision: for preconditioners.
#include <utility>

#include "core/energies/elastic.hpp"
#include "core/energies/elastic_patches.hpp"
#include "core/grid/stencil.hpp"

namespace pf {

namespace {

/// The blocks H_mn = sum_p sum_b grad_m[b] (sum_d A_p[(a b), (c d)] grad_n[d]) of one batch. Nodes along the layout's
/// fastest axis and the components c lie beside each other in a vector: a whole piece of a matrix row at a time.
template <int D, int K, bool Dense>
class CellBlocks {
 public:
  static constexpr int R = K - 1, lines = D == 2 ? K : K * K, nodes = K * lines;
  static constexpr int used = D * K, lanes = (used + 7) / 8 * 8, width = window_width<D, R>;
  using Lanes = FloatLanes<lanes>;

  explicit CellBlocks(const std::array<int, D>& axes) : axes_(axes) {
    for (int k = 0; k < D; ++k) place_[axes[static_cast<std::size_t>(k)]] = k;
  }

  void compute(const Plan<D>& plan, int batch, const Narrow<lane_count<D>>* tangent) {
    count_ = plan.batches()[static_cast<std::size_t>(batch)].count;
    Wide<lane_count<D>> room[2 * D * K];
    const Wide<lane_count<D>>* const w = plan.weights(batch, room);
    for (int lane = 0; lane < count_; ++lane) {
      if constexpr (Dense)
        set_dense_particle(w, tangent, lane);
      else
        set_particle(w, tangent, lane);
    }
  }

  /// Adds all blocks to the rows of the cell's nodes; node n of the layout's own axes is in row rows[n].
  void add_to(StencilMatrix<D>& H, const std::int32_t* rows) const {
    for (int a = 0; a < D; ++a)
      for (int first = 0; first < lines; first += K)
        for (int m = first; m < lines; ++m) add_lines(H, rows, a, first, m);
  }

 private:
  /// gradient_[p], and along[d]: the same of each line, a node's D components alike.
  void set_gradients(const Wide<lane_count<D>>* w, int p, Lanes (*along)[lines]) {
    // A node of the layout's own axes among the weights, x fastest.
    int step[D];
    for (int k = 0; k < D; ++k) {
      const int axis = axes_[static_cast<std::size_t>(k)];
      step[k] = axis == 0 ? 1 : axis == 1 ? K : K * K;
    }
    for (int n = 0; n < nodes; ++n) {
      const int at = n % K * step[0] + n / K % K * step[1] + (D == 3 ? n / (K * K) * step[D - 1] : 0);
      for (int d = 0; d < D; ++d) gradient_[p][n][d] = static_cast<float>(w[(1 + d) * nodes + at][p]);
    }
    for (int d = 0; d < D; ++d)
      for (int l = 0; l < lines; ++l)
        for (int j = 0; j < lanes; ++j) along[d][l][j] = j < used ? gradient_[p][j / D + K * l][d] : 0;
  }

  void set_dense_particle(const Wide<lane_count<D>>* w, const Narrow<lane_count<D>>* tangent, int p) {
    Lanes along[D][lines];
    set_gradients(w, p, along);
    float A[D * D][D * D + lanes];
    unpack(tangent, p, A);
    for (int b = 0; b < D; ++b)
      for (int a = 0; a < D; ++a)
        for (int l = 0; l < lines; ++l) {
          Lanes sum = repeat(A[a + D * b]) * along[0][l];
          for (int d = 1; d < D; ++d) sum += repeat(A[a + D * b] + D * d) * along[d][l];
          half_[p][b][a][l] = sum;
        }
  }

  static void unpack(const Narrow<lane_count<D>>* tangent, int p, float (*A)[D * D + lanes]) {
    for (int row = 0; row < D * D; ++row)
      for (int column = 0; column < D * D; ++column)
        A[row][column] = tangent[packed_tangent_index<D>(std::min(row, column), std::max(row, column))][p];
  }

  void set_particle(const Wide<lane_count<D>>* w, const Narrow<lane_count<D>>* tangent, int p) {
    float N[2][D][K];  // N and its derivative, along the layout's axes
    for (int k = 0; k < D; ++k)
      for (int r = 0; r < K; ++r)
        for (int d = 0; d < 2; ++d)
          N[d][k][r] = static_cast<float>(w[(axes_[static_cast<std::size_t>(k)] + d * D) * K + r][p]);
    Lanes along[2];  // the fastest axis, a node's D components alike
    for (int d = 0; d < 2; ++d)
      for (int j = 0; j < lanes; ++j) along[d][j] = j < used ? N[d][0][j / D] : 0;
    float outer[D][lines];  // d/dx_d, what the other axes give
    for (int d = 0; d < D; ++d)
      for (int l = 0; l < lines; ++l)
        outer[d][l] = N[place_[d] == 1][1][l % K] * (D == 3 ? N[place_[d] == 2][D - 1][l / K] : 1);
    for (int l = 0; l < lines; ++l)
      for (int i = 0; i < K; ++i)
        for (int d = 0; d < D; ++d) gradient_[p][i + K * l][d] = N[place_[d] == 0][0][i] * outer[d][l];
    float A[D * D][D * D + lanes];
    unpack(tangent, p, A);
    for (int b = 0; b < D; ++b)
      for (int a = 0; a < D; ++a) {
        Lanes part[D];
        for (int d = 0; d < D; ++d) part[d] = repeat(A[a + D * b] + D * d) * along[place_[d] == 0];
        for (int l = 0; l < lines; ++l) {
          Lanes sum = part[0] * outer[0][l];
          for (int d = 1; d < D; ++d) sum += part[d] * outer[d][l];
          half_[p][b][a][l] = sum;
        }
      }
  }

  /// The first D of `from` again and again.
  static Lanes repeat(const float* from) { return repeat(from, std::make_integer_sequence<int, lanes>()); }
  template <int... j>
  static Lanes repeat(const float* from, std::integer_sequence<int, j...>) {
    Lanes v;
    __builtin_memcpy(&v, from, sizeof v);
    return __builtin_shufflevector(v, v, (j % D)...);
  }

  /// Component a of the K nodes of line m with the nodes of the lines [first, first + K) up to m.
  void add_lines(StencilMatrix<D>& H, const std::int32_t* rows, int a, int first, int m) const {
    Lanes sum[K][K] = {};
    for (int p = 0; p < count_; ++p)
      for (int b = 0; b < D; ++b) {
        const Lanes* const T = half_[p][b][a] + first;
#pragma GCC unroll 4
        for (int i = 0; i < K; ++i) {
          const float g = gradient_[p][i + K * m][b];
#pragma GCC unroll 4
          for (int l = 0; l < K; ++l) sum[i][l] += g * T[l];
        }
      }
    for (int l = 0; l < K && first + l < m; ++l) {
      const int dy = (first + l) % K - m % K, dz = (first + l) / K - m / K;
      const int line = D == 2 ? dy + R : (dz + R) * (2 * R + 1) + dy + R;
      // Beyond the `used` lanes are zeros; they may reach into the next line, which is the same row's: its own line is
      // the last one.
      for (int i = 0; i < K; ++i) {
        if (Dense && rows[i + K * m] < 0) continue;
        float* const to = H.row(rows[i + K * m]) + (line * D + a) * width + D * (R - i);
        Lanes at;
        __builtin_memcpy(&at, to, sizeof at);
        at += sum[i][l];
        __builtin_memcpy(to, &at, sizeof at);
      }
    }
    if (m < first + K) [&]<int... i>(std::integer_sequence<int, i...>) {
        (add_own_line<i>(H, rows[i + K * m], a, sum[i][m - first]), ...);
      }
    (std::make_integer_sequence<int, K>{});
  }

  /// A row's own line: the nodes before node i of the line, and itself.
  template <int i>
  static void add_own_line(StencilMatrix<D>& H, std::int32_t row, int a, const Lanes& sum) {
    if (Dense && row < 0) return;
    float* const to = H.row(row) + (H.layout->lines() - 1) * D * width + a * width + D * (R - i);
    for (int j = 0; j < D * i; ++j) to[j] += sum[j];
    for (int c = 0; c < D; ++c) H.diagonal_block(row)[a + D * c] += sum[D * i + c];
  }

  std::array<int, D> axes_;
  int place_[D];  ///< of each axis of space among the layout's
  int count_ = 0;
  float gradient_[lane_count<D>][nodes][D];
  Lanes half_[lane_count<D>][D][D][lines];
};

}  // namespace

template <int D>
bool ElasticEnergy<D>::assemble_stencil(StencilMatrix<D>& H, const std::vector<std::int32_t>& row_of) {
  const bool coupled = barred();
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k, edge = Stencil<D, K, 1>::edge;
    using Blocks = CellBlocks<D, K, decltype(k)::dense>;
    const std::array<int, D>& axes = H.layout->axes();
    int offset[Blocks::nodes];
    for (int n = 0; n < Blocks::nodes; ++n) {
      offset[n] = 0;
      for (int j = 0, rest = n; j < D; ++j, rest /= K) {
        const int axis = axes[static_cast<std::size_t>(j)];
        offset[n] += rest % K * (axis == 0 ? 1 : axis == 1 ? edge : edge * edge);
      }
    }
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int b) {
      if (coupled) couple_stencil<K>(block, b, row_of, H);
      Blocks blocks(axes);
      const std::int32_t* table = plan_.node_table(block);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[static_cast<std::size_t>(i)];
        std::int32_t rows[Blocks::nodes];
        for (int n = 0; n < Blocks::nodes; ++n) {
          const std::int32_t node = table[batch.node + offset[n]];
          rows[n] = node < 0 ? -1 : row_of[static_cast<std::size_t>(node)];
        }
        blocks.compute(plan_, i, tangent_ + static_cast<std::size_t>(i) * components);
        blocks.add_to(H, rows);
      }
    });
  });
  work_.assembly += particles_.size();
  return true;
}

template bool ElasticEnergy<2>::assemble_stencil(StencilMatrix<2>&, const std::vector<std::int32_t>&);
template bool ElasticEnergy<3>::assemble_stencil(StencilMatrix<3>&, const std::vector<std::int32_t>&);

}  // namespace pf
