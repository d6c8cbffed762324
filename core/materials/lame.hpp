// The two constants of an isotropic elastic solid, and how a scene file gives them.
#pragma once

#include <span>
#include <vector>

#include "core/materials/law.hpp"

namespace pf {

/// Lame's constants [Pa]. In 2D they are those of the 3D material (plane strain).
struct Lame {
  double mu, lambda;
};

inline Lame lame_of(double young, double poisson) {
  return {young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))};
}

/// "young", "poisson": what each isotropic elastic law reads.
std::vector<LawParameter> isotropic_parameters();
/// From the values of isotropic_parameters(), in that order.
inline Lame lame_from(std::span<const double> parameters) {
  return lame_of(parameters[0], parameters[1]);
}

}  // namespace pf
