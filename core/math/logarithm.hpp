// The natural logarithm for one number or a pack, with the pieces that keep small strains exact.
#pragma once

#include "core/math/lanes.hpp"

namespace pf {

/// u = 2^exponent (1 + f), sqrt(1/2) <= 1 + f < sqrt(2), for positive normal u.
template <class T>
struct BinarySplit {
  T exponent, f;
};

template <class T>
BinarySplit<T> split_binary(const T& u) {
  using Bits = typename Lanes<T>::Bits;
  constexpr std::uint64_t sqrt_half = 0x3fe6a09e00000000, one = 0x3ff0000000000000, mantissa = 0x000fffffffffffff;
  constexpr std::uint64_t integer_at_zero = 0x4338000000000000 - 1023;  // the bits of 1.5 * 2^52, less the bias
  const Bits shifted = std::bit_cast<Bits>(u) + (one - sqrt_half);
  // An integer k becomes a double through the bits of 1.5 * 2^52 + k: there is no AVX2 instruction for it.
  const Bits k = (shifted >> 52) + integer_at_zero;
  const Bits m = (shifted & mantissa) + sqrt_half;
  return {std::bit_cast<T>(k) - 0x1.8p52, std::bit_cast<T>(m) - 1.0};
}

/// f - ln(1 + f) >= 0, to a few units in the last place relative to itself, for sqrt(1/2) - 1 <= f < sqrt(2) - 1
/// (the polynomial of fdlibm's log, Sun Microsystems 1993).
template <class T>
T log_excess(const T& f) {
  const T s = f / (2.0 + f), z = s * s, w = z * z;
  const T odd = z * (0.6666666666666735130 +
                     w * (0.2857142874366239149 + w * (0.1818357216161805012 + w * 0.1479819860511658591)));
  const T even = w * (0.3999999999940941908 + w * (0.2222219843214978396 + w * 0.1531383769920937332));
  const T half_square = 0.5 * f * f;
  return half_square - s * (half_square + (odd + even));
}

/// ln(2^exponent (1 + f)) given excess = log_excess(f); accurate to an ulp, and relative to f when exponent = 0.
template <class T>
T join_log(const BinarySplit<T>& split, const T& excess) {
  constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  return split.exponent * ln2_high + (split.f - (excess - split.exponent * ln2_low));
}

/// ln u for normal u > 0; NaN gives NaN, other u something unspecified and finite.
template <class T>
T log_of(const T& u) {
  const BinarySplit<T> split = split_binary(u);
  return select(u == u, join_log(split, log_excess(split.f)), u);
}

/// atanh(z)/z for -1 < z < 1, smooth through z = 0; relative error a few ulp.
template <class T>
T atanh_over(const T& z) {
  // 2 atanh(z) = ln(1 + f), f = 2 z / (1 - z). Below |z| = 0.1 the series of atanh(z)/z is shorter than a care for f.
  const T w = z * z, far = 0.5 * log_of((1.0 + z) / (1.0 - z)) / z;
  T series = broadcast<T>(1.0 / 17);
  for (int k = 15; k > 0; k -= 2) series = series * w + 1.0 / k;
  return select(w < 0.01, series, far);
}

}  // namespace pf
