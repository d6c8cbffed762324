// A sparse symmetric matrix of D x D blocks: the lower triangle by rows, with a fixed pattern.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace pf {

template <int D>
struct BlockMatrix {
  std::vector<std::int64_t> row_start;  ///< rows + 1
  std::vector<std::int32_t> column;     ///< ascending in each row, the last one the diagonal
  std::vector<Mat<D>> block;

  int rows() const { return static_cast<int>(row_start.size()) - 1; }
  void set_zero() { std::fill(block.begin(), block.end(), Mat<D>::Zero()); }
  /// The block (row, col), col <= row, which must be in the pattern.
  Mat<D>& at(std::int32_t row, std::int32_t col) { return block[place(row, col)]; }

 private:
  std::size_t place(std::int32_t row, std::int32_t col) const {
    const auto begin = column.begin() + row_start[static_cast<std::size_t>(row)];
    const auto end = column.begin() + row_start[static_cast<std::size_t>(row) + 1];
    return static_cast<std::size_t>(std::lower_bound(begin, end, col) - column.begin());
  }
};

}  // namespace pf
