// From one level of the multigrid to the next coarser one: which rows it has, P^T r, P x and P^T A P.
#include <algorithm>

#include "core/math/vector_ops.hpp"
#include "core/solvers/multigrid_level.hpp"
#include "core/solvers/two_scale.hpp"

namespace pf {

namespace {

using Index = std::ptrdiff_t;

constexpr int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// body(row, point) for every row, run by run.
template <int D, class Body>
void for_rows(const StencilLayout<D>& layout, Parallel& parallel, Body&& body) {
  constexpr int runs_of_piece = 16;
  const auto& runs = layout.runs();
  const int pieces = (static_cast<int>(runs.size()) + runs_of_piece - 1) / runs_of_piece;
  parallel(pieces, [&](int piece) {
    const std::size_t begin = static_cast<std::size_t>(piece) * runs_of_piece;
    for (std::size_t k = begin; k < std::min(begin + runs_of_piece, runs.size()); ++k)
      for (std::int32_t x = runs[k].begin; x < runs[k].end; ++x)
        body(runs[k].row + x - runs[k].begin, StencilLayout<D>::point(runs[k].line, x));
  });
}

/// The coarse lattice: every point that a point of this one has a part in.
template <int D, int R>
void coarse_pieces(const StencilLayout<D>& fine, std::vector<LatticeRun>& pieces) {
  constexpr int P = TwoScale<R>::parents;
  pieces.clear();
  for (const LatticeRun& run : fine.runs()) {
    const LatticePoint<D> at = StencilLayout<D>::point(run.line, run.begin);
    std::int32_t last = first_parent<R>(run.end - 1) + P - 1;
    while (part_in<R>(run.end - 1, last) == 0) --last;
    for (int n = 0; n < power(P, D - 1); ++n) {
      LatticePoint<D> parent{first_parent<R>(at[0])};
      bool any = true;
      for (int k = 1, rest = n; k < D; ++k, rest /= P) {
        const auto axis = static_cast<std::size_t>(k);
        parent[axis] = first_parent<R>(at[axis]) + rest % P;
        any = any && part_in<R>(at[axis], parent[axis]) > 0;
      }
      if (any) pieces.push_back({StencilLayout<D>::line_key(parent), parent[0], last + 1});
    }
  }
}

/// For each row of `from` the slots in `to` of the lines that begin at first(axis coordinate), `count` of them an axis.
template <int D, class First>
void connect_lines(const StencilLayout<D>& from, const StencilLayout<D>& to, int count, First&& first,
                   std::vector<std::int32_t>& slots) {
  const int lines = power(count, D - 1);
  slots.resize(static_cast<std::size_t>(from.rows()) * static_cast<std::size_t>(lines));
  std::array<std::size_t, 32> hint{};  // a line each, at most 25 in 3D
  for (const LatticeRun& run : from.runs())
    for (std::int32_t x = run.begin; x < run.end; ++x) {
      const LatticePoint<D> at = StencilLayout<D>::point(run.line, x);
      for (int n = 0; n < lines; ++n) {
        LatticePoint<D> p{first(at[0])};
        for (int k = 1, rest = n; k < D; ++k, rest /= count)
          p[static_cast<std::size_t>(k)] = first(at[static_cast<std::size_t>(k)]) + rest % count;
        slots[static_cast<std::size_t>(run.row + x - run.begin) * static_cast<std::size_t>(lines) +
              static_cast<std::size_t>(n)] = to.window(p, count, hint[static_cast<std::size_t>(n)]);
      }
    }
}

/// P^T L P of one coarse row, L the strict lower half of A plus half its diagonal: P^T A P is the sum of this and its
/// transpose. Lines of the full stencil, each a window of the coarse lattice.
template <int D, int R>
struct CoarseRow {
  using Scale = TwoScale<R>;
  static constexpr int width = window_width<D, R>, side = 2 * R + 1, full = power(side, D - 1);
  static constexpr int C = Scale::children, P = Scale::parents;
  static constexpr int lanes = window_lanes<width>, parts = width / lanes;
  using Lanes = FloatLanes<lanes>;

  /// By the child's place along the fastest axis; windows still those of the fine lattice.
  alignas(64) float by_child[C][full][D][width];
  alignas(64) float sum[full][D][width];

