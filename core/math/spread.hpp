// One number in every lane of a short vector, made as this machine does it best.
#pragma once

#include <cstddef>

namespace pf {

/// Bytes that one instruction works on. Longer vectors are taken apart by the compiler: well where they meet each
/// other, number by number (GCC 12) where they meet a single one or are converted.
#if defined(__AVX512F__)
inline constexpr std::size_t native_bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t native_bytes = 32;
#else
inline constexpr std::size_t native_bytes = 16;
#endif

/// The same number in every lane; `Lane` may be a single number.
template <class Lane>
inline __attribute__((always_inline)) Lane spread(double x) {
  if constexpr (sizeof(Lane) <= native_bytes) {
    return Lane{} + x;
  } else {
    Lane lanes;
    for (std::size_t k = 0; k < sizeof(Lane) / sizeof(double); ++k) lanes[k] = x;
    return lanes;
  }
}

}  // namespace pf
