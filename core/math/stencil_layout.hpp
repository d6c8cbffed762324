// Lattice points in lexicographic order, stored so that the neighbours along one axis are neighbours in memory: what
// stencil matrices (core/math/stencil_matrix.hpp) and multigrid stand on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pf {

/// A point of the lattice in the layout's own axes: [0] varies fastest.
template <int D>
using LatticePoint = std::array<std::int32_t, D>;

/// Points `begin` <= p[0] < `end` of one line of the lattice.
struct LatticeRun {
  std::uint64_t line = 0;  ///< StencilLayout::line_key of its points
  std::int32_t begin = 0, end = 0;
  std::int32_t row = 0;   ///< of the first point
  std::int32_t slot = 0;  ///< of the first point
};

/// Rows are points, numbered in order. A vector has an entry for each *slot*: the rows, and between two runs empty
/// slots that are always zero, so that a window of 2 reach + 1 points around any point may be read in one piece even
/// where the lattice ends.
template <int D>
class StencilLayout {
 public:
  /// Points that a row is coupled with are at most `reach` away in each axis. `index` may have any order. The longest
  /// axis becomes the slowest. `row_of` receives each point's row.
  void build(const std::vector<std::array<long long, D>>& index, int reach, std::vector<std::int32_t>& row_of);
  /// From lines' pieces, in any order, overlapping or not; `line` and `begin`, `end` set.
  /// They are sorted and left to the caller, for their memory.
  void build(std::vector<LatticeRun>& pieces, int reach);

  int reach() const { return reach_; }
  int rows() const { return rows_; }
  int slots() const { return slots_; }
  /// Which axis of space the layout's own axis k is.
  const std::array<int, D>& axes() const { return axes_; }
  void set_axes(const std::array<int, D>& axes) { axes_ = axes; }
  const std::vector<LatticeRun>& runs() const { return runs_; }
  std::int32_t slot(int row) const { return slot_[static_cast<std::size_t>(row)]; }
  /// -1 for an empty slot.
  std::int32_t row_at(int slot) const { return row_of_slot_[static_cast<std::size_t>(slot)]; }

  /// Lines of the lower half of the stencil, in order; the row's own line is the last one.
  int lines() const { return lines_; }
  /// Slots of the first points of a row's windows, a line each; -1 where no point of the window exists.
  const std::int32_t* windows(int row) const {
    return windows_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(lines_);
  }
  /// The slot of `first`, were its line endless, or -1 when none of `width` <= 2 reach + 1 points from it on exists.
  /// `hint` makes the next search along the line short.
  std::int32_t window(const LatticePoint<D>& first, int width, std::size_t& hint) const;

  /// Rows in chunks of whole planes of the slowest axis: a chunk is coupled with the one before and the one after it
  /// only. Chunks of even number and chunks of odd number are worked on in turn.
  struct Chunk {  // windows of its own rows on its own planes begin at slot_begin or later
    std::int32_t row_begin, row_end, slot_begin;
  };
  const std::vector<Chunk>& chunks() const { return chunks_; }

  static std::uint64_t line_key(const LatticePoint<D>& p) {
    std::uint64_t key = 0;
    for (std::size_t k = D - 1; k > 0; --k) key = key << 32 | (static_cast<std::uint32_t>(p[k]) ^ 0x80000000u);
    return key;
  }
  static LatticePoint<D> point(std::uint64_t line, std::int32_t first) {
    LatticePoint<D> p;
    p[0] = first;
    for (std::size_t k = 1; k < D; ++k, line >>= 32)
      p[k] = static_cast<std::int32_t>(static_cast<std::uint32_t>(line) ^ 0x80000000u);
    return p;
  }

 private:
  void make_chunks();
  void make_windows();

  struct Entry {  // a point and where it came from
    std::uint64_t line;
    std::int32_t first, node;
  };

  int reach_ = 0, rows_ = 0, slots_ = 0, lines_ = 0;
  std::array<int, D> axes_{};
  std::vector<LatticeRun> runs_;
  std::vector<std::int32_t> slot_, row_of_slot_, windows_;
  std::vector<Chunk> chunks_;
  std::vector<Entry> entries_;      ///< of build() alone, as are
  std::vector<LatticeRun> pieces_;  ///< these
};

extern template class StencilLayout<2>;
extern template class StencilLayout<3>;

}  // namespace pf