  static void add_scaled(const float* from, float factor, float* to) {
    for (int k = 0; k < D * parts; ++k) {
      Lanes a, s;
      __builtin_memcpy(&a, from + k * lanes, sizeof a);
      __builtin_memcpy(&s, to + k * lanes, sizeof s);
      s += a * factor;
      __builtin_memcpy(to + k * lanes, &s, sizeof s);
    }
  }

  /// One line of a child's row goes to the coarse lines that its points have a part in. `child`, `line`: places of the
  /// child and of the line's points along the slower axes, from twice the coarse row's own.
  void add_line(const float* entries, const int* child, const int* line, float (*to)[D][width]) {
    const int y0 = first_parent<R>(child[0] + line[0]);
    const int z0 = D == 3 ? first_parent<R>(child[1] + line[1]) : 0;
    for (int z = z0; z < z0 + (D == 3 ? P : 1); ++z)
      for (int y = y0; y < y0 + P; ++y) {
        float part = part_in<R>(child[0] + line[0], y) * part_in<R>(child[0], 0);
        if constexpr (D == 3) part *= part_in<R>(child[1] + line[1], z) * part_in<R>(child[1], 0);
        if (part == 0) continue;
        add_scaled(entries, part, &to[(y + R) + (D == 3 ? side * (z + R) : 0)][0][0]);
      }
  }

  void add_child(const StencilMatrix<D>& A, int row, const int* child, float (*to)[D][width]) {
    const std::int32_t* const windows = A.layout->windows(row);
    const float* const entries = A.row(row);
    int l = 0;
    for (int dz = D == 3 ? -R : 0; dz <= 0; ++dz)
      for (int dy = -R; dy <= (dz < 0 ? R : 0); ++dy, ++l) {
        const int line[2] = {dy, dz};
        if (windows[l] < 0) continue;
        if (dy != 0 || dz != 0) {
          add_line(entries + static_cast<Index>(l) * D * width, child, line, to);
          continue;
        }
        alignas(64) float own[D * width];
        std::copy_n(entries + static_cast<Index>(l) * D * width, D * width, own);
        for (int c = 0; c < D; ++c)
          for (int a = 0; a < D; ++a) own[a * width + R * D + c] += 0.5f * A.diagonal_block(row)[a + D * c];
        add_line(own, child, line, to);
      }
  }

  /// Windows of the fine lattice become windows of the coarse one.
  void collapse() {
    std::fill_n(&sum[0][0][0], full * D * width, 0.0f);
    for (int c = 0; c < C; ++c) {
      const int child = Scale::first_child + c;
      for (int from = -R; from <= R; ++from)
        for (int to = -R; to <= R; ++to) {
          const float part = part_in<R>(child + from, to) * part_in<R>(child, 0);
          if (part == 0) continue;
          for (int l = 0; l < full; ++l)
            for (int a = 0; a < D; ++a)
              for (int b = 0; b < D; ++b) sum[l][a][(to + R) * D + b] += part * by_child[c][l][a][(from + R) * D + b];
        }
    }
  }

