// What a row of a stencil matrix does to vectors, a window at a time.
#pragma once

#include <cstddef>

#include "core/math/stencil_matrix.hpp"

namespace pf {

/// As the end of a range: all of them.
inline constexpr int all_slots = 0x7fffffff;

/// A row of a stencil matrix, or a part of one: `lines` windows of 2 R + 1 blocks, each from the slot `windows[l]` on,
/// or nowhere where that is -1; entries as in StencilMatrix::row. Vectors hold D floats a slot.
template <int D, int R>
struct WindowRow {
  static constexpr int width = window_width<D, R>;
  static constexpr int lanes = window_lanes<width>, parts = width / lanes;
  using Lanes = FloatLanes<lanes>;

  static Lanes load(const float* from) {
    Lanes v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
  }

  /// sum[a] += the row times x, over the windows that begin in the slots [first, last).
  static inline __attribute__((always_inline)) void gather(const float* row, const std::int32_t* windows, int lines,
                                                           int first, int last, const float* x, float* sum) {
    Lanes total[D][parts] = {};
    for (int l = 0; l < lines; ++l) {
      if (windows[l] < first || windows[l] >= last) continue;
      const float* const at = x + static_cast<std::ptrdiff_t>(windows[l]) * D;
      const float* const entries = row + static_cast<std::ptrdiff_t>(l) * D * width;
      for (int k = 0; k < parts; ++k) {
        const Lanes value = load(at + k * lanes);
        for (int a = 0; a < D; ++a) total[a][k] += load(entries + a * width + k * lanes) * value;
      }
    }
    for (int a = 0; a < D; ++a) {
      Lanes v = total[a][0];
      for (int k = 1; k < parts; ++k) v += total[a][k];
      for (int half = lanes / 2; half > 0; half /= 2)
        for (int j = 0; j < half; ++j) v[j] += v[j + half];
      sum[a] += v[0];
    }
  }

  /// to += the transposed row times the row's own `value`, over the same windows.
  static inline __attribute__((always_inline)) void push(const float* row, const std::int32_t* windows, int lines,
                                                         int first, int last, const float* value, float* to) {
    for (int l = 0; l < lines; ++l) {
      if (windows[l] < first || windows[l] >= last) continue;
      float* const at = to + static_cast<std::ptrdiff_t>(windows[l]) * D;
      const float* const entries = row + static_cast<std::ptrdiff_t>(l) * D * width;
      for (int k = 0; k < parts; ++k) {
        Lanes sum = load(at + k * lanes);
        for (int a = 0; a < D; ++a) sum += load(entries + a * width + k * lanes) * value[a];
        __builtin_memcpy(at + k * lanes, &sum, sizeof sum);
      }
    }
  }
};

}  // namespace pf
