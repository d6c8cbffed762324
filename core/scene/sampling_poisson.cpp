// Poisson-disc sampling (Bridson 2007): new points are tried at one to two least distances from those there are. A
// background grid, whose cells have the least distance as diagonal and so hold one point at most, tells the
// neighbours; a first dart into each of its cells finds every part of the body.
#include <algorithm>
#include <cmath>

#include "core/scene/sampling_cells.hpp"
#include "core/scene/sampling_lattice.hpp"
#include "core/scene/sampling_random.hpp"

namespace pf {
namespace {

using Index = CellOwners::Index;

constexpr int tries = 24;  ///< around each point before it counts as surrounded
/// Least distance over lattice spacing at which space is filled as densely as by the lattice (measured).
double distance_factor(int dimension) {
  return dimension == 2 ? 0.78 : 0.84;
}

/// Offsets to the cells that may hold a point too near, the nearest first: most darts fail, and there they fail soon.
std::vector<Index> neighbours(int dimension) {
  const auto square = [](const Index& k) { return k[0] * k[0] + k[1] * k[1] + k[2] * k[2]; };
  const auto gap = [](std::int64_t i) { return std::max<std::int64_t>(0, std::abs(i) - 1); };
  std::vector<Index> list;
  const std::int64_t reach = CellOwners::window, reach_z = dimension == 3 ? reach : 0;  // ceil(sqrt(D)) cells
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

  /// Surrounds the newest point and all that come of it, the newest first: what it looks at stays near.
  void grow() {
    std::vector<std::size_t> open = {points_.size() - 1};
    while (!open.empty()) {
      const Vec3 center = points_[open.back()];
      bool surrounded = true;
      for (int i = 0; surrounded && i < tries; ++i) surrounded = !add(center + step());
      if (surrounded) {
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
    owners_.add(cell, static_cast<std::int32_t>(points_.size()));
    points_.push_back(p);
    return true;
  }

  bool is_free(const Vec3& p, const Index& cell) const {
    const auto blocks = owners_.around(cell, D_);
    const Index first = CellOwners::block_of(
        {cell[0] - CellOwners::window, cell[1] - CellOwners::window, D_ == 3 ? cell[2] - CellOwners::window : 0});
    for (const Index& offset : neighbours_) {
      const Index k = {cell[0] + offset[0], cell[1] + offset[1], cell[2] + offset[2]};
      const Index b = CellOwners::block_of(k);
      const CellOwners::Block* block =
          blocks[static_cast<std::size_t>((b[0] - first[0]) + 2 * (b[1] - first[1]) + 4 * (b[2] - first[2]))];
      const std::int32_t owner = block ? (*block)[CellOwners::place(k)] : -1;
      if (owner >= 0 && (points_[static_cast<std::size_t>(owner)] - p).squaredNorm() < distance_ * distance_)
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
  CellOwners owners_;
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