  void compute(const StencilMatrix<D>& A, const std::int32_t* children) {
    std::fill_n(&by_child[0][0][0][0], C * full * D * width, 0.0f);
    for (int n = 0; n < power(C, D - 1); ++n) {
      if (children[n] < 0) continue;
      const int child[2] = {Scale::first_child + n % C, Scale::first_child + n / C};
      for (int c = 0; c < C; ++c) {
        const int row = A.layout->row_at(children[n] + c);
        if (row >= 0) add_child(A, row, child, by_child[c]);
      }
    }
    collapse();
  }
};

/// What of P^T L P lies in the upper half: the lines of a row that stand behind it, kept until all rows are known.
template <int D, int R>
struct UpperLines {
  static constexpr int ahead = TwoScale<R>::parents - 1;  ///< planes, along the slowest axis
  static constexpr int lines = D == 2 ? 1 + ahead : 1 + R + ahead * (2 * R + 1);
  /// Of the line at these offsets, which lie behind the row or are 0.
  static int index(int dy, int dz) {
    if (D == 2) return dy;
    return dz == 0 ? dy : 1 + R + (dz - 1) * (2 * R + 1) + dy + R;
  }
};

template <int D, int R>
void split_row(const CoarseRow<D, R>& row, float* lower, float* diagonal, float* upper) {
  constexpr int width = window_width<D, R>, side = 2 * R + 1;
  int l = 0;
  for (int dz = D == 3 ? -R : 0; dz <= 0; ++dz)
    for (int dy = -R; dy <= (dz < 0 ? R : 0); ++dy, ++l)
      std::copy_n(&row.sum[(dy + R) + (D == 3 ? side * (dz + R) : 0)][0][0], D * width, lower + l * D * width);
  // The row's own line: before it, itself, behind it.
  float* const own = lower + (l - 1) * D * width;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) diagonal[a + D * b] = own[a * width + R * D + b] + own[b * width + R * D + a];
  for (int a = 0; a < D; ++a) std::fill_n(own + a * width + R * D, width - R * D, 0.0f);
  for (int dz = 0; dz <= (D == 3 ? UpperLines<D, R>::ahead : 0); ++dz)
    for (int dy = dz == 0 ? 0 : -R; dy <= (D == 2 ? UpperLines<D, R>::ahead : R); ++dy)
      std::copy_n(&row.sum[(dy + R) + (D == 3 ? side * (dz + R) : 0)][0][0], D * width,
                  upper + UpperLines<D, R>::index(dy, dz) * D * width);
}

/// Adds to a row the transposes of what other rows have in it.
template <int D, int R>
void add_transposes(StencilMatrix<D>& A, int row, const Floats& upper) {
  constexpr int width = window_width<D, R>, ahead = UpperLines<D, R>::ahead;
  const std::int32_t* const windows = A.layout->windows(row);
  float* const entries = A.row(row);
  int l = 0;
  for (int dz = D == 3 ? -R : 0; dz <= 0; ++dz)
    for (int dy = -R; dy <= (dz < 0 ? R : 0); ++dy, ++l) {
      if (windows[l] < 0 || (D == 3 ? dz : dy) < -ahead) continue;
      const bool own = dy == 0 && dz == 0;
      for (int dx = -R; dx <= (own ? -1 : R); ++dx) {
        const int other = A.layout->row_at(windows[l] + dx + R);
        if (other < 0) continue;
        const float* const from =
            upper.data() +
            (static_cast<Index>(other) * UpperLines<D, R>::lines + UpperLines<D, R>::index(-dy, -dz)) * D * width;
        float* const to = entries + l * D * width + (dx + R) * D;
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b) to[a * width + b] += from[b * width + (R - dx) * D + a];
      }
    }
}

}  // namespace

template <int D>
void MultigridLevel<D>::connect(MultigridLevel& coarse) {
  with_reach(layout.reach(), [&](auto r) {
    constexpr int R = r;
    coarse.layout.set_axes(layout.axes());
    coarse_pieces<D, R>(layout, pieces_);
    coarse.layout.build(pieces_, R);
    coarse.resize();
    connect_lines(
        layout, coarse.layout, TwoScale<R>::parents, [](int i) { return first_parent<R>(i); }, parents_);
    connect_lines(
        coarse.layout, layout, TwoScale<R>::children, [](int I) { return 2 * I + TwoScale<R>::first_child; },
        children_);
  });
}

template <int D>
void MultigridLevel<D>::coarsen(MultigridLevel& coarse, Parallel& parallel) {
  with_reach(layout.reach(), [&](auto r) {
    constexpr int R = r, lines = power(TwoScale<R>::children, D - 1);
    constexpr int upper_size = UpperLines<D, R>::lines * D * window_width<D, R>;
    coarse.A.shape(coarse.layout);
    upper_.resize(static_cast<std::size_t>(coarse.layout.rows()) * upper_size);
    for_rows(coarse.layout, parallel, [&](int row, const LatticePoint<D>&) {
      CoarseRow<D, R> sums;
      sums.compute(A, children_.data() + static_cast<Index>(row) * lines);
      split_row<D, R>(sums, coarse.A.row(row), coarse.A.diagonal_block(row),
                      upper_.data() + static_cast<Index>(row) * upper_size);
    });
    for_rows(coarse.layout, parallel,
             [&](int row, const LatticePoint<D>&) { add_transposes<D, R>(coarse.A, row, upper_); });
  });
}

