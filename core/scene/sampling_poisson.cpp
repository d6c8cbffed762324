// Poisson-disc sampling by dart throwing into the cells of a background grid (after Bridson 2007 and Ebeida et al.
// 2012): a cell's diagonal is the least distance, so it holds one point at most; cells still empty get a new dart
// each round until hardly any room is left.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/scene/sampling_lattice.hpp"
#include "core/scene/sampling_random.hpp"

namespace pf {
namespace {

using Index = ParticleLattice::Index;

constexpr int rounds = 24;
/// Least distance over lattice spacing at which `rounds` give as many points as the lattice has (measured).
double distance_factor(int dimension) {
  return dimension == 2 ? 0.81 : 0.86;
}

struct IndexHash {
  std::size_t operator()(const Index& k) const {
    std::uint64_t h = 0;
    for (const std::int64_t i : k) h = mix(h ^ static_cast<std::uint64_t>(i));
    return h;
  }
};

class Darts {
 public:
  Darts(const Solid& solid, const ParticleLattice& lattice, std::uint64_t seed)
      : solid_(solid),
        D_(lattice.dimension()),
        tolerance_(lattice.tolerance()),
        distance_(distance_factor(D_) * lattice.spacing()),
        size_(distance_ / std::sqrt(D_)),
        seed_(mix(seed)) {}

  std::vector<Vec3> throw_all() {
    std::vector<Index> empty = cells();
    for (std::uint64_t round = 0; round < rounds && !empty.empty(); ++round)
      std::erase_if(empty, [&](const Index& cell) { return throw_one(cell, round); });
    return std::move(points_);
  }

 private:
  /// Cells that the solid may reach, shuffled.
  std::vector<Index> cells() const {
    const Bounds b = solid_.bounds();
    Index first{}, last{};
    for (int a = 0; a < D_; ++a) {
      first[a] = static_cast<std::int64_t>(std::floor(b.min[a] / size_));
      last[a] = static_cast<std::int64_t>(std::floor(b.max[a] / size_));
    }
    std::vector<Index> list;
    add_cells(first, last, list);
    const IndexHash hash;
    std::ranges::sort(list, {}, [&](const Index& cell) { return std::pair(mix(hash(cell) ^ seed_), cell); });
    return list;
  }

  void add_cells(const Index& first, const Index& last, std::vector<Index>& list) const {
    int longest = 0;
    Vec3 extent = Vec3::Zero(), middle = Vec3::Zero();
    for (int a = 0; a < D_; ++a) {
      if (last[a] - first[a] > last[longest] - first[longest]) longest = a;
      extent[a] = static_cast<double>(last[a] - first[a] + 1) * size_;
      middle[a] = static_cast<double>(first[a]) * size_ + 0.5 * extent[a];
    }
    if (solid_.distance_is_bound() && solid_.distance(middle) > 0.5 * extent.norm() + tolerance_) return;
    if (first == last) {
      list.push_back(first);
      return;
    }
    Index low = last, high = first;
    low[longest] = first[longest] + (last[longest] - first[longest]) / 2;
    high[longest] = low[longest] + 1;
    add_cells(first, low, list);
    add_cells(high, last, list);
  }

  /// True when the cell has its point now.
  bool throw_one(const Index& cell, std::uint64_t round) {
    const std::uint64_t state = mix(seed_ + mix(IndexHash{}(cell) + round));
    Vec3 p = Vec3::Zero();
    for (int a = 0; a < D_; ++a)
      p[a] = (static_cast<double>(cell[a]) + uniform(mix(state + static_cast<std::uint64_t>(a)))) * size_;
    if (!solid_.contains(p, tolerance_) || !is_free(p, cell)) return false;
    owner_.emplace(cell, points_.size());
    points_.push_back(p);
    return true;
  }

  bool is_free(const Vec3& p, const Index& cell) const {
    Index k{};
    const std::int64_t reach = 2, reach_z = D_ == 3 ? reach : 0;  // ceil(sqrt(3)): the distance in cells
    for (k[2] = cell[2] - reach_z; k[2] <= cell[2] + reach_z; ++k[2])
      for (k[1] = cell[1] - reach; k[1] <= cell[1] + reach; ++k[1])
        for (k[0] = cell[0] - reach; k[0] <= cell[0] + reach; ++k[0]) {
          const auto found = owner_.find(k);
          if (found != owner_.end() && (points_[found->second] - p).squaredNorm() < distance_ * distance_) return false;
        }
    return true;
  }

  const Solid& solid_;
  int D_;
  double tolerance_, distance_, size_;
  std::uint64_t seed_;
  std::vector<Vec3> points_;
  std::unordered_map<Index, std::size_t, IndexHash> owner_;
};

}  // namespace

std::vector<Vec3> poisson_disc_points(const Solid& solid, const ParticleLattice& lattice, std::uint64_t seed) {
  return Darts(solid, lattice, seed).throw_all();
}

}  // namespace pf
