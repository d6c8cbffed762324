// Real numbers, one or eight at a time: the same formula is compiled for `double` and for a SIMD pack of particles.
#pragma once

#include <bit>
#include <cstdint>

namespace pf {

/// Eight doubles; element-wise + - * / and comparisons come with the compiler (GCC and clang vector extensions).
typedef double Pack __attribute__((vector_size(64)));
typedef std::int64_t PackBits __attribute__((vector_size(64)));

/// What is needed to write a formula once: the number of lanes, the integer of the same shape.
template <class T>
struct Lanes;
template <>
struct Lanes<double> {
  static constexpr int count = 1;
  using Bits = std::int64_t;
  static double get(const double& x, int) { return x; }
  static void set(double& x, int, double value) { x = value; }
};
template <>
struct Lanes<Pack> {
  static constexpr int count = 8;
  using Bits = PackBits;
  static double get(const Pack& x, int lane) { return x[lane]; }
  static void set(Pack& x, int lane, double value) { x[lane] = value; }
};

/// `condition ? a : b`, lane by lane; both sides are evaluated.
inline double select(bool condition, double a, double b) {
  return condition ? a : b;
}
inline Pack select(const PackBits& condition, const Pack& a, const Pack& b) {
  return condition ? a : b;
}

/// The same number in every lane.
template <class T>
T broadcast(double x) {
  return T{} + x;
}

inline double square_root(double x) {
  return __builtin_sqrt(x);
}
inline Pack square_root(const Pack& x) {
  Pack y{};
  for (int lane = 0; lane < 8; ++lane) y[lane] = __builtin_sqrt(x[lane]);
  return y;
}

}  // namespace pf
