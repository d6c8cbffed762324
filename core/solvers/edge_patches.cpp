#include "core/solvers/edge_patches.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "core/math/vector_ops.hpp"
#include "core/solvers/window_row.hpp"
#include "core/types.hpp"

namespace pf {

namespace {

using Index = std::ptrdiff_t;
using Matrix = Eigen::MatrixXf;

/// The whole stencil of a row: the lines of the lower half, the last of them its own, whole; then the others.
template <int D, int R>
constexpr int full_lines = 2 * (D == 2 ? R + 1 : R * (2 * R + 1) + R + 1) - 1;
template <int D, int R>
constexpr int full_size = full_lines<D, R>* D* window_width<D, R>;

/// What a patch can hold at most: all of a stencil.
template <int D, int R>
constexpr int most_unknowns = full_lines<D, R>*(2 * R + 1) * D;

/// Which line of the lower half lies dy, dz away.
template <int D, int R>
constexpr int line_of(int dy, int dz) {
  return D == 2 ? dy + R : (dz + R) * (2 * R + 1) + dy + R;
}

template <int D>
float trace(const float* block) {
  float sum = 0;
  for (int a = 0; a < D; ++a) sum += block[a + D * a];
  return sum;
}

template <int D, int R>
void copy_full_row(const StencilMatrix<D>& A, int row, const LatticePoint<D>& at, float* entries,
                   std::int32_t* windows) {
  constexpr int width = window_width<D, R>, side = 2 * R + 1, lower = (full_lines<D, R> + 1) / 2;
  const StencilLayout<D>& layout = *A.layout;
  std::fill_n(entries, full_size<D, R>, 0.0f);
  std::copy_n(A.row(row), lower * D * width, entries);
  std::copy_n(layout.windows(row), lower, windows);
  float* const own = entries + (lower - 1) * D * width;
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c) own[a * width + R * D + c] = A.diagonal_block(row)[a + D * c];
  std::size_t hint = 0;
  int next = lower;
  for (int dz = 0; dz <= (D == 3 ? R : 0); ++dz)
    for (int dy = dz == 0 ? 0 : -R; dy <= R; ++dy) {
      LatticePoint<D> first = at;
      first[0] -= R;
      first[1] += dy;
      if constexpr (D == 3) first[2] += dz;
      const bool is_own = dy == 0 && dz == 0;
      const int line = is_own ? lower - 1 : next++;
      const std::int32_t slot = is_own ? windows[line] : layout.window(first, side, hint);
      windows[line] = slot;
      for (int k = 0; slot >= 0 && k < side; ++k) {
        const std::int32_t j = layout.row_at(slot + k);
        if (j <= row) continue;
        const float* const from = A.row(j) + line_of<D, R>(-dy, -dz) * D * width + (side - 1 - k) * D;
        float* const to = entries + line * D * width + k * D;
        for (int a = 0; a < D; ++a)
          for (int c = 0; c < D; ++c) to[a * width + c] = from[c * width + a];
      }
    }
}

/// Calls f(slot, k-th block's first entry) for the blocks of a full row.
template <int D, int R, class Function>
void for_blocks(const float* entries, const std::int32_t* windows, Function&& f) {
  constexpr int width = window_width<D, R>, side = 2 * R + 1;
  for (int l = 0; l < full_lines<D, R>; ++l)
    for (int k = 0; windows[l] >= 0 && k < side; ++k) f(windows[l] + k, entries + l * D * width + k * D);
}

/// The inverse of a symmetric positive definite matrix, symmetric to the bit; none if it is not definite.
std::optional<Matrix> inverse_of(const Matrix& A) {
  const Eigen::LLT<Matrix> factor(A);
  if (factor.info() != Eigen::Success) return std::nullopt;
  Matrix inverse = factor.solve(Matrix::Identity(A.rows(), A.cols()));
  inverse.triangularView<Eigen::StrictlyUpper>() = inverse.transpose();
  return inverse;
}

}  // namespace

