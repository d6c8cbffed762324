// Linear B-spline, the Q1 element: N = 1 - |r| (THEORY T2). Class C^0.
#pragma once

#include <cmath>

#include "core/bases/basis.hpp"

namespace pf {

/// Of t = s - base, in [0, 1): the distance from the first node.
template <class T>
void linear_values(const T& t, T* N, T* dN) {
  N[0] = 1 - t;
  N[1] = t;
  dN[0] = T{} - 1;
  dN[1] = T{} + 1;
}

inline void linear_weights(double s, long long& base, double* N, double* dN) {
  const double floor = std::floor(s);
  base = static_cast<long long>(floor);
  linear_values(s - floor, N, dN);
}

inline constexpr BasisInfo linear_basis{
    "linear",
    "Linear (Q1)",
    "Cheapest; force jumps when a particle crosses a cell face. Steffen et al. 2008.",
    2,
    false,
    linear_weights,
    0,
    0,
    all_axes<2, 2, FourNumbers, linear_values<FourNumbers>>,
    all_axes<3, 2, EightNumbers, linear_values<EightNumbers>>};

}  // namespace pf
