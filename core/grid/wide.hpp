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
inline double sum_lanes(const Wide<4>& v) { return (v[0] + v[2]) + (v[1] + v[3]); }
inline double sum_lanes(const Wide<8>& v) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

}  // namespace pf
