// Poisson-disc sampling (Bridson 2007): new points are tried at one to two least distances from those there are. A
// background grid, whose cells have the least distance as diagonal and so hold one point at most, tells the
// neighbours; a first dart into each of its cells finds every part of the body.
#include <algorithm>
#include <cmath>

#include "core/scene/sampling_lattice.hpp"
#include "core/scene/sampling_random.hpp"

namespace pf {
namespace {

using Index = ParticleLattice::Index;

constexpr int tries = 24;  ///< around each point before it counts as surrounded
/// Least distance over lattice spacing at which space is filled as densely as by the lattice (measured).
double distance_factor(int dimension) {
  return dimension == 2 ? 0.78 : 0.84;
}

/// Which point a cell holds: a hash table with open addressing, for nearly all the time is spent looking here.
class Owners {
 public:
  Owners() : slots_(1024) {}
  /// The number of the cell's point, or -1.
  std::int64_t find(const Index& cell) const {
    for (std::size_t at = start(cell);; at = next(at)) {
      if (slots_[at].point < 0) return -1;
      if (same(slots_[at].cell, cell)) return slots_[at].point;
    }
  }
  /// `cell` has no point yet.
  void add(const Index& cell, std::int64_t point) {
    if (2 * static_cast<std::size_t>(point) > slots_.size()) grow();
    std::size_t at = start(cell);
    while (slots_[at].point >= 0) at = next(at);
    slots_[at] = {cell, point};
  }

 private:
  struct Slot {
    Index cell{};
    std::int64_t point = -1;
  };
  // Three multiplications are enough to spread neighbours.
  std::size_t start(const Index& k) const {
    const auto u = [&](int a) { return static_cast<std::uint64_t>(k[static_cast<std::size_t>(a)]); };
    const std::uint64_t h = u(0) * 0x9e3779b97f4a7c15u + u(1) * 0xc2b2ae3d27d4eb4fu + u(2) * 0x165667b19e3779f9u;
    return static_cast<std::size_t>((h ^ (h >> 32)) & (slots_.size() - 1));
  }
  static bool same(const Index& a, const Index& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }
  std::size_t next(std::size_t at) const { return (at + 1) & (slots_.size() - 1); }
  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.point < 0) continue;
      std::size_t at = start(slot.cell);
      while (slots_[at].point >= 0) at = next(at);
      slots_[at] = slot;
    }
  }

  std::vector<Slot> slots_;
};

/// Offsets to the cells that may hold a point too near, the nearest first: most darts fail, and there they fail soon.
std::vector<Index> neighbours(int dimension) {
  const auto square = [](const Index& k) { return k[0] * k[0] + k[1] * k[1] + k[2] * k[2]; };
  const auto gap = [](std::int64_t i) { return std::max<std::int64_t>(0, std::abs(i) - 1); };
  std::vector<Index> list;
  const std::int64_t reach = 2, reach_z = dimension == 3 ? reach : 0;  // of the distance, in cells: ceil(sqrt(D))
  Index k{};
  for (k[2] = -reach_z; k[2] <= reach_z; ++k[2])
    for (k[1] = -reach; k[1] <= reach; ++k[1])
      for (k[0] = -reach; k[0] <= reach; ++k[0])
        if (square({gap(k[0]), gap(k[1]), gap(k[2])}) < dimension) list.push_back(k);
  std::ranges::stable_sort(list, {}, square);
  return list;
}

class Darts {
 public:
  Darts(const Solid& solid, const ParticleLattice& lattice, double distance, std::uint64_t seed)
      : solid_(solid),
        D_(lattice.dimension()),
        tolerance_(lattice.tolerance()),
        distance_(distance),
        size_(distance_ / std::sqrt(D_)),
        seed_(mix(seed)),
        neighbours_(neighbours(D_)) {}

  std::vector<Vec3> throw_all() {
    for (const Index& cell : cells()) {
      if (owners_.find(cell) >= 0) continue;
      Vec3 p = Vec3::Zero();
      for (int a = 0; a < D_; ++a) p[a] = (static_cast<double>(cell[a]) + draw()) * size_;
      if (add(p)) grow();
    }
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
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[mix(seed_ ^ i) % i]);
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

  double draw() { return uniform(mix(seed_ + drawn_++)); }

  /// Surrounds the newest point and all that come of it.
  void grow() {
    std::vector<std::size_t> open = {points_.size() - 1};
    while (!open.empty()) {
      const auto at = static_cast<std::size_t>(draw() * static_cast<double>(open.size()));
      bool surrounded = true;
      for (int i = 0; surrounded && i < tries; ++i) surrounded = !add(points_[open[at]] + step());
      if (surrounded) {
        open[at] = open.back();
        open.pop_back();
      } else {
        open.push_back(points_.size() - 1);
      }
    }
  }

  /// Uniform between one and two least distances; by rejection, which needs no function that differs by platform.
  Vec3 step() {
    for (;;) {
      Vec3 d = Vec3::Zero();
      for (int a = 0; a < D_; ++a) d[a] = 4 * draw() - 2;
      const double square = d.squaredNorm();
      if (square >= 1 && square < 4) return distance_ * d;
    }
  }

  /// True when p has become a point.
  bool add(const Vec3& p) {
    Index cell{};
    for (int a = 0; a < D_; ++a) cell[a] = static_cast<std::int64_t>(std::floor(p[a] / size_));
    if (!is_free(p, cell) || !solid_.contains(p, tolerance_)) return false;
    owners_.add(cell, static_cast<std::int64_t>(points_.size()));
    points_.push_back(p);
    return true;
  }

  bool is_free(const Vec3& p, const Index& cell) const {
    for (const Index& offset : neighbours_) {
      const auto found = owners_.find({cell[0] + offset[0], cell[1] + offset[1], cell[2] + offset[2]});
      if (found >= 0 && (points_[static_cast<std::size_t>(found)] - p).squaredNorm() < distance_ * distance_)
        return false;
    }
    return true;
  }

  const Solid& solid_;
  int D_;
  double tolerance_, distance_, size_;
  std::uint64_t seed_, drawn_ = 0;
  std::vector<Index> neighbours_;
  std::vector<Vec3> points_;
  Owners owners_;
};

}  // namespace

std::vector<Vec3> poisson_disc_points(const Solid& solid, const ParticleLattice& lattice, std::uint64_t seed) {
  const int D = lattice.dimension();
  const double wanted = solid.measure(lattice.spacing()) / lattice.cell_measure();
  double distance = distance_factor(D) * lattice.spacing();
  std::vector<Vec3> points = Darts(solid, lattice, distance, seed).throw_all();
  // Points crowd at a surface, which no point beyond holds off: small and thin bodies get too many.
  for (int i = 0; i < 2 && wanted >= 1 && !points.empty(); ++i) {
    const double ratio = static_cast<double>(points.size()) / wanted;
    if (std::abs(ratio - 1) < 0.02) break;
    distance *= std::clamp(std::pow(ratio, 1.0 / D), 0.5, 2.0);
    points = Darts(solid, lattice, distance, seed).throw_all();
  }
  return points;
}

}  // namespace pf
