// Cubic B-spline: N = 2/3 - r^2 + |r|^3/2 for |r| < 1, (2 - |r|)^3 / 6 up to 2 (THEORY T2). Class C^2.
#pragma once

#include <cmath>

#include "core/bases/basis.hpp"

namespace pf {

/// Of t = s - base, in [1, 2): the distance from the first node.
template <class T>
void cubic_values(const T& t, T* N, T* dN) {
  const T f = t - 1, g = 1 - f;  // distances to the two inner nodes
  N[0] = g * g * g / 6;
  N[1] = 2.0 / 3 - f * f + 0.5 * f * f * f;
  N[2] = 2.0 / 3 - g * g + 0.5 * g * g * g;
  N[3] = f * f * f / 6;
  dN[0] = -0.5 * g * g;
  dN[1] = -2 * f + 1.5 * f * f;
  dN[2] = 2 * g - 1.5 * g * g;
  dN[3] = 0.5 * f * f;
}

inline void cubic_weights(double s, long long& base, double* N, double* dN) {
  const double floor = std::floor(s);
  base = static_cast<long long>(floor) - 1;
  cubic_values(s - (floor - 1), N, dN);
}

inline constexpr BasisInfo cubic_basis{"cubic",
                                       "Cubic B-spline",
                                       "Smoothest; four nodes an axis, about twice the cost of quadratic in 3D.",
                                       4,
                                       true,
                                       cubic_weights,
                                       1,
                                       1.0 / 3,
                                       all_axes<2, 4, FourNumbers, cubic_values<FourNumbers>>,
                                       all_axes<3, 4, EightNumbers, cubic_values<EightNumbers>>,
                                       nullptr,
                                       nullptr,
                                       true};

}  // namespace pf
