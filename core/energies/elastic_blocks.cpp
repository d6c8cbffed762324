// The elastic Hessian's blocks: those on the diagonal, and all of them.
#include <algorithm>

#include "core/energies/elastic.hpp"
#include "core/energies/elastic_kernels.hpp"
#include "core/energies/elastic_patches.hpp"

namespace pf {

namespace {

/// T[a][c][b] = sum_d A_{ab,cd} grad_d: half of the contraction of a tangent with two gradients.
template <int D>
inline void contract(const Narrow<lane_count<D>>* A, const Wide<lane_count<D>>* grad, Wide<lane_count<D>> (*T)[D][D]) {
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c)
      for (int b = 0; b < D; ++b) {
        Wide<lane_count<D>> sum{};
        for (int d = 0; d < D; ++d) {
          const int row = a + D * b, column = c + D * d;
          sum +=
              widen<lane_count<D>>(A[packed_tangent_index<D>(std::min(row, column), std::max(row, column))]) * grad[d];
        }
        T[a][c][b] = sum;
      }
}

}  // namespace

/// The diagonal blocks of one batch, upper halves row by row, added to the cell's nodes `out`. grad_b grad_d of a node
/// is a product of N^2, N N' and N'^2 of the axes, so one axis after the other, as in core/grid/stencil.hpp.
template <int D, int K>
inline void scatter_diagonal(const Narrow<lane_count<D>>* A, const Wide<lane_count<D>>* w, double* out) {
  using Lane = Wide<lane_count<D>>;
  constexpr int C = D * (D + 1) / 2, edge = Stencil<D, K, 1>::edge, z = D - 1;
  Lane NN[D * K], Nd[D * K], dd[D * K];
  for (int r = 0; r < D * K; ++r) {
    NN[r] = w[r] * w[r];
    Nd[r] = w[r] * w[D * K + r];
    dd[r] = w[D * K + r] * w[D * K + r];
  }
  // Of grad_b grad_d, b <= d, in each component.
  Lane part[D][D][C];
  for (int b = 0; b < D; ++b)
    for (int d = b; d < D; ++d)
      for (int a = 0, m = 0; a < D; ++a)
        for (int c = a; c < D; ++c, ++m) {
          const int p = a + D * b, q = c + D * d, r = a + D * d, s = c + D * b;
          part[b][d][m] = widen<lane_count<D>>(A[packed_tangent_index<D>(std::min(p, q), std::max(p, q))]);
          if (b != d) part[b][d][m] += widen<lane_count<D>>(A[packed_tangent_index<D>(std::min(r, s), std::max(r, s))]);
        }
  for (int k = 0; k < (D == 3 ? K : 1); ++k)
    for (int j = 0; j < K; ++j) {
      Lane row[K * C];
      for (int m = 0; m < C; ++m) {
        Lane xx = part[0][0][m], xy = part[0][1][m], yy = part[1][1][m], x0{}, y0{}, zz{};
        if constexpr (D == 3) {
          xx *= NN[z * K + k], xy *= NN[z * K + k], yy *= NN[z * K + k];
          x0 = part[0][z][m] * Nd[z * K + k];
          y0 = part[1][z][m] * Nd[z * K + k];
          zz = part[z][z][m] * dd[z * K + k];
        }
        const Lane of_dd = xx * NN[K + j], of_Nd = xy * Nd[K + j] + x0 * NN[K + j];
        const Lane of_NN = yy * dd[K + j] + y0 * Nd[K + j] + zz * NN[K + j];
        for (int i = 0; i < K; ++i) row[i * C + m] = of_dd * dd[i] + of_Nd * Nd[i] + of_NN * NN[i];
      }
      add_lane_sums<K * C>(row, out + edge * (j + edge * k) * C);
    }
}

/// The same of dense weights.
template <int D, int K>
inline void scatter_dense_diagonal(const Narrow<lane_count<D>>* A, const Wide<lane_count<D>>* w, double* out) {
  using Lane = Wide<lane_count<D>>;
  constexpr int C = D * (D + 1) / 2, count = D == 2 ? K * K : K * K * K;
  for (int n = 0; n < count; ++n) {
    Lane grad[D], T[D][D][D], row[C];
    node_gradient<D, K, true>(w, n, grad);
    contract<D>(A, grad, T);
    for (int a = 0, m = 0; a < D; ++a)
      for (int c = a; c < D; ++c, ++m) {
        row[m] = T[a][c][0] * grad[0];
        for (int b = 1; b < D; ++b) row[m] += T[a][c][b] * grad[b];
      }
    add_lane_sums<C>(row, out + node_offset<D, K>(n) * C);
  }
}

template <int D>
void ElasticEnergy<D>::diagonal(std::vector<Mat<D>>& blocks) {
  const bool coupled = barred();
  constexpr int symmetric = D * (D + 1) / 2;
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, 1, decltype(k)::dense>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int b) {
      double local[S::nodes * symmetric] = {};
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        Wide<W> room[2 * D * K];
        const Wide<W>* const w = plan_.weights(i, room);
        double* const out = local + plan_.batches()[index(i)].node * symmetric;
        if constexpr (decltype(k)::dense)
          scatter_dense_diagonal<D, K>(tangent_ + index(i) * components, w, out);
        else
          scatter_diagonal<D, K>(tangent_ + index(i) * components, w, out);
      }
      if (coupled) couple_diagonal<K>(b, local);
      const std::int32_t* table = plan_.node_table(block);
      for (int n = 0; n < S::nodes; ++n) {
        if (table[n] < 0) continue;
        Mat<D>& H = blocks[index(table[n])];
        int m = n * symmetric;
        for (int a = 0; a < D; ++a)
          for (int c = a; c < D; ++c, ++m) {
            H(a, c) += local[m];
            if (a != c) H(c, a) += local[m];
          }
      }
    });
  });
  work_.diagonal += particles_.size();
}

template <int D>
void ElasticEnergy<D>::assemble(BlockMatrix<D>& H) {
  const bool coupled = barred();
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k, count = D == 2 ? K * K : K * K * K;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int b) {
      if (coupled) couple_blocks<K>(block, b, H);
      const std::int32_t* table = plan_.node_table(block);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[index(i)];
        const Narrow<W>* A = tangent_ + index(i) * components;
        Wide<W> room[2 * D * K], grad[count][D];
        const Wide<W>* const w = plan_.weights(i, room);
        for (int n = 0; n < count; ++n) node_gradient<D, K, decltype(k)::dense>(w, n, grad[n]);
        for (int n = 0; n < count; ++n) {
          Wide<W> T[D][D][D];
          contract<D>(A, grad[n], T);
          const std::int32_t column = table[batch.node + node_offset<D, K>(n)];
          if (column < 0) continue;
          for (int m = 0; m < count; ++m) {
            const std::int32_t row = table[batch.node + node_offset<D, K>(m)];
            if (row < column) continue;
            Mat<D>& h = H.at(row, column);
            for (int a = 0; a < D; ++a)
              for (int c = 0; c < D; ++c) {
                Wide<W> sum{};
                for (int d = 0; d < D; ++d) sum += T[a][c][d] * grad[m][d];
                h(a, c) += sum_lanes(sum);
              }
          }
        }
      }
    });
  });
  work_.assembly += particles_.size();
}

#define PF_INSTANTIATE(D)                                                \
  template void ElasticEnergy<D>::diagonal(std::vector<Mat<D>>& blocks); \
  template void ElasticEnergy<D>::assemble(BlockMatrix<D>& H);
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
