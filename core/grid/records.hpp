// Particles' vectors and matrices in and out of lanes: one particle a record in memory, one a lane in arithmetic.
#pragma once

#include <cstdint>
#include <cstring>

#include "core/grid/wide.hpp"
#include "core/math/lanes.hpp"
#include "core/types.hpp"

namespace pf {

namespace detail {

/// As many whole records as there are lanes.
template <int size>
inline void load_whole(const double* from, Wide<8>* lanes) {
  if constexpr (size == 3) {
    Wide<8> x[3];
    std::memcpy(x, from, sizeof x);
    lanes[0] = __builtin_shufflevector(__builtin_shufflevector(x[0], x[1], 0, 3, 6, 9, 12, 15, 0, 0), x[2], 0, 1, 2, 3,
                                       4, 5, 10, 13);
    lanes[1] = __builtin_shufflevector(__builtin_shufflevector(x[0], x[1], 1, 4, 7, 10, 13, 0, 0, 0), x[2], 0, 1, 2, 3,
                                       4, 8, 11, 14);
    lanes[2] = __builtin_shufflevector(__builtin_shufflevector(x[0], x[1], 2, 5, 8, 11, 14, 0, 0, 0), x[2], 0, 1, 2, 3,
                                       4, 9, 12, 15);
  } else {
    load_records<size>(from, lanes);
  }
}
template <int size>
inline void store_whole(const Wide<8>* lanes, double* to) {
  if constexpr (size == 3) {
    // xy: the first eight of x0 y0 x1 y1 ..., and so on; z goes in between.
    const Wide<8> low = __builtin_shufflevector(lanes[0], lanes[1], 0, 8, 0, 1, 9, 0, 2, 10);
    const Wide<8> middle = __builtin_shufflevector(lanes[0], lanes[1], 0, 3, 11, 0, 4, 12, 0, 5);
    const Wide<8> high = __builtin_shufflevector(lanes[0], lanes[1], 13, 0, 6, 14, 0, 7, 15, 0);
    const Wide<8> x[3] = {__builtin_shufflevector(low, lanes[2], 0, 1, 8, 3, 4, 9, 6, 7),
                          __builtin_shufflevector(middle, lanes[2], 10, 1, 2, 11, 4, 5, 12, 7),
                          __builtin_shufflevector(high, lanes[2], 0, 13, 2, 3, 14, 5, 6, 15)};
    std::memcpy(to, x, sizeof x);
  } else {
    store_records<size>(lanes, to);
  }
}
template <int size>
inline void load_whole(const double* from, Wide<4>* lanes) {
  Wide<4> x[size];
  std::memcpy(x, from, sizeof x);
  if constexpr (size == 2) {
    lanes[0] = __builtin_shufflevector(x[0], x[1], 0, 2, 4, 6);
    lanes[1] = __builtin_shufflevector(x[0], x[1], 1, 3, 5, 7);
  } else {
    static_assert(size == 4);
    const Wide<4> a = __builtin_shufflevector(x[0], x[1], 0, 4, 2, 6),
                  b = __builtin_shufflevector(x[0], x[1], 1, 5, 3, 7);
    const Wide<4> c = __builtin_shufflevector(x[2], x[3], 0, 4, 2, 6),
                  d = __builtin_shufflevector(x[2], x[3], 1, 5, 3, 7);
    lanes[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    lanes[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    lanes[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    lanes[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
  }
}
template <int size>
inline void store_whole(const Wide<4>* lanes, double* to) {
  Wide<4> x[size];
  if constexpr (size == 2) {
    x[0] = __builtin_shufflevector(lanes[0], lanes[1], 0, 4, 1, 5);
    x[1] = __builtin_shufflevector(lanes[0], lanes[1], 2, 6, 3, 7);
  } else {
    // A 4 x 4 transposition is its own reverse.
    double flat[16];
    std::memcpy(flat, lanes, sizeof flat);
    load_whole<4>(flat, x);
  }
  std::memcpy(to, x, sizeof x);
}

}  // namespace detail

/// lanes[k] = entry k of `count` records of `size` doubles; 0 in the lanes beyond.
template <int size, class Lane>
inline void load_lanes(const double* records, int count, Lane* lanes) {
  constexpr int width = sizeof(Lane) / sizeof(double);
  if (count == width) return detail::load_whole<size>(records, lanes);
  double some[width * size] = {};
  std::memcpy(some, records, sizeof(double) * static_cast<std::size_t>(count * size));
  detail::load_whole<size>(some, lanes);
}
/// The reverse, of `count` records.
template <int size, class Lane>
inline void store_lanes(const Lane* lanes, int count, double* records) {
  constexpr int width = sizeof(Lane) / sizeof(double);
  if (count == width) return detail::store_whole<size>(lanes, records);
  double some[width * size];
  detail::store_whole<size>(lanes, some);
  std::memcpy(records, some, sizeof(double) * static_cast<std::size_t>(count * size));
}

/// The record of lane k goes to `records` + size place[k]; to + size k where `place` is null.
template <int size, class Lane>
inline void store_lanes_at(const Lane* lanes, int count, const std::uint32_t* place, double* records) {
  if (!place) return store_lanes<size>(lanes, count, records);
  bool together = true;
  for (int lane = 1; lane < count; ++lane) together = together && place[lane] == place[0] + static_cast<unsigned>(lane);
  if (together) return store_lanes<size>(lanes, count, records + static_cast<std::size_t>(place[0]) * size);
  constexpr int width = sizeof(Lane) / sizeof(double);
  double some[width * size];
  detail::store_whole<size>(lanes, some);
  for (int lane = 0; lane < count; ++lane)
    std::memcpy(records + static_cast<std::size_t>(place[lane]) * size, some + lane * size, sizeof(double) * size);
}

/// One number a particle.
template <class Lane>
inline Lane load_lane(const double* values, int count) {
  Lane lane{};
  std::memcpy(&lane, values, sizeof(double) * static_cast<std::size_t>(count));
  return lane;
}

/// C = A B of D x D matrices in lanes, column-major as in Eigen.
template <int D, class Lane>
inline void multiply_lanes(const Lane* A, const Lane* B, Lane* C) {
  for (int b = 0; b < D; ++b)
    for (int a = 0; a < D; ++a) {
      Lane sum = A[a] * B[D * b];
      for (int k = 1; k < D; ++k) sum += A[a + D * k] * B[k + D * b];
      C[a + D * b] = sum;
    }
}

}  // namespace pf
