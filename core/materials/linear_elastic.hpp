// Linear elasticity in the total displacement gradient (THEORY T3), e = sym(F - I):
//   psi = mu e:e + lambda/2 tr(e)^2,   P = 2 mu e + lambda tr(e) I
// Rotation counts as strain here: it is offered for comparison with the formulae of small strain.
#pragma once

#include "core/materials/lame.hpp"
#include "core/materials/principal.hpp"

namespace pf {

struct LinearElastic {
  static constexpr bool convex = true;
  Lame lame;

  static LawInfo info();
  static LinearElastic from(std::span<const double> parameters) { return {lame_from(parameters)}; }

  template <class T, int D>
  T psi(const Square<T, D>& F) const {
    return psi_of_strain(strain(F));
  }
  template <class T, int D>
  Square<T, D> P(const Square<T, D>& F, T& psi_out) const {
    Square<T, D> e = strain(F);
    psi_out = psi_of_strain(e);
    const T volumetric = lame.lambda * trace(e);
    for (T& entry : e.e) entry *= 2 * lame.mu;
    for (int a = 0; a < D; ++a) e(a, a) += volumetric;
    return e;
  }
  /// mu (delta_ab delta_BD + delta_aD delta_Bb) + lambda delta_aB delta_bD
  template <class T, int D>
  void dP(const Square<T, D>&, UpperTangent<T, D>& A) const {
    for (int column = 0; column < D * D; ++column) {
      for (int row = 0; row <= column; ++row) {
        const int a = row % D, B = row / D, b = column % D, C = column / D;
        A(row, column) =
            broadcast<T>(lame.mu * ((a == b && B == C) + (a == C && B == b)) + lame.lambda * (a == B && b == C));
      }
    }
  }

 private:
  template <class T, int D>
  static Square<T, D> strain(const Square<T, D>& F) {
    Square<T, D> e;
    for (int b = 0; b < D; ++b) {
      e(b, b) = F(b, b) - 1.0;
      for (int a = 0; a < b; ++a) e(a, b) = e(b, a) = 0.5 * (F(a, b) + F(b, a));
    }
    return e;
  }
  template <class T, int D>
  T psi_of_strain(const Square<T, D>& e) const {
    const T tr_e = trace(e);
    return lame.mu * squared_norm(e) + (0.5 * lame.lambda) * (tr_e * tr_e);
  }
};

inline LawInfo LinearElastic::info() {
  return {.name = "linear_elastic",
          .label = "Linear elastic",
          .about =
              "Small-strain elasticity, for comparison with textbook formulae. It is not objective: a body that "
              "turns swells and feels stress. psi = mu e:e + lambda/2 tr(e)^2, e = sym(F - I).",
          .parameters = isotropic_parameters(),
          .objective = false,
          .barrier_at_zero = false};
}

}  // namespace pf
