// Fixed corotated solid (Stomakhin et al. 2012; THEORY T3), s the principal stretches:
//   psi = mu sum_i (s_i - 1)^2 + lambda/2 (J - 1)^2
//   P_i = 2 mu (s_i - 1) + lambda (J - 1) J / s_i
#pragma once

#include "core/materials/lame.hpp"
#include "core/materials/principal.hpp"

namespace pf {

struct FixedCorotated {
  Lame lame;

  static LawInfo info();
  static FixedCorotated from(std::span<const double> parameters) { return {lame_from(parameters)}; }

  template <class T, int D>
  T principal_psi(const T (&s)[D]) const;
  template <class T, int D>
  void principal_P(const T (&s)[D], T (&P)[D]) const;
  /// The twist eigenvalue is unbounded where s_i + s_j -> 0 (psi has a crease there); s_i + s_j is kept above 1e-8.
  template <class T, int D>
  PrincipalTangent<T, D> principal_tangent(const T (&s)[D]) const;

 private:
  /// J / s_i, without a division.
  template <class T>
  static T product_of_others(const T (&s)[2], int i) {
    return s[1 - i];
  }
  template <class T>
  static T product_of_others(const T (&s)[3], int i) {
    return s[(i + 1) % 3] * s[(i + 2) % 3];
  }
};

template <class T, int D>
T FixedCorotated::principal_psi(const T (&s)[D]) const {
  T sum{};
  for (int i = 0; i < D; ++i) sum += (s[i] - 1.0) * (s[i] - 1.0);
  const T volume = s[0] * product_of_others(s, 0) - 1.0;
  return lame.mu * sum + (0.5 * lame.lambda) * (volume * volume);
}

template <class T, int D>
void FixedCorotated::principal_P(const T (&s)[D], T (&P)[D]) const {
  const T pressure = lame.lambda * (s[0] * product_of_others(s, 0) - 1.0);
  for (int i = 0; i < D; ++i) P[i] = 2 * lame.mu * (s[i] - 1.0) + pressure * product_of_others(s, i);
}

template <class T, int D>
PrincipalTangent<T, D> FixedCorotated::principal_tangent(const T (&s)[D]) const {
  PrincipalTangent<T, D> tangent;
  const T J = s[0] * product_of_others(s, 0), pressure = lame.lambda * (J - 1.0);
  for (int i = 0; i < D; ++i) {
    const T others = product_of_others(s, i);
    tangent.block(i, i) = 2 * lame.mu + lame.lambda * (others * others);
  }
  for (int k = 0; k < Pair<D>::count; ++k) {
    const Pair<D> pair(k);
    const T third = D == 3 ? s[k] : broadcast<T>(1);  // J / (s_i s_j)
    const T sum = s[pair.i] + s[pair.j];
    tangent.flip[k] = 2 * lame.mu - pressure * third;
    tangent.twist[k] = 2 * lame.mu + pressure * third - 4 * lame.mu / select(sum < 1e-8, broadcast<T>(1e-8), sum);
    tangent.block(pair.i, pair.j) = tangent.block(pair.j, pair.i) = (lame.lambda * (2.0 * J - 1.0)) * third;
  }
  return tangent;
}

inline LawInfo FixedCorotated::info() {
  return {.name = "fixed_corotated",
          .label = "Fixed corotated",
          .about =
              "The usual law of computer graphics: linear in the stretches, robust, and finite when crushed, so "
              "that particles can invert. psi = mu sum (s - 1)^2 + lambda/2 (J - 1)^2 (Stomakhin et al. 2012).",
          .parameters = isotropic_parameters(),
          .objective = true,
          .barrier_at_zero = false};
}

}  // namespace pf