template <int D>
void EdgePatches<D>::clear() {
  patches_.clear();
  slab_begin_.assign(1, 0);
  sweep_operations_ = build_operations_ = 0;
}

template <int D>
template <int R>
void EdgePatches<D>::find_light(const StencilMatrix<D>& A, Parallel& parallel) {
  const StencilLayout<D>& layout = *A.layout;
  traces_.assign(static_cast<std::size_t>(layout.slots()), 0);
  marks_.assign(static_cast<std::size_t>(layout.rows()), 0);
  for_pieces(parallel, layout.rows(), [&](Index begin, Index count) {
    for (Index i = begin; i < begin + count; ++i)
      traces_[static_cast<std::size_t>(layout.slot(static_cast<int>(i)))] =
          trace<D>(A.diagonal_block(static_cast<int>(i)));
  });
  // A row looks at those before it and marks itself or them.
  const auto mark = [&](std::int32_t row) {
    std::atomic_ref(marks_[static_cast<std::size_t>(row)]).store(1, std::memory_order_relaxed);
  };
  for_pieces(parallel, layout.rows(), [&](Index begin, Index count) {
    for (Index i = begin; i < begin + count; ++i) {
      const auto row = static_cast<std::int32_t>(i);
      const float own = traces_[static_cast<std::size_t>(layout.slot(row))];
      const std::int32_t* const windows = layout.windows(row);
      if (!(own > 0)) continue;
      for (int l = 0; l < layout.lines(); ++l)
        for (int k = 0; windows[l] >= 0 && k < 2 * R + 1; ++k) {
          const float their = traces_[static_cast<std::size_t>(windows[l]) + static_cast<std::size_t>(k)];
          if (own < light * their) mark(row);
          if (their > 0 && their < light * own) mark(layout.row_at(windows[l] + k));
        }
    }
  });
}

template <int D>
template <int R>
void EdgePatches<D>::choose(const StencilMatrix<D>& A) {
  const StencilLayout<D>& layout = *A.layout;
  const auto trace_at = [&](std::int32_t row) { return traces_[static_cast<std::size_t>(layout.slot(row))]; };
  std::vector<std::int32_t> found;
  for (std::int32_t i = 0; i < layout.rows(); ++i)
    if (marks_[static_cast<std::size_t>(i)] != 0) found.push_back(i);
  std::ranges::stable_sort(found, [&](std::int32_t a, std::int32_t b) { return trace_at(a) < trace_at(b); });
  place_.assign(static_cast<std::size_t>(layout.rows()), -1);
  copied_.clear();
  members_.clear();
  std::vector<float> entries(full_size<D, R>);
  std::vector<std::int32_t> windows(full_lines<D, R>);
  for (const std::int32_t i : found) {
    if (place_[static_cast<std::size_t>(i)] >= 0) continue;
    const LatticePoint<D>& at = points_[static_cast<std::size_t>(i)];
    copy_full_row<D, R>(A, i, at, entries.data(), windows.data());
    Patch patch;
    patch.begin = members_.size();
    // Whole planes of the slowest axis; what a patch touches ends half a slab from it.
    patch.slab = static_cast<std::int32_t>(std::floor(static_cast<double>(at[D - 1]) / (4 * R)));
    for_blocks<D, R>(entries.data(), windows.data(), [&](std::int32_t slot, const float* block) {
      const float their = traces_[static_cast<std::size_t>(slot)];
      float square = 0;
      for (int a = 0; a < D; ++a)
        for (int c = 0; c < D; ++c) square += block[a * A.width + c] * block[a * A.width + c];
      if (!(square > strong * strong * trace_at(i) * their)) return;
      const std::int32_t j = layout.row_at(slot);
      std::int32_t& place = place_[static_cast<std::size_t>(j)];
      if (place < 0) {
        place = static_cast<std::int32_t>(copied_.size());
        copied_.push_back(j);
      }
      members_.push_back(place);
    });
    patch.end = members_.size();
    patches_.push_back(patch);
  }
  std::ranges::stable_sort(patches_, {}, &Patch::slab);
  slab_begin_.clear();
  std::size_t room = 0;
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    // A slab without patches still counts: neighbours must not be worked on at once.
    const std::int32_t slab = patches_[k].slab - patches_.front().slab;
    while (slab_begin_.size() <= static_cast<std::size_t>(slab)) slab_begin_.push_back(k);
    patches_[k].inverse = room;
    const auto n = static_cast<std::size_t>(patches_[k].nodes()) * D;
    room += n * n;
  }
  slab_begin_.push_back(patches_.size());
  inverses_.resize(room);
}

