// Saint Venant-Kirchhoff solid (THEORY T3), E = (F^T F - I)/2:
//   psi = mu E:E + lambda/2 tr(E)^2,   P = F S,  S = 2 mu E + lambda tr(E) I
//   dP_aB/dF_bD = delta_ab S_BD + mu (F_aD F_bB + (F F^T)_ab delta_BD) + lambda F_aB F_bD
#pragma once

#include "core/materials/lame.hpp"
#include "core/materials/principal.hpp"

namespace pf {

struct StVenantKirchhoff {
  Lame lame;

  static LawInfo info();
  static StVenantKirchhoff from(std::span<const double> parameters) { return {lame_from(parameters)}; }

  template <class T, int D>
  T psi(const Square<T, D>& F) const {
    return psi_of_strain(green_strain_twice(F));
  }
  template <class T, int D>
  Square<T, D> P(const Square<T, D>& F, T& psi_out) const {
    const Square<T, D> G = green_strain_twice(F);
    psi_out = psi_of_strain(G);
    return multiply(F, second_piola(G));
  }
  template <class T, int D>
  void dP(const Square<T, D>& F, UpperTangent<T, D>& A) const;
  /// For the projection only: P_i = s_i (mu (s_i^2 - 1) + lambda tr E).
  template <class T, int D>
  PrincipalTangent<T, D> principal_tangent(const T (&s)[D]) const;

 private:
  /// G = 2 E
  template <class T, int D>
  T psi_of_strain(const Square<T, D>& G) const {
    const T tr_G = trace(G);
    return (0.25 * lame.mu) * squared_norm(G) + (0.125 * lame.lambda) * (tr_G * tr_G);
  }
  template <class T, int D>
  Square<T, D> second_piola(Square<T, D> G) const {
    const T volumetric = (0.5 * lame.lambda) * trace(G);
    for (T& entry : G.e) entry *= lame.mu;
    for (int a = 0; a < D; ++a) G(a, a) += volumetric;
    return G;
  }
};

template <class T, int D>
void StVenantKirchhoff::dP(const Square<T, D>& F, UpperTangent<T, D>& A) const {
  const Square<T, D> S = second_piola(green_strain_twice(F));
  Square<T, D> b;  // mu F F^T
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      T sum = F(i, 0) * F(j, 0);
      for (int c = 1; c < D; ++c) sum += F(i, c) * F(j, c);
      b(i, j) = lame.mu * sum;
    }
  }
  for (int column = 0; column < D * D; ++column) {
    for (int row = 0; row <= column; ++row) {
      const int a = row % D, B = row / D, c = column % D, C = column / D;
      T value = lame.mu * (F(a, C) * F(c, B)) + lame.lambda * (F(a, B) * F(c, C));
      if (a == c) value += S(B, C);
      if (B == C) value += b(a, c);
      A(row, column) = value;
    }
  }
}

template <class T, int D>
PrincipalTangent<T, D> StVenantKirchhoff::principal_tangent(const T (&s)[D]) const {
  PrincipalTangent<T, D> tangent;
  T tr_G{};
  for (int i = 0; i < D; ++i) tr_G += s[i] * s[i] - 1.0;
  const T base = (0.5 * lame.lambda) * tr_G - lame.mu;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) tangent.block(i, j) = lame.lambda * (s[i] * s[j]);
    tangent.block(i, i) += base + (3 * lame.mu) * (s[i] * s[i]);
  }
  for (int k = 0; k < Pair<D>::count; ++k) {
    const Pair<D> pair(k);
    const T squares = s[pair.i] * s[pair.i] + s[pair.j] * s[pair.j], product = s[pair.i] * s[pair.j];
    tangent.flip[k] = base + lame.mu * (squares + product);
    tangent.twist[k] = base + lame.mu * (squares - product);
  }
  return tangent;
}

inline LawInfo StVenantKirchhoff::info() {
  return {.name = "st_venant_kirchhoff",
          .label = "Saint Venant-Kirchhoff",
          .about =
              "Linear between Green strain and second Piola-Kirchhoff stress: large rotation with small strain. It "
              "softens and then collapses in compression (below about 58 % of its length), without resistance to "
              "inversion. psi = mu E:E + lambda/2 tr(E)^2, E = (F^T F - I)/2.",
          .parameters = isotropic_parameters(),
          .objective = true,
          .barrier_at_zero = false};
}

}  // namespace pf
