// Fields given at scattered particles, evaluated between them or smoothed: quadratic moving least squares in reference
// coordinates (Lancaster and Salkauskas 1981). What is left of a field without its fit is its noise.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace pf {

/// A value at a place is the sum of weight times the value at each of these particles.
using FitWeights = std::vector<std::pair<std::uint32_t, double>>;

class LocalFit {
 public:
  /// `X` [m], all in one body's reference configuration of this body only where `body` says so; `spacing`: dx [m].
  LocalFit(int dimension, std::vector<Vec3> X, std::vector<std::uint16_t> body, double spacing);

  /// Weights of the fit at X within `body`; they reproduce quadratics where enough particles lie around, lower orders
  /// where a body is too thin. Empty where the body has no particle within a few cells.
  FitWeights at(const Vec3& X, std::uint16_t body) const;

 private:
  using Cell = std::pair<std::uint16_t, std::array<std::int64_t, 3>>;
  Cell cell_of(const Vec3& X, std::uint16_t body) const;
  std::vector<std::uint32_t> around(const Vec3& X, std::uint16_t body, double radius) const;

  int dimension_;
  std::vector<Vec3> X_;
  double spacing_;
  std::map<Cell, std::vector<std::uint32_t>> cells_;
};

/// Root mean square, weighted by `mass`, of |f - fit(f)| and of |f|: `fits[p]` are the weights at particle p; `f` has
/// `components` numbers a particle.
struct Roughness {
  double noise = 0, size = 0;
};
Roughness roughness(std::span<const FitWeights> fits, std::span<const double> f, std::size_t components,
                    std::span<const double> mass);

}  // namespace pf
