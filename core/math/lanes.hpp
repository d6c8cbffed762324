// Real numbers, one or eight at a time: the same formula is compiled for `double` and for a SIMD pack of particles.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace pf {

/// Eight doubles; element-wise + - * / and comparisons come with the compiler (GCC and clang vector extensions).
typedef double Pack __attribute__((vector_size(64)));
typedef std::int64_t PackMask __attribute__((vector_size(64)));  ///< of a comparison: -1 true, 0 false
typedef std::uint64_t PackBits __attribute__((vector_size(64)));

/// What is needed to write a formula once: the number of lanes, the integer of the same shape.
template <class T>
struct Lanes;
template <>
struct Lanes<double> {
  static constexpr int count = 1;
  using Bits = std::uint64_t;
};
template <>
struct Lanes<Pack> {
  static constexpr int count = 8;
  using Bits = PackBits;
};

/// `condition ? a : b`, lane by lane; both sides are evaluated.
inline double select(bool condition, double a, double b) {
  return condition ? a : b;
}
inline Pack select(const PackMask& condition, const Pack& a, const Pack& b) {
  return condition ? a : b;
}

/// The same number in every lane.
template <class T>
T broadcast(double x) {
  return T{} + x;
}

inline bool any(bool condition) {
  return condition;
}
inline bool any(const PackMask& condition) {
  std::int64_t all = 0;
  for (int lane = 0; lane < 8; ++lane) all |= condition[lane];
  return all != 0;
}

inline double absolute(double x) {
  return __builtin_fabs(x);
}
inline Pack absolute(const Pack& x) {
  return std::bit_cast<Pack>(std::bit_cast<PackBits>(x) & std::uint64_t{0x7fffffffffffffff});
}

inline double square_root(double x) {
  return __builtin_sqrt(x);
}
inline Pack square_root(const Pack& x) {
  Pack y{};
  for (int lane = 0; lane < 8; ++lane) y[lane] = __builtin_sqrt(x[lane]);
  return y;
}

/// packs[k] = entry k of eight records of `size` doubles, that lie one after the other.
template <int size>
void load_records(const double* records, Pack* packs);
/// The reverse of load_records.
template <int size>
void store_records(const Pack* packs, double* records);

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

template <int size>
void load_records(const double* records, Pack* packs) {
  constexpr int whole = size / 8 * 8;
  for (int k = 0; k < whole; k += 8) {
    Pack block[8];
    for (int lane = 0; lane < 8; ++lane) std::memcpy(&block[lane], records + lane * size + k, sizeof(Pack));
    detail::transpose_block(block);
    for (int n = 0; n < 8; ++n) packs[k + n] = block[n];
  }
  for (int k = whole; k < size; ++k)
    for (int lane = 0; lane < 8; ++lane) packs[k][lane] = records[lane * size + k];
}

template <int size>
void store_records(const Pack* packs, double* records) {
  constexpr int whole = size / 8 * 8;
  for (int k = 0; k < whole; k += 8) {
    Pack block[8];
    for (int n = 0; n < 8; ++n) block[n] = packs[k + n];
    detail::transpose_block(block);
    for (int lane = 0; lane < 8; ++lane) std::memcpy(records + lane * size + k, &block[lane], sizeof(Pack));
  }
  for (int k = whole; k < size; ++k)
    for (int lane = 0; lane < 8; ++lane) records[lane * size + k] = packs[k][lane];
}

}  // namespace pf
