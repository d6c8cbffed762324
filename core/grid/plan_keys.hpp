// Where a particle stands in the order that a plan sorts by.
#pragma once

#include <array>
#include <cstdint>

#include "core/grid/wide.hpp"

namespace pf {

/// Cells along each edge of a block.
inline constexpr int edge_bits = 2, block_edge = 1 << edge_bits;

/// The sort key packs, from the top: block (z, y, x), cell in the block (z, y, x), material.
template <int D>
struct PlanKeys {
  std::array<long long, D> origin{};  ///< lattice coordinate of block (0, 0, 0), a multiple of block_edge
  std::array<int, D> block_bits{};
  int material_bits = 0;
  int total_bits = 0;

  /// Of the cells `base`, a lane a particle, without the material; `outside` becomes something else than zero in the
  /// lanes that have no key.
  template <class Integers>
  Integers pack(const Integers* base, Integers& outside) const {
    Integers block{}, cell{};
    for (int a = D - 1; a >= 0; --a) {
      const auto k = static_cast<std::size_t>(a);
      const Integers r = base[a] - origin[k];
      outside |= r >> (block_bits[k] + edge_bits);  // of a negative number too
      block = block << block_bits[k] | r >> edge_bits;
      cell = cell << edge_bits | (r & (block_edge - 1));
    }
    return (block << (D * edge_bits) | cell) << material_bits;
  }
  std::uint64_t block_of(std::uint64_t key) const { return key >> (material_bits + D * edge_bits); }
  std::uint64_t cell_of(std::uint64_t key) const { return (key >> material_bits) & ((1u << (D * edge_bits)) - 1); }
  std::array<long long, D> corner(std::uint64_t block) const {
    std::array<long long, D> c{};
    for (std::size_t a = 0; a < D; ++a) {
      c[a] = origin[a] + (static_cast<long long>(block & ((1ull << block_bits[a]) - 1)) << edge_bits);
      block >>= block_bits[a];
    }
    return c;
  }
};

}  // namespace pf
