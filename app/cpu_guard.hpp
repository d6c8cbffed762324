// Which instruction sets the program was compiled for: bits of `pushforward_needs`, checked by cpu_guard.cpp.
#pragma once

// F(bit, name as __builtin_cpu_supports knows it)
#define PUSHFORWARD_CPU_FEATURES(F) \
  F(0, "sse3")                      \
  F(1, "ssse3")                     \
  F(2, "sse4.1")                    \
  F(3, "sse4.2")                    \
  F(4, "popcnt")                    \
  F(5, "avx")                       \
  F(6, "avx2")                      \
  F(7, "fma")                       \
  F(8, "bmi")                       \
  F(9, "bmi2")                      \
  F(10, "avx512f")                  \
  F(11, "avx512cd")                 \
  F(12, "avx512bw")                 \
  F(13, "avx512dq")                 \
  F(14, "avx512vl")                 \
  F(15, "avx512vbmi")               \
  F(16, "avx512ifma")               \
  F(17, "avx512vnni")               \
  F(18, "avx512bitalg")             \
  F(19, "avx512vpopcntdq")          \
  F(20, "avx512vbmi2")              \
  F(21, "gfni")                     \
  F(22, "vpclmulqdq")

namespace pf::app {

/// The features that the including file is compiled for.
constexpr unsigned compiled_features() {
  unsigned needs = 0;
#ifdef __SSE3__
  needs |= 1u << 0;
#endif
#ifdef __SSSE3__
  needs |= 1u << 1;
#endif
#ifdef __SSE4_1__
  needs |= 1u << 2;
#endif
#ifdef __SSE4_2__
  needs |= 1u << 3;
#endif
#ifdef __POPCNT__
  needs |= 1u << 4;
#endif
#ifdef __AVX__
  needs |= 1u << 5;
#endif
#ifdef __AVX2__
  needs |= 1u << 6;
#endif
#ifdef __FMA__
  needs |= 1u << 7;
#endif
#ifdef __BMI__
  needs |= 1u << 8;
#endif
#ifdef __BMI2__
  needs |= 1u << 9;
#endif
#ifdef __AVX512F__
  needs |= 1u << 10;
#endif
#ifdef __AVX512CD__
  needs |= 1u << 11;
#endif
#ifdef __AVX512BW__
  needs |= 1u << 12;
#endif
#ifdef __AVX512DQ__
  needs |= 1u << 13;
#endif
#ifdef __AVX512VL__
  needs |= 1u << 14;
#endif
#ifdef __AVX512VBMI__
  needs |= 1u << 15;
#endif
#ifdef __AVX512IFMA__
  needs |= 1u << 16;
#endif
#ifdef __AVX512VNNI__
  needs |= 1u << 17;
#endif
#ifdef __AVX512BITALG__
  needs |= 1u << 18;
#endif
#ifdef __AVX512VPOPCNTDQ__
  needs |= 1u << 19;
#endif
#ifdef __AVX512VBMI2__
  needs |= 1u << 20;
#endif
#ifdef __GFNI__
  needs |= 1u << 21;
#endif
#ifdef __VPCLMULQDQ__
  needs |= 1u << 22;
#endif
  return needs;
}

}  // namespace pf::app
