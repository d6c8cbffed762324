#include "core/scene/sampling_fitted.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/scene/sampling_visit.hpp"
#include "core/scene/shapes/cells.hpp"
#include "core/scene/shapes/shape_solid.hpp"

namespace pf {
namespace {

using Index = ParticleLattice::Index;

/// A cell is looked at in so many pieces along an axis.
constexpr int pieces_across = 8;
constexpr double least_part = 0.25;
/// What is fuller than 1 - this is whole, what is emptier than this is not there: rounding of faces on the lattice.
constexpr double rounding = 1e-7;

struct Part {
  Index k{};
  Moments moments;  ///< about the cell's middle
  double fill = 0;
  bool given_away = false;
};

bool before(const Index& a, const Index& b) {
  return std::array{a[2], a[1], a[0]} < std::array{b[2], b[1], b[0]};
}

Moments part_of(const Solid& solid, const ParticleLattice& lattice, const Index& k) {
  const Vec3 middle = lattice.point(k);
  Vec3 half = Vec3::Zero();
  for (int a = 0; a < lattice.dimension(); ++a) half[a] = 0.5 * lattice.spacing();
  // Closed sets: a cell whose corners lie on the surface is inside.
  const auto value = [&](const Vec3& p) { return solid.distance(middle + p) - lattice.tolerance(); };
  const LevelSet set{value, nullptr, solid.distance_is_bound(), {-half, half}, lattice.dimension()};
  return inside_moments(set, pieces_across);
}

std::vector<Part> parts_of(const Solid& solid, const ParticleLattice& lattice) {
  Index first = lattice.first(), last = lattice.last();
  for (int a = 0; a < lattice.dimension(); ++a) --first[a], ++last[a];
  std::vector<Part> parts;
  visit_cells(solid, lattice, first, last, [&](const Index& k) {
    Part part{k, part_of(solid, lattice, k)};
    part.fill = part.moments.measure / lattice.cell_measure();
    if (part.fill > rounding) parts.push_back(std::move(part));
  });
  std::ranges::sort(parts, before, &Part::k);
  return parts;
}

Part* find(std::vector<Part>& parts, const Index& k) {
  const auto at = std::ranges::lower_bound(parts, k, before, &Part::k);
  return at != parts.end() && at->k == k ? &*at : nullptr;
}

/// Of the neighbours across a face the fullest that is not small itself.
Part* heir_of(const Part& part, std::vector<Part>& parts, int dimension) {
  Part* best = nullptr;
  for (int a = 0; a < dimension; ++a)
    for (const int side : {-1, 1}) {
      Index k = part.k;
      k[a] += side;
      Part* const other = find(parts, k);
      if (other && other->fill >= least_part && (!best || other->fill > best->fill)) best = other;
    }
  return best;
}

void give_away_small(std::vector<Part>& parts, const ParticleLattice& lattice) {
  for (Part& part : parts) {
    if (part.fill >= least_part) continue;
    Part* const heir = heir_of(part, parts, lattice.dimension());
    if (!heir) continue;
    part.given_away = true;
    heir->moments.add(part.moments.moved(lattice.point(part.k) - lattice.point(heir->k)));
  }
}

/// E with E E^T / 12 = covariance: of a parallelepiped with these edges about its centre. Of all of these the one whose
/// edges but the last lie along the surface: in the axes (along it, `normal`) E is upper triangular.
Mat3 domain_of(const Moments& moments, const Vec3& normal, int dimension) {
  Mat3 axes = Mat3::Zero();
  Vec3 u(normal.y(), -normal.x(), 0), v = Vec3::Zero();
  if (dimension == 3) complete_basis(normal, u, v);
  if (dimension == 3 && u.cross(v).dot(normal) < 0) u = -u;
  axes.col(0) = u;
  axes.col(1) = dimension == 3 ? v : normal;
  axes.col(2) = dimension == 3 ? normal : Vec3(Vec3::UnitZ());
  const Mat3 M = 12 * axes.transpose() * moments.covariance() * axes;
  Mat3 U = Mat3::Zero();
  for (int j = dimension - 1; j >= 0; --j) {
    double rest = M(j, j);
    for (int k = j + 1; k < dimension; ++k) rest -= U(j, k) * U(j, k);
    U(j, j) = std::sqrt(std::max(rest, 0.0));
    for (int i = 0; i < j && U(j, j) > 0; ++i) {
      double mixed = M(i, j);
      for (int k = j + 1; k < dimension; ++k) mixed -= U(i, k) * U(j, k);
      U(i, j) = mixed / U(j, j);
    }
  }
  return axes * U;
}

}  // namespace

Samples fitted_points(const Solid& solid, const ParticleLattice& lattice) {
  std::vector<Part> parts = parts_of(solid, lattice);
  give_away_small(parts, lattice);
  Mat3 cube = Mat3::Zero();
  for (int a = 0; a < lattice.dimension(); ++a) cube(a, a) = lattice.spacing();
  Samples samples;
  for (const Part& part : parts) {
    if (part.given_away) continue;
    const double V = part.moments.measure, whole = lattice.cell_measure();
    const bool is_whole = std::abs(V / whole - 1) < rounding && part.fill > 1 - rounding;
    const Vec3 middle = lattice.point(part.k);
    const Vec3 X = is_whole ? middle : Vec3(middle + part.moments.centre());
    samples.X.push_back(X);
    samples.volume.push_back(is_whole ? whole : V);
    samples.domain.push_back(is_whole ? cube : domain_of(part.moments, solid.normal(X), lattice.dimension()));
  }
  return samples;
}

}  // namespace pf
