// The background grid of Poisson-disc sampling.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pf {

/// Which point each cell holds, in blocks of 4 x 4 (x 4) cells found by a hash table: memory follows the body, and
/// cells next to each other lie next to each other.
class CellOwners {
 public:
  using Index = std::array<std::int64_t, 3>;
  static constexpr int side = 4, window = 2;  ///< a window of two cells either way meets two blocks a direction
  using Block = std::array<std::int32_t, side * side * side>;

  CellOwners() : slots_(1024) {}

  /// The blocks around `cell`, nullptr where nothing has been added yet: block (i, j, k) of the 2 x 2 (x 2) that the
  /// window meets is number i + 2 j + 4 k.
  std::array<const Block*, 8> around(const Index& cell, int dimension) const {
    std::array<const Block*, 8> list{};
    const Index first = block_of({cell[0] - window, cell[1] - window, dimension == 3 ? cell[2] - window : 0});
    for (std::size_t b = 0; b < (std::size_t{1} << dimension); ++b) {
      const std::int64_t at =
          find({first[0] + (b & 1 ? 1 : 0), first[1] + (b & 2 ? 1 : 0), first[2] + (b & 4 ? 1 : 0)});
      if (at >= 0) list[b] = &blocks_[static_cast<std::size_t>(at)];
    }
    return list;
  }

  /// The cell has no point yet.
  void add(const Index& cell, std::int32_t point) {
    const Index key = block_of(cell);
    std::int64_t at = find(key);
    if (at < 0) at = add_block(key);
    blocks_[static_cast<std::size_t>(at)][place(cell)] = point;
  }

  static Index block_of(const Index& cell) { return {cell[0] >> 2, cell[1] >> 2, cell[2] >> 2}; }
  static std::size_t place(const Index& cell) {
    return static_cast<std::size_t>((cell[0] & 3) + side * (cell[1] & 3) + side * side * (cell[2] & 3));
  }

 private:
  struct Slot {
    Index key{};
    std::int64_t block = -1;
  };

  std::int64_t find(const Index& key) const {
    std::size_t at = start(key);
    while (slots_[at].block >= 0 && !same(slots_[at].key, key)) at = next(at);
    return slots_[at].block;
  }
  std::int64_t add_block(const Index& key) {
    if (2 * blocks_.size() > slots_.size()) grow();
    const Slot slot{key, static_cast<std::int64_t>(blocks_.size())};
    blocks_.emplace_back().fill(-1);
    insert(slot);
    return slot.block;
  }
  void insert(const Slot& slot) {
    std::size_t at = start(slot.key);
    while (slots_[at].block >= 0) at = next(at);
    slots_[at] = slot;
  }
  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.block >= 0) insert(slot);
  }
  // Three multiplications are enough to spread neighbours.
  std::size_t start(const Index& k) const {
    const auto u = [&](std::size_t a) { return static_cast<std::uint64_t>(k[a]); };
    const std::uint64_t h = u(0) * 0x9e3779b97f4a7c15u + u(1) * 0xc2b2ae3d27d4eb4fu + u(2) * 0x165667b19e3779f9u;
    return static_cast<std::size_t>((h ^ (h >> 32)) & (slots_.size() - 1));
  }
  std::size_t next(std::size_t at) const { return (at + 1) & (slots_.size() - 1); }
  static bool same(const Index& a, const Index& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

  std::vector<Slot> slots_;
  std::vector<Block> blocks_;
};

}  // namespace pf
