// GIMP (Bardenhagen and Kober 2004): the linear shape functions, averaged over the particle's own domain F_p l_0.
#pragma once

#include <cmath>

#include "core/bases/linear.hpp"

namespace pf {

/// What lies below s of each N (of the first node: minus what lies above, so that what is left of it near its end is
/// exact), and N, at s in [0, 2): s = 0 is the first of three nodes.
template <class T>
void linear_below(const T& s, T* sum, T* N) {
  const auto second = s >= 1;
  const T f = second ? s - 1 : s, g = 1 - f, none{};
  const T left = -0.5 * g * g, right = 0.5 * f * f;
  sum[0] = second ? none : left;
  sum[1] = second ? left + 1 : right;
  sum[2] = second ? right : none;
  N[0] = second ? none : g;
  N[1] = second ? g : f;
  N[2] = second ? f : none;
}

/// Means from what lies below either end.
template <int nodes, class T, void (*below)(const T&, T*, T*)>
void mean_values(const T& t, const T& width, T* N, T* dN) {
  T high[nodes], low[nodes], N_high[nodes], N_low[nodes];
  below(t + 0.5 * width, high, N_high);
  below(t - 0.5 * width, low, N_low);
  const T inverse = 1 / width;
  for (int r = 0; r < nodes; ++r) {
    N[r] = (high[r] - low[r]) * inverse;
    dN[r] = (N_high[r] - N_low[r]) * inverse;
  }
}

/// The linear functions at t in [1/2, 3/2) among three nodes.
template <class T>
void linear_among_three(const T& t, T* N, T* dN) {
  const auto second = t >= 1;
  const T none{}, one = none + 1;
  T below[3];
  linear_below(t, below, N);
  dN[0] = second ? none : -one;
  dN[1] = second ? -one : one;
  dN[2] = second ? one : none;
}

inline void linear_weights_among_three(double s, long long& base, double* N, double* dN) {
  const double floor = std::floor(s - 0.5), t = s - floor;
  base = static_cast<long long>(floor);
  const int first = t >= 1 ? 1 : 0;
  for (int r = 0; r < 3; ++r) N[r] = dN[r] = 0;
  linear_values(t - first, N + first, dN + first);
}

inline constexpr BasisInfo gimp_basis{
    "gimp",
    "GIMP: linear, averaged",
    "Linear functions averaged over the particle's own domain: no force jumps, no quadrature floor. Bardenhagen and "
    "Kober 2004.",
    3,
    true,
    linear_weights_among_three,
    0.5,
    0,
    all_axes<2, 3, FourNumbers, linear_among_three<FourNumbers>>,
    all_axes<3, 3, EightNumbers, linear_among_three<EightNumbers>>,
    mean_values<3, FourNumbers, linear_below<FourNumbers>>,
    mean_values<3, EightNumbers, linear_below<EightNumbers>>};

}  // namespace pf
