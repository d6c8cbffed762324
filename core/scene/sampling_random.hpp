// Random numbers by counting: the value depends on (seed, where, which), on nothing drawn before.
#pragma once

#include <cstdint>

namespace pf {

/// Mixes all bits (the finaliser of splitmix64; Steele, Lea and Flood 2014).
constexpr std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Uniform in [0, 1).
constexpr double uniform(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace pf