template <int D>
std::uint64_t MultigridLevel<D>::coarsening_operations() const {
  return with_reach(layout.reach(), [&](auto r) {
    // A row is a child of half the children an axis, and its lines go to `parents` lines along each slower axis.
    constexpr int R = r, lines = power(TwoScale<R>::children, D) * power(TwoScale<R>::parents, D - 1) / power(2, D);
    return static_cast<std::uint64_t>(lines) * static_cast<std::uint64_t>(layout.rows()) *
           static_cast<std::uint64_t>(A.row_size());
  });
}

template <int D>
void MultigridLevel<D>::restrict_to(MultigridLevel& coarse, Parallel& parallel) const {
  with_reach(layout.reach(), [&](auto r) {
    constexpr int R = r, C = TwoScale<R>::children, lines = power(C, D - 1);
    constexpr auto w = TwoScale<R>::weight;
    for_rows(coarse.layout, parallel, [&](int row, const LatticePoint<D>&) {
      float sum[D] = {};
      for (int n = 0; n < lines; ++n) {
        const std::int32_t slot =
            children_[static_cast<std::size_t>(row) * static_cast<std::size_t>(lines) + static_cast<std::size_t>(n)];
        if (slot < 0) continue;
        const float* const from = rest_.data() + static_cast<Index>(slot) * D;
        const float outer = w[static_cast<std::size_t>(n % C)] * (D == 3 ? w[static_cast<std::size_t>(n / C)] : 1);
        for (int c = 0; c < C; ++c)
          for (int a = 0; a < D; ++a) sum[a] -= outer * w[static_cast<std::size_t>(c)] * from[c * D + a];
      }
      std::copy_n(sum, D, coarse.b.data() + static_cast<Index>(coarse.layout.slot(row)) * D);
    });
  });
}

template <int D>
void MultigridLevel<D>::prolong_from(const MultigridLevel& coarse, Parallel& parallel) {
  with_reach(layout.reach(), [&](auto r) {
    constexpr int R = r, P = TwoScale<R>::parents, lines = power(P, D - 1);
    for_rows(layout, parallel, [&](int row, const LatticePoint<D>& at) {
      float part[D][P], sum[D] = {};
      for (std::size_t k = 0; k < D; ++k)
        for (int p = 0; p < P; ++p) part[k][p] = part_in<R>(at[k], first_parent<R>(at[k]) + p);
      for (int n = 0; n < lines; ++n) {
        const std::int32_t slot =
            parents_[static_cast<std::size_t>(row) * static_cast<std::size_t>(lines) + static_cast<std::size_t>(n)];
        if (slot < 0) continue;
        const float* const from = coarse.x.data() + static_cast<Index>(slot) * D;
        const float outer = part[1][n % P] * (D == 3 ? part[D - 1][n / P] : 1);
        for (int p = 0; p < P; ++p)
          for (int a = 0; a < D; ++a) sum[a] += outer * part[0][p] * from[p * D + a];
      }
      float* const to = x.data() + static_cast<Index>(layout.slot(row)) * D;
      for (int a = 0; a < D; ++a) to[a] += sum[a];
    });
  });
}

template void MultigridLevel<2>::connect(MultigridLevel&);
template void MultigridLevel<3>::connect(MultigridLevel&);
template void MultigridLevel<2>::coarsen(MultigridLevel&, Parallel&);
template void MultigridLevel<3>::coarsen(MultigridLevel&, Parallel&);
template std::uint64_t MultigridLevel<2>::coarsening_operations() const;
template std::uint64_t MultigridLevel<3>::coarsening_operations() const;
template void MultigridLevel<2>::restrict_to(MultigridLevel&, Parallel&) const;
template void MultigridLevel<3>::restrict_to(MultigridLevel&, Parallel&) const;
template void MultigridLevel<2>::prolong_from(const MultigridLevel&, Parallel&);
template void MultigridLevel<3>::prolong_from(const MultigridLevel&, Parallel&);

}  // namespace pf