template <int D>
template <int R>
void EdgePatches<D>::copy_rows(const StencilMatrix<D>& A, Parallel& parallel) {
  slot_.resize(copied_.size());
  windows_.resize(copied_.size() * full_lines<D, R>);
  rows_.resize(copied_.size() * full_size<D, R>);
  for_pieces(parallel, static_cast<Index>(copied_.size()), [&](Index begin, Index count) {
    for (Index k = begin; k < begin + count; ++k) {
      const std::int32_t row = copied_[static_cast<std::size_t>(k)];
      slot_[static_cast<std::size_t>(k)] = A.layout->slot(row);
      copy_full_row<D, R>(A, row, points_[static_cast<std::size_t>(row)], rows_.data() + k * full_size<D, R>,
                          windows_.data() + k * full_lines<D, R>);
    }
  });
}

template <int D>
template <int R>
void EdgePatches<D>::invert(const Patch& patch) {
  const int n = patch.nodes();
  Matrix dense = Matrix::Zero(n * D, n * D);
  for (int p = 0; p < n; ++p) {
    const std::int32_t place = place_of(patch, p);
    for_blocks<D, R>(rows_.data() + static_cast<Index>(place) * full_size<D, R>,
                     windows_.data() + static_cast<Index>(place) * full_lines<D, R>,
                     [&](std::int32_t slot, const float* block) {
                       for (int q = 0; q < n; ++q) {
                         if (slot_of(patch, q) != slot) continue;
                         for (int a = 0; a < D; ++a)
                           for (int c = 0; c < D; ++c) dense(p * D + a, q * D + c) = block[a * window_width<D, R> + c];
                       }
                     });
    // Directions that are held have no stiffness: they stay.
    auto own = dense.template block<D, D>(p * D, p * D);
    const Mat<D> wide = own.template cast<double>();
    const Eigen::SelfAdjointEigenSolver<Mat<D>> eigen(0.5 * (wide + wide.transpose()));
    const double most = std::max(eigen.eigenvalues().cwiseAbs().maxCoeff(), 1e-30);
    for (int k = 0; k < D; ++k) {
      const Vec<D> axis = eigen.eigenvectors().col(k);
      if (!(eigen.eigenvalues()[k] > 1e-5 * most)) own += (most * axis * axis.transpose()).template cast<float>();
    }
  }
  const std::optional<Matrix> inverse = inverse_of(dense);
  Eigen::Map<Matrix> out(inverses_.data() + patch.inverse, n * D, n * D);
  if (inverse) {
    out = *inverse;
  } else {
    out.setZero();  // this patch does nothing
  }
}

template <int D>
void EdgePatches<D>::count(int row_entries) {
  sweep_operations_ = build_operations_ = 0;
  for (const Patch& patch : patches_) {
    const auto n = static_cast<std::uint64_t>(patch.nodes()) * D;
    sweep_operations_ += 2 * (n / D * static_cast<std::uint64_t>(row_entries) + n * n);
    build_operations_ += n * n * n / 2;
  }
}

template <int D>
void EdgePatches<D>::build(const StencilMatrix<D>& A, Parallel& parallel) {
  const StencilLayout<D>& layout = *A.layout;
  clear();
  reach_ = layout.reach();
  points_.clear();
  points_.reserve(static_cast<std::size_t>(layout.rows()));
  for (const LatticeRun& run : layout.runs())
    for (std::int32_t x = run.begin; x < run.end; ++x) points_.push_back(StencilLayout<D>::point(run.line, x));
  with_reach(reach_, [&](auto r) {
    constexpr int R = r;
    find_light<R>(A, parallel);
    choose<R>(A);
    copy_rows<R>(A, parallel);
    for_pieces(parallel, static_cast<Index>(patches_.size()), [&](Index begin, Index number) {
      for (Index k = begin; k < begin + number; ++k) invert<R>(patches_[static_cast<std::size_t>(k)]);
    });
    count(full_size<D, R>);
  });
}

