// Linear B-spline, the Q1 element: N = 1 - |r| (THEORY T2). Class C^0.
#pragma once

#include <cmath>

#include "core/bases/basis.hpp"

namespace pf {

inline void linear_weights(double s, long long& base, double* N, double* dN) {
  const double floor = std::floor(s);
  base = static_cast<long long>(floor);
  const double f = s - floor;
  N[0] = 1 - f;
  N[1] = f;
  dN[0] = -1;
  dN[1] = 1;
}

inline constexpr BasisInfo linear_basis{
    "linear", "Linear (Q1)", "Cheapest; force jumps when a particle crosses a cell face. Steffen et al. 2008.",
    2,        false,         linear_weights};

}  // namespace pf
