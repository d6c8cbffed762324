// Long-vector operations cut into fixed pieces: the same bits for any number of threads.
#pragma once

#include <array>

#include "core/math/parallel.hpp"
#include "core/types.hpp"

namespace pf {

/// a.b, summed piece by piece in order.
inline double dot(Parallel& parallel, const Vector& a, const Vector& b) {
  constexpr int most = 64;  // pieces at a time
  const std::ptrdiff_t n = a.size();
  const int pieces = vector_pieces(n);
  double sum = 0;
  for (int first = 0; first < pieces; first += most) {
    std::array<double, most> sums;
    const int together = std::min(most, pieces - first);
    parallel(together, [&](int k) {
      const std::ptrdiff_t begin = (first + k) * vector_piece, count = std::min(vector_piece, n - begin);
      sums[static_cast<std::size_t>(k)] = a.segment(begin, count).dot(b.segment(begin, count));
    });
    for (int k = 0; k < together; ++k) sum += sums[static_cast<std::size_t>(k)];
  }
  return sum;
}

/// body(begin, count) over pieces of [0, n).
template <class Body>
void for_pieces(Parallel& parallel, std::ptrdiff_t n, Body&& body) {
  parallel(vector_pieces(n), [&](int k) {
    const std::ptrdiff_t begin = k * vector_piece;
    body(begin, std::min(vector_piece, n - begin));
  });
}

}  // namespace pf