template <int D>
template <class Body>
void EdgePatches<D>::for_patches(Parallel& parallel, int parity, bool forward, Body&& body) const {
  const int slabs = static_cast<int>(slab_begin_.size()) - 1;
  parallel((slabs + 1 - parity) / 2, [&](int piece) {
    const auto slab = 2 * static_cast<std::size_t>(piece) + static_cast<std::size_t>(parity);
    const std::size_t begin = slab_begin_[slab], end = slab_begin_[slab + 1];
    for (std::size_t k = 0; k < end - begin; ++k) body(patches_[forward ? begin + k : end - 1 - k]);
  });
}

template <int D>
template <int R>
void EdgePatches<D>::solve(const Patch& patch, const float* force, Floats& x, float* way) const {
  const int n = patch.nodes() * D;
  Eigen::Map<Eigen::VectorXf>(way, n).noalias() =
      Eigen::Map<const Matrix>(inverses_.data() + patch.inverse, n, n) * Eigen::Map<const Eigen::VectorXf>(force, n);
  for (int p = 0; p < patch.nodes(); ++p) {
    float* const to = x.data() + vector_place(patch, p);
    for (int a = 0; a < D; ++a) to[a] += way[p * D + a];
  }
}

template <int D>
template <int R>
void EdgePatches<D>::relax(const Patch& patch, Floats& x, Floats& rest) const {
  float force[most_unknowns<D, R>], way[most_unknowns<D, R>];
  for (int p = 0; p < patch.nodes(); ++p)
    for (int a = 0; a < D; ++a) force[p * D + a] = -rest[static_cast<std::size_t>(vector_place(patch, p) + a)];
  solve<R>(patch, force, x, way);
  for (int p = 0; p < patch.nodes(); ++p) {
    const auto place = static_cast<Index>(place_of(patch, p));
    WindowRow<D, R>::push(rows_.data() + place * full_size<D, R>, windows_.data() + place * full_lines<D, R>,
                          full_lines<D, R>, 0, all_slots, way + p * D, rest.data());
  }
}

template <int D>
template <int R>
void EdgePatches<D>::relax_back(const Patch& patch, const Floats& b, Floats& x) const {
  float force[most_unknowns<D, R>], way[most_unknowns<D, R>];
  for (int p = 0; p < patch.nodes(); ++p) {
    const auto place = static_cast<Index>(place_of(patch, p));
    float known[D] = {};
    WindowRow<D, R>::gather(rows_.data() + place * full_size<D, R>, windows_.data() + place * full_lines<D, R>,
                            full_lines<D, R>, 0, all_slots, x.data(), known);
    for (int a = 0; a < D; ++a) force[p * D + a] = b[static_cast<std::size_t>(vector_place(patch, p) + a)] - known[a];
  }
  solve<R>(patch, force, x, way);
}

template <int D>
void EdgePatches<D>::sweep(Parallel& parallel, Floats& x, Floats& rest) const {
  if (patches_.empty()) return;
  with_reach(reach_, [&](auto r) {
    for (const int parity : {0, 1})
      for_patches(parallel, parity, true, [&](const Patch& patch) { relax<r>(patch, x, rest); });
  });
}

template <int D>
void EdgePatches<D>::sweep_back(Parallel& parallel, const Floats& b, Floats& x) const {
  if (patches_.empty()) return;
  with_reach(reach_, [&](auto r) {
    for (const int parity : {1, 0})
      for_patches(parallel, parity, false, [&](const Patch& patch) { relax_back<r>(patch, b, x); });
  });
}

template class EdgePatches<2>;
template class EdgePatches<3>;

}  // namespace pf
