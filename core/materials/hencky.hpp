// Hencky's solid: quadratic in the logarithmic strains (THEORY T3), s the principal stretches:
//   psi = mu sum_i ln^2 s_i + lambda/2 (sum_i ln s_i)^2
//   P_i = tau_i / s_i,   tau_i = 2 mu ln s_i + lambda ln J     (tau: principal Kirchhoff stresses)
#pragma once

#include "core/materials/lame.hpp"
#include "core/materials/principal.hpp"
#include "core/math/logarithm.hpp"

namespace pf {

struct Hencky {
  Lame lame;

  static LawInfo info();
  static Hencky from(std::span<const double> parameters) { return {lame_from(parameters)}; }

  template <class T, int D>
  T principal_psi(const T (&s)[D]) const;
  template <class T, int D>
  void principal_P(const T (&s)[D], T (&P)[D]) const;
  template <class T, int D>
  PrincipalTangent<T, D> principal_tangent(const T (&s)[D]) const;

 private:
  /// tau_i
  template <class T, int D>
  void kirchhoff(const T (&s)[D], T (&tau)[D]) const;
};

template <class T, int D>
T Hencky::principal_psi(const T (&s)[D]) const {
  T squares{}, ln_J{};
  for (int i = 0; i < D; ++i) {
    const T ln = log_of(s[i]);
    squares += ln * ln;
    ln_J += ln;
  }
  const T value = lame.mu * squares + (0.5 * lame.lambda) * (ln_J * ln_J);
  return select(s[D - 1] <= 0.0, broadcast<T>(std::numeric_limits<double>::infinity()), value);
}

template <class T, int D>
void Hencky::kirchhoff(const T (&s)[D], T (&tau)[D]) const {
  T ln_J{};
  for (int i = 0; i < D; ++i) {
    tau[i] = log_of(s[i]);
    ln_J += tau[i];
  }
  for (int i = 0; i < D; ++i) tau[i] = 2 * lame.mu * tau[i] + lame.lambda * ln_J;
}

template <class T, int D>
void Hencky::principal_P(const T (&s)[D], T (&P)[D]) const {
  kirchhoff(s, P);
  for (int i = 0; i < D; ++i) P[i] = P[i] / s[i];
}

template <class T, int D>
PrincipalTangent<T, D> Hencky::principal_tangent(const T (&s)[D]) const {
  PrincipalTangent<T, D> tangent;
  T tau[D], inverse[D];
  kirchhoff(s, tau);
  for (int i = 0; i < D; ++i) inverse[i] = 1.0 / s[i];
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) tangent.block(i, j) = lame.lambda * (inverse[i] * inverse[j]);
    tangent.block(i, i) += (2 * lame.mu - tau[i]) * (inverse[i] * inverse[i]);
  }
  for (int k = 0; k < Pair<D>::count; ++k) {
    const Pair<D> pair(k);
    const int i = pair.i, j = pair.j;
    // (s_i + s_j)/2 (ln s_i - ln s_j)/(s_i - s_j) = atanh(z)/z,  z = (s_i - s_j)/(s_i + s_j)
    const T slope = atanh_over((s[i] - s[j]) / (s[i] + s[j]));
    const T scale = inverse[i] * inverse[j];
    tangent.flip[k] = (2 * lame.mu * slope - 0.5 * (tau[i] + tau[j])) * scale;
    tangent.twist[k] = (tau[i] * s[j] + tau[j] * s[i]) * scale / (s[i] + s[j]);
  }
  return tangent;
}

inline LawInfo Hencky::info() {
  return {.name = "hencky",
          .label = "Hencky",
          .about =
              "Linear between Kirchhoff stress and logarithmic strain: true stress and strain of metals and soils "
              "at moderate strain, and the base of plastic laws. psi = mu sum ln^2 s + lambda/2 ln^2 J "
              "(Hencky 1928).",
          .parameters = isotropic_parameters(),
          .objective = true,
          .barrier_at_zero = true};
}

}  // namespace pf
