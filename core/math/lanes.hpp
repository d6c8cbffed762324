// Real numbers, one or eight at a time: the same formula is compiled for `double` and for a SIMD pack of
// particles.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "core/math/spread.hpp"

namespace pf {

/// Eight doubles; element-wise + - * / and comparisons come with the compiler (GCC and clang vector
/// extensions).
using Pack = double __attribute__((vector_size(64)));

/// What is needed to write a formula once: the number of lanes, the integers of the same shape.
template <class T>
struct Lanes;
template <>
struct Lanes<double> {
  static constexpr int count = 1;
  using Bits = std::uint64_t;
  using Mask = bool;
};
template <>
struct Lanes<Pack> {
  static constexpr int count = 8;
  using Bits = std::uint64_t __attribute__((vector_size(64)));
  using Mask = std::int64_t __attribute__((vector_size(64)));  ///< of a comparison: -1 true, 0 false
};
/// `condition ? a : b`, lane by lane; both sides are evaluated.
template <class T>
T select(const typename Lanes<T>::Mask& condition, const T& a, const T& b) {
  return condition ? a : b;
}

/// The same number in every lane.
template <class T>
T broadcast(double x) {
  return spread<T>(x);
}

/// Whether a comparison holds in any lane.
inline bool any(bool condition) {
  return condition;
}
template <class Mask>
requires(!std::is_same_v<Mask, bool>) bool any(const Mask& condition) {
  std::int64_t all = 0;
  for (std::size_t lane = 0; lane < sizeof(Mask) / 8; ++lane) all |= condition[lane];
  return all != 0;
}

template <class T>
T absolute(const T& x) {
  using Bits = typename Lanes<T>::Bits;
  return std::bit_cast<T>(std::bit_cast<Bits>(x) & std::uint64_t{0x7fffffffffffffff});
}

inline double square_root(double x) {
  return __builtin_sqrt(x);
}
template <class T>
requires(Lanes<T>::count > 1) T square_root(const T& x) {
  T y{};
  for (int lane = 0; lane < Lanes<T>::count; ++lane) y[lane] = __builtin_sqrt(x[lane]);
  return y;
}

/// packs[k] = entry k of as many records of `size` doubles, one after the other in memory, as the pack has lanes.
template <int size, class T>
void load_records(const double* records, T* packs);
/// The reverse of load_records.
template <int size, class T>
void store_records(const T* packs, double* records);

namespace detail {

/// Rows and columns of an 8 x 8 block exchanged.
inline void transpose_block(Pack (&x)[8]) {
  Pack y[8];
  for (int k = 0; k < 4; ++k) {  // pairs of single numbers
    y[2 * k] = __builtin_shufflevector(x[2 * k], x[2 * k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    y[2 * k + 1] = __builtin_shufflevector(x[2 * k], x[2 * k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int k = 0; k < 2; ++k) {  // pairs of twos
    for (int n = 0; n < 2; ++n) {
      x[4 * k + n] = __builtin_shufflevector(y[4 * k + n], y[4 * k + n + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      x[4 * k + n + 2] = __builtin_shufflevector(y[4 * k + n], y[4 * k + n + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (int n = 0; n < 4; ++n) {  // pairs of fours
    const Pack low = __builtin_shufflevector(x[n], x[n + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    x[n + 4] = __builtin_shufflevector(x[n], x[n + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    x[n] = low;
  }
}

}  // namespace detail

template <int size, class T>
void load_records(const double* records, T* packs) {
  constexpr int width = Lanes<T>::count, whole = size / width * width;
  for (int k = 0; k < whole; k += width) {
    T block[width];
    for (int lane = 0; lane < width; ++lane) std::memcpy(&block[lane], records + lane * size + k, sizeof(T));
    detail::transpose_block(block);
    for (int n = 0; n < width; ++n) packs[k + n] = block[n];
  }
  for (int k = whole; k < size; ++k)
    for (int lane = 0; lane < width; ++lane) packs[k][lane] = records[lane * size + k];
}

template <int size, class T>
void store_records(const T* packs, double* records) {
  constexpr int width = Lanes<T>::count, whole = size / width * width;
  for (int k = 0; k < whole; k += width) {
    T block[width];
    for (int n = 0; n < width; ++n) block[n] = packs[k + n];
    detail::transpose_block(block);
    for (int lane = 0; lane < width; ++lane) std::memcpy(records + lane * size + k, &block[lane], sizeof(T));
  }
  for (int k = whole; k < size; ++k)
    for (int lane = 0; lane < width; ++lane) records[lane * size + k] = packs[k][lane];
}

}  // namespace pf
