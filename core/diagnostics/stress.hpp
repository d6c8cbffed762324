// Scalars of the Cauchy stress that people look at, defined once for legend, CSV, VTK and plots. Always of the
// full 3 x 3 tensor: in 2D the plane-strain sigma_zz counts (THEORY T1).
#pragma once

#include <cmath>

#include "core/types.hpp"

namespace pf {

/// -tr(sigma)/3 [Pa]: positive in compression.
inline double pressure(const Mat3& sigma) {
  return -sigma.trace() / 3;
}
/// sqrt(3/2 s:s) with the deviator s [Pa].
inline double von_mises(const Mat3& sigma) {
  const Mat3 deviator = sigma + pressure(sigma) * Mat3::Identity();
  return std::sqrt(1.5 * deviator.squaredNorm());
}

}  // namespace pf
