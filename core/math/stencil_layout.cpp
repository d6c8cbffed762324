#include "core/math/stencil_layout.hpp"

#include <algorithm>
#include <numeric>

namespace pf {

namespace {

/// Too small chunks cost more in starting loops than threads gain.
constexpr int least_rows_of_chunk = 512;

/// [0] the fastest: the second longest axis; the last the longest, so that planes are small.
template <int D>
std::array<int, D> order_axes(const std::array<long long, D>& extent) {
  std::array<int, D> axes;
  std::iota(axes.begin(), axes.end(), 0);
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) {
    return extent[static_cast<std::size_t>(a)] < extent[static_cast<std::size_t>(b)];
  });
  if constexpr (D == 3) std::swap(axes[0], axes[1]);
  return axes;
}

}  // namespace

template <int D>
void StencilLayout<D>::build(const std::vector<std::array<long long, D>>& index, int reach,
                             std::vector<std::int32_t>& row_of) {
  std::array<long long, D> low, high;
  low.fill(0), high.fill(0);
  if (!index.empty()) low = high = index.front();
  for (const auto& p : index)
    for (std::size_t a = 0; a < D; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  for (std::size_t a = 0; a < D; ++a) high[a] -= low[a];
  axes_ = order_axes<D>(high);
  entries_.resize(index.size());
  for (std::size_t i = 0; i < index.size(); ++i) {
    LatticePoint<D> p;
    for (std::size_t k = 0; k < D; ++k) {
      const auto a = static_cast<std::size_t>(axes_[k]);
      p[k] = static_cast<std::int32_t>(index[i][a] - low[a]);
    }
    entries_[i] = {line_key(p), p[0], static_cast<std::int32_t>(i)};
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.line != b.line ? a.line < b.line : a.first < b.first; });
  pieces_.clear();
  for (const Entry& e : entries_) {
    if (!pieces_.empty() && pieces_.back().line == e.line && pieces_.back().end == e.first)
      ++pieces_.back().end;
    else
      pieces_.push_back({e.line, e.first, e.first + 1});
  }
  build(pieces_, reach);
  row_of.resize(index.size());
  std::size_t r = 0;
  for (const Entry& e : entries_) {
    while (runs_[r].line != e.line || runs_[r].end <= e.first) ++r;
    row_of[static_cast<std::size_t>(e.node)] = runs_[r].row + (e.first - runs_[r].begin);
  }
}

template <int D>
void StencilLayout<D>::build(std::vector<LatticeRun>& pieces, int reach) {
  reach_ = reach;
  lines_ = D == 2 ? reach + 1 : reach * (2 * reach + 1) + reach + 1;
  std::sort(pieces.begin(), pieces.end(), [](const LatticeRun& a, const LatticeRun& b) {
    return a.line != b.line ? a.line < b.line : a.begin < b.begin;
  });
  // Pieces that one window could see together become one run.
  runs_.clear();
  for (const LatticeRun& piece : pieces) {
    if (!runs_.empty() && runs_.back().line == piece.line && piece.begin - runs_.back().end <= 2 * reach)
      runs_.back().end = std::max(runs_.back().end, piece.end);
    else
      runs_.push_back(piece);
  }
  // Windows stand out of a run by up to 2 reach; two threads never write to the same empty slots.
  rows_ = 0;
  slots_ = 4 * reach + 2;
  for (std::size_t k = 0; k < runs_.size(); ++k) {
    LatticeRun& run = runs_[k];
    const bool new_plane = k > 0 && point(run.line, 0)[D - 1] != point(runs_[k - 1].line, 0)[D - 1];
    if (k > 0) slots_ += new_plane ? 4 * reach + 8 : 2 * reach;
    run.row = rows_;
    run.slot = slots_;
    rows_ += run.end - run.begin;
    slots_ += run.end - run.begin;
  }
  slots_ += 4 * reach + 8;
  slot_.resize(static_cast<std::size_t>(rows_));
  row_of_slot_.assign(static_cast<std::size_t>(slots_), -1);
  for (const LatticeRun& run : runs_)
    for (std::int32_t i = 0; i < run.end - run.begin; ++i) {
      slot_[static_cast<std::size_t>(run.row) + static_cast<std::size_t>(i)] = run.slot + i;
      row_of_slot_[static_cast<std::size_t>(run.slot) + static_cast<std::size_t>(i)] = run.row + i;
    }
  make_chunks();
  make_windows();
}

template <int D>
void StencilLayout<D>::make_chunks() {
  chunks_.clear();
  int planes = 0;
  for (std::size_t k = 0; k < runs_.size(); ++k) {
    const LatticeRun& run = runs_[k];
    const bool new_plane = k == 0 || point(run.line, 0)[D - 1] != point(runs_[k - 1].line, 0)[D - 1];
    if (new_plane) ++planes;
    const bool full = !chunks_.empty() && run.row - chunks_.back().row_begin >= least_rows_of_chunk;
    if (k == 0 || (new_plane && planes > 2 * reach_ && full)) {
      chunks_.push_back({run.row, run.row, run.slot - 2 * reach_});
      planes = 1;
    }
    chunks_.back().row_end = run.row + (run.end - run.begin);
  }
  // A last chunk of few planes would let the first of two odd or even neighbours be coupled.
  if (chunks_.size() > 1 && planes < reach_) {
    chunks_[chunks_.size() - 2].row_end = chunks_.back().row_end;
    chunks_.pop_back();
  }
}

template <int D>
std::int32_t StencilLayout<D>::window(const LatticePoint<D>& first, int width, std::size_t& hint) const {
  const std::uint64_t line = line_key(first);
  const auto before = [&](const LatticeRun& run) {
    return run.line < line || (run.line == line && run.end <= first[0]);
  };
  const bool hit = hint < runs_.size() && !before(runs_[hint]) && (hint == 0 || before(runs_[hint - 1]));
  if (!hit) hint = static_cast<std::size_t>(std::partition_point(runs_.begin(), runs_.end(), before) - runs_.begin());
  if (hint == runs_.size() || runs_[hint].line != line || runs_[hint].begin >= first[0] + width) return -1;
  return runs_[hint].slot + (first[0] - runs_[hint].begin);
}

template <int D>
void StencilLayout<D>::make_windows() {
  windows_.resize(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(lines_));
  std::array<std::size_t, 32> hint{};  // a line each, at most 25 in 3D
  for (const LatticeRun& run : runs_)
    for (std::int32_t x = run.begin; x < run.end; ++x) {
      std::int32_t* out =
          windows_.data() + static_cast<std::size_t>(run.row + x - run.begin) * static_cast<std::size_t>(lines_);
      const LatticePoint<D> at = point(run.line, x);
      std::size_t l = 0;
      for (int dz = D == 3 ? -reach_ : 0; dz <= 0; ++dz)
        for (int dy = -reach_; dy <= (dz < 0 ? reach_ : 0); ++dy, ++l) {
          LatticePoint<D> first = at;
          first[0] -= reach_;
          first[1] += dy;
          if constexpr (D == 3) first[2] += dz;
          out[l] = window(first, 2 * reach_ + 1, hint[l]);
        }
    }
}

template class StencilLayout<2>;
template class StencilLayout<3>;

}  // namespace pf
