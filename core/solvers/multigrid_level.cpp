#include "core/solvers/multigrid_level.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/math/vector_ops.hpp"
#include "core/solvers/window_row.hpp"

namespace pf {

namespace {

using Index = std::ptrdiff_t;

template <int D, int R>
constexpr int lower_lines = D == 2 ? R + 1 : R*(2 * R + 1) + R + 1;

/// Gauss-Seidel on one row: x_i = inverse (b_i - rest_i - lower half times x), then x_i's part in the rows before it.
template <int D, int R>
inline void relax(const MultigridLevel<D>& level, int i, float* x, float* rest) {
  using Row = WindowRow<D, R>;
  const Index at = static_cast<Index>(level.layout.slot(i)) * D;
  const float* const row = level.A.row(i);
  const std::int32_t* const windows = level.layout.windows(i);
  float known[D] = {};
  Row::gather(row, windows, lower_lines<D, R>, 0, all_slots, x, known);
  const float* const inverse = level.inverse.data() + static_cast<Index>(i) * D * D;
  float value[D] = {};
  for (int c = 0; c < D; ++c) {
    const float force = level.b[static_cast<std::size_t>(at + c)] - rest[at + c] - known[c];
    for (int a = 0; a < D; ++a) value[a] += inverse[a + D * c] * force;
  }
  for (int a = 0; a < D; ++a) {
    x[at + a] = value[a];
    rest[at + a] = 0;
  }
  Row::push(row, windows, lower_lines<D, R>, 0, all_slots, value, rest);
}

/// body(chunk) for the chunks of one parity.
template <class Chunks, class Body>
void for_chunks(Parallel& parallel, const Chunks& chunks, int parity, Body&& body) {
  const int count = (static_cast<int>(chunks.size()) + 1 - parity) / 2;
  parallel(count, [&](int k) { body(chunks[2 * static_cast<std::size_t>(k) + static_cast<std::size_t>(parity)]); });
}

void fill_zero(Parallel& parallel, Floats& v) {
  for_pieces(parallel, static_cast<Index>(v.size()),
             [&](Index begin, Index count) { std::fill_n(v.begin() + begin, count, 0.0f); });
}

/// Whether a row is coupled with the chunk before its own.
template <class Layout, class Chunk>
bool reaches_out(const Layout& layout, const Chunk& chunk, int row) {
  const std::int32_t* windows = layout.windows(row);
  for (int l = 0; l < layout.lines(); ++l)
    if (windows[l] >= 0) return windows[l] < chunk.slot_begin;
  return false;
}

}  // namespace

template <int D>
void MultigridLevel<D>::resize() {
  const auto n = static_cast<std::size_t>(layout.slots()) * D;
  for (Floats* v : {&b, &x, &rest_}) v->assign(n, 0);
}

template <int D>
void MultigridLevel<D>::invert_diagonal(Parallel& parallel) {
  using Block = Eigen::Matrix<float, D, D>;
  inverse.resize(A.diagonal.size());
  for_pieces(parallel, layout.rows(), [&](Index begin, Index count) {
    for (Index i = begin; i < begin + count; ++i) {
      const Block block = Eigen::Map<const Block>(A.diagonal_block(static_cast<int>(i)));
      Eigen::Map<Block> out(inverse.data() + i * D * D);
      const Mat<D> wide = block.template cast<double>();
      const Eigen::SelfAdjointEigenSolver<Mat<D>> eigen(0.5 * (wide + wide.transpose()));
      const double least = 1e-5 * eigen.eigenvalues().cwiseAbs().maxCoeff();
      Mat<D> result = Mat<D>::Zero();
      for (int k = 0; k < D; ++k) {
        const double value = eigen.eigenvalues()[k];
        const Vec<D> axis = eigen.eigenvectors().col(k);
        if (value > least && value > 1e-30) result += axis * axis.transpose() / value;
      }
      out = result.template cast<float>();
    }
  });
}

template <int D>
void MultigridLevel<D>::smooth_from_zero(Parallel& parallel) {
  fill_zero(parallel, x);
  fill_zero(parallel, rest_);
  with_reach(layout.reach(), [&](auto r) {
    constexpr int R = r;
    const auto& chunks = layout.chunks();
    for (const int parity : {0, 1})
      for_chunks(parallel, chunks, parity, [&](const auto& chunk) {
        for (int i = chunk.row_begin; i < chunk.row_end; ++i) relax<D, R>(*this, i, x.data(), rest_.data());
      });
    // Rows of even chunks have not seen the odd chunk before theirs.
    for_chunks(parallel, chunks, 0, [&](const auto& chunk) {
      for (int i = chunk.row_begin; i < chunk.row_end; ++i) {
        if (!reaches_out(layout, chunk, i)) continue;
        WindowRow<D, R>::gather(A.row(i), layout.windows(i), lower_lines<D, R>, 0, chunk.slot_begin, x.data(),
                                rest_.data() + static_cast<Index>(layout.slot(i)) * D);
      }
    });
  });
  patches.sweep(parallel, x, rest_);
}

template <int D>
void MultigridLevel<D>::smooth_back(Parallel& parallel) {
  fill_zero(parallel, rest_);
  patches.sweep_back(parallel, b, x);
  with_reach(layout.reach(), [&](auto r) {
    constexpr int R = r;
    const auto& chunks = layout.chunks();
    for_chunks(parallel, chunks, 0, [&](const auto& chunk) {
      for (int i = chunk.row_begin; i < chunk.row_end; ++i) {
        if (!reaches_out(layout, chunk, i)) continue;
        WindowRow<D, R>::push(A.row(i), layout.windows(i), lower_lines<D, R>, 0, chunk.slot_begin,
                              x.data() + static_cast<Index>(layout.slot(i)) * D, rest_.data());
      }
    });
    for (const int parity : {1, 0})
      for_chunks(parallel, chunks, parity, [&](const auto& chunk) {
        for (int i = chunk.row_end - 1; i >= chunk.row_begin; --i) relax<D, R>(*this, i, x.data(), rest_.data());
      });
  });
}

template class MultigridLevel<2>;
template class MultigridLevel<3>;

}  // namespace pf
