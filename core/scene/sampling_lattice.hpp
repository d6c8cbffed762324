// Points (k + 1/2) s on every axis, s = dx/n, in absolute coordinates, and the samplings that follow them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/solid.hpp"

namespace pf {

class ParticleLattice {
 public:
  using Index = std::array<std::int64_t, 3>;

  /// `per_axis` = n points a grid cell in each direction; `bounds` finite.
  ParticleLattice(double grid_spacing, int per_axis, int dimension, const Bounds& bounds);

  int dimension() const { return dimension_; }
  double spacing() const { return spacing_; }
  double cell_measure() const;
  /// INTERFACE fine print 4.
  double tolerance() const { return 1e-9 * grid_spacing_; }
  /// The indices within the bounds are exact in a double.
  bool representable() const { return representable_; }
  /// First and last index of the points within the bounds; last < first where there are none.
  const Index& first() const { return first_; }
  const Index& last() const { return last_; }
  Vec3 point(const Index& k) const { return at({double(k[0]) + 0.5, double(k[1]) + 0.5, double(k[2]) + 0.5}); }
  /// Lattice coordinates -> position; z = 0 in 2D.
  Vec3 at(const Vec3& coordinates) const;

 private:
  double grid_spacing_, per_axis_, spacing_;
  int dimension_;
  bool representable_ = true;
  Index first_{}, last_{};
};

/// The points that the solid holds, z slowest, x fastest.
std::vector<Vec3> lattice_points(const Solid& solid, const ParticleLattice& lattice);
/// One point anywhere in each lattice cell, kept where the solid holds it: the same for a seed on every machine.
std::vector<Vec3> jittered_points(const Solid& solid, const ParticleLattice& lattice, std::uint64_t seed);
/// Points at random, no two nearer than a distance chosen so that there are about as many as in the lattice, and no
/// room for many more.
std::vector<Vec3> poisson_disc_points(const Solid& solid, const ParticleLattice& lattice, std::uint64_t seed);

}  // namespace pf
