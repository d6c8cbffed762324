#include "core/scene/sampling_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/sampling_random.hpp"
#include "core/scene/sampling_visit.hpp"

namespace pf {
namespace {

using Index = ParticleLattice::Index;

struct Found {
  Index k;
  Vec3 X;
};

std::vector<Vec3> in_order(std::vector<Found> found) {
  std::ranges::sort(found, {}, [](const Found& f) { return std::array{f.k[2], f.k[1], f.k[0]}; });
  std::vector<Vec3> points;
  points.reserve(found.size());
  for (const Found& f : found) points.push_back(f.X);
  return points;
}

}  // namespace

ParticleLattice::ParticleLattice(double grid_spacing, int per_axis, int dimension, const Bounds& bounds)
    : grid_spacing_(grid_spacing), per_axis_(per_axis), spacing_(grid_spacing / per_axis), dimension_(dimension) {
  for (int a = 0; a < dimension; ++a) {
    // A point k + 1/2 within [min, max]; the tolerance may admit one more at either end.
    const double low = std::ceil(bounds.min[a] / spacing_ - 0.5 - 1e-6);
    const double high = std::floor(bounds.max[a] / spacing_ - 0.5 + 1e-6);
    representable_ = representable_ && std::abs(low) < 1e15 && std::abs(high) < 1e15;
    if (!representable_) return;
    first_[a] = static_cast<std::int64_t>(low);
    last_[a] = static_cast<std::int64_t>(high);
  }
}

double ParticleLattice::cell_measure() const {
  return std::pow(spacing_, dimension_);
}

Vec3 ParticleLattice::at(const Vec3& coordinates) const {
  Vec3 p = Vec3::Zero();
  for (int a = 0; a < dimension_; ++a) p[a] = coordinates[a] * grid_spacing_ / per_axis_;
  return p;
}

std::vector<Vec3> lattice_points(const Solid& solid, const ParticleLattice& lattice) {
  std::vector<Found> found;
  visit_cells(solid, lattice, lattice.first(), lattice.last(), [&](const Index& k) {
    const Vec3 X = lattice.point(k);
    if (solid.contains(X, lattice.tolerance())) found.push_back({k, X});
  });
  return in_order(std::move(found));
}

std::vector<Vec3> jittered_points(const Solid& solid, const ParticleLattice& lattice, std::uint64_t seed) {
  Index first = lattice.first(), last = lattice.last();
  for (int a = 0; a < lattice.dimension(); ++a) {  // cells whose middle lies outside may hold a point inside
    --first[a];
    ++last[a];
  }
  std::vector<Found> found;
  visit_cells(solid, lattice, first, last, [&](const Index& k) {
    std::uint64_t state = mix(seed);
    for (const std::int64_t index : k) state = mix(state ^ static_cast<std::uint64_t>(index));
    Vec3 coordinates;
    for (int a = 0; a < 3; ++a)
      coordinates[a] = static_cast<double>(k[a]) + uniform(mix(state + static_cast<std::uint64_t>(a)));
    const Vec3 X = lattice.at(coordinates);
    if (solid.contains(X, lattice.tolerance())) found.push_back({k, X});
  });
  return in_order(std::move(found));
}

}  // namespace pf
