// Short vectors of doubles, one particle a lane, by the compilers' vector extension: the same source for SSE,
// AVX2, AVX-512 and NEON.
#pragma once

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

/// Sum over the lanes, always in the same order.
inline double sum_lanes(const Wide<4>& v) {
  return (v[0] + v[2]) + (v[1] + v[3]);
}
inline double sum_lanes(const Wide<8>& v) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

/// Adds the lane sums of `count` vectors to consecutive numbers, four at a time: transposing while adding takes a third
/// of the shuffles that single sums take.
inline Wide<4> halve(const Wide<4>& v) {
  return v;
}
inline Wide<4> halve(const Wide<8>& v) {
  return __builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7);
}
inline Wide<4> sum_four(const Wide<4>& a, const Wide<4>& b, const Wide<4>& c, const Wide<4>& d) {
  const Wide<4> ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Wide<4> cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}
template <int count, class Lane>
inline __attribute__((always_inline)) void add_lane_sums(const Lane* v, double* out) {
  int k = 0;
  for (; k + 4 <= count; k += 4) {
    const Wide<4> sums = sum_four(halve(v[k]), halve(v[k + 1]), halve(v[k + 2]), halve(v[k + 3]));
    Wide<4> at;
    __builtin_memcpy(&at, out + k, sizeof at);
    at += sums;
    __builtin_memcpy(out + k, &at, sizeof at);
  }
  for (; k < count; ++k) out[k] += sum_lanes(v[k]);
}

}  // namespace pf
