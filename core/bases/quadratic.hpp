// Quadratic B-spline: N = 3/4 - r^2 for |r| < 1/2, (3/2 - |r|)^2 / 2 up to 3/2 (THEORY T2). Class C^1.
#pragma once

#include <cmath>

#include "core/bases/basis.hpp"

namespace pf {

/// Of t = s - base, in [1/2, 3/2): the distance from the first node.
template <class T>
void quadratic_values(const T& t, T* N, T* dN) {
  const T r = t - 1;  // of the middle node, in [-1/2, 1/2)
  N[0] = 0.5 * (0.5 - r) * (0.5 - r);
  N[1] = 0.75 - r * r;
  N[2] = 0.5 * (0.5 + r) * (0.5 + r);
  dN[0] = r - 0.5;
  dN[1] = -2 * r;
  dN[2] = r + 0.5;
}

inline void quadratic_weights(double s, long long& base, double* N, double* dN) {
  const double floor = std::floor(s - 0.5);
  base = static_cast<long long>(floor);
  quadratic_values(s - floor, N, dN);
}

inline constexpr BasisInfo quadratic_basis{"quadratic",
                                           "Quadratic B-spline",
                                           "Smooth forces across cell faces; the default. Steffen et al. 2008.",
                                           3,
                                           true,
                                           quadratic_weights,
                                           0.5,
                                           0.25,
                                           all_axes<2, 3, FourNumbers, quadratic_values<FourNumbers>>,
                                           all_axes<3, 3, EightNumbers, quadratic_values<EightNumbers>>,
                                           nullptr,
                                           nullptr,
                                           true};

}  // namespace pf
