// Short vectors of doubles, one particle a lane, by the compilers' vector extension: the same source for SSE,
// AVX2, AVX-512 and NEON.
#pragma once

#include <cstdint>

#include "core/math/spread.hpp"

namespace pf {

/// Particles handled together: a 2D cell usually holds 4, a 3D cell 8.
template <int D>
inline constexpr int lane_count = D == 2 ? 4 : 8;

template <int W>
struct WideOf {
  typedef double type __attribute__((vector_size(W * 8)));  // NOLINT: the attribute needs a typedef
};
template <int W>
using Wide = typename WideOf<W>::type;

/// As many integers.
template <int W>
struct WholeOf {
  typedef std::int64_t type __attribute__((vector_size(W * 8)));  // NOLINT: the attribute needs a typedef
};
template <int W>
using Whole = typename WholeOf<W>::type;

/// As many numbers in single precision: half the memory for what need not be exact.
template <int W>
struct NarrowOf {
  typedef float type __attribute__((vector_size(W * 4)));  // NOLINT: the attribute needs a typedef
};
template <int W>
using Narrow = typename NarrowOf<W>::type;

template <int W>
inline __attribute__((always_inline)) Wide<W> widen(const Narrow<W>& v) {
  if constexpr (sizeof(Wide<W>) <= native_bytes) {
    return __builtin_convertvector(v, Wide<W>);
  } else {
    Narrow<W / 2> half[2];
    __builtin_memcpy(half, &v, sizeof v);
    const Wide<W / 2> wide[2] = {widen<W / 2>(half[0]), widen<W / 2>(half[1])};
    Wide<W> lanes;
    __builtin_memcpy(&lanes, wide, sizeof lanes);
    return lanes;
  }
}

/// Sum over the lanes, always in the same order.
inline double sum_lanes(const Wide<4>& v) {
  return (v[0] + v[2]) + (v[1] + v[3]);
}
inline double sum_lanes(const Wide<8>& v) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

/// Sums of several vectors at once, lane k of the result that of v[k]: transposing while adding takes a third of the
/// shuffles that single sums take.
inline __attribute__((always_inline)) Wide<4> sums_of_four(const Wide<4>* v) {
  const Wide<4> ab = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6) + __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7);
  const Wide<4> cd = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6) + __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}
inline __attribute__((always_inline)) Wide<4> sums_of_four(const Wide<8>* v) {
  Wide<4> halves[4];
  for (int k = 0; k < 4; ++k)
    halves[k] = __builtin_shufflevector(v[k], v[k], 0, 1, 2, 3) + __builtin_shufflevector(v[k], v[k], 4, 5, 6, 7);
  return sums_of_four(halves);
}
/// One of the two operands of each sum keeps its lanes, which a blend does as cheaply as an addition.
inline __attribute__((always_inline)) Wide<8> sums_of_eight(const Wide<8>* v) {
  Wide<8> pairs[4], fours[2];
  for (int k = 0; k < 4; ++k)
    pairs[k] = __builtin_shufflevector(v[2 * k], v[2 * k + 1], 0, 9, 2, 11, 4, 13, 6, 15) +
               __builtin_shufflevector(v[2 * k], v[2 * k + 1], 1, 8, 3, 10, 5, 12, 7, 14);
  for (int k = 0; k < 2; ++k)
    fours[k] = __builtin_shufflevector(pairs[2 * k], pairs[2 * k + 1], 0, 1, 10, 11, 4, 5, 14, 15) +
               __builtin_shufflevector(pairs[2 * k], pairs[2 * k + 1], 2, 3, 8, 9, 6, 7, 12, 13);
  return __builtin_shufflevector(fours[0], fours[1], 0, 1, 2, 3, 12, 13, 14, 15) +
         __builtin_shufflevector(fours[0], fours[1], 4, 5, 6, 7, 8, 9, 10, 11);
}

namespace detail {
template <class Sums>
inline __attribute__((always_inline)) void add_at(const Sums& sums, double* out) {
  Sums at;
  __builtin_memcpy(&at, out, sizeof at);
  at += sums;
  __builtin_memcpy(out, &at, sizeof at);
}
}  // namespace detail

/// Adds the lane sums of `count` vectors to consecutive numbers.
template <int count, class Lane>
inline __attribute__((always_inline)) void add_lane_sums(const Lane* v, double* out) {
  constexpr int eights = sizeof(Lane) == 64 ? count / 8 * 8 : 0, fours = eights + (count - eights) / 4 * 4;
  if constexpr (eights > 0)
    for (int k = 0; k < eights; k += 8) detail::add_at(sums_of_eight(v + k), out + k);
  for (int k = eights; k < fours; k += 4) detail::add_at(sums_of_four(v + k), out + k);
  for (int k = fours; k < count; ++k) out[k] += sum_lanes(v[k]);
}

}  // namespace pf
