// Quadratic B-splines, averaged over the particle's own domain F_p l_0: forces are integrated over the body instead of
// being sampled at particles, which takes away the floor that sampling puts under every error.
#pragma once

#include <cmath>

#include "core/bases/gimp.hpp"
#include "core/bases/quadratic.hpp"

namespace pf {

/// What lies below s of each N (of the first two nodes: minus what lies above, so that what is left of them near their
/// end is exact), and N, at s in [1/2, 5/2): s = 0 is the first of four nodes.
template <class T>
void quadratic_below(const T& s, T* sum, T* N) {
  const auto second = s >= 1.5;
  const T f = second ? s - 1.5 : s - 0.5, g = 1 - f, none{};
  const T left = -g * g * g / 6, right = f * f * f / 6, middle = 1.0 / 6 + 0.5 * f * (1 + f) - f * f * f / 3;
  sum[0] = second ? none : left;
  sum[1] = second ? left : middle - 1;
  sum[2] = second ? middle : right;
  sum[3] = second ? right : none;
  const T N_left = 0.5 * g * g, N_right = 0.5 * f * f, N_middle = 0.5 + f * g;
  N[0] = second ? none : N_left;
  N[1] = second ? N_left : N_middle;
  N[2] = second ? N_middle : N_right;
  N[3] = second ? N_right : none;
}

/// The spline at t in [1, 2) among four nodes.
template <class T>
void quadratic_among_four(const T& t, T* N, T* dN) {
  const auto second = t >= 1.5;
  const T f = second ? t - 1.5 : t - 0.5, g = 1 - f, none{};
  T below[4];
  quadratic_below(t, below, N);
  dN[0] = second ? none : -g;
  dN[1] = second ? -g : 1 - 2 * f;
  dN[2] = second ? 1 - 2 * f : f;
  dN[3] = second ? f : none;
}

inline void quadratic_weights_among_four(double s, long long& base, double* N, double* dN) {
  const double floor = std::floor(s);
  base = static_cast<long long>(floor) - 1;
  const double t = s - (floor - 1);
  const int first = t >= 1.5 ? 1 : 0;
  for (int r = 0; r < 4; ++r) N[r] = dN[r] = 0;
  quadratic_values(t - first, N + first, dN + first);
}

inline constexpr BasisInfo quadratic_gimp_basis{
    "quadratic_gimp",
    "Quadratic, averaged",
    "Quadratic splines averaged over the particle's own domain: the most exact; no quadrature floor. Best with the "
    "consistent mass.",
    4,
    true,
    quadratic_weights_among_four,
    1,
    0.25,
    all_axes<2, 4, FourNumbers, quadratic_among_four<FourNumbers>>,
    all_axes<3, 4, EightNumbers, quadratic_among_four<EightNumbers>>,
    mean_values<4, FourNumbers, quadratic_below<FourNumbers>>,
    mean_values<4, EightNumbers, quadratic_below<EightNumbers>>,
    true};

}  // namespace pf
