// Compressible neo-Hookean solid (THEORY T3):
//   psi = mu/2 (tr F^T F - 3) - mu ln J + lambda/2 ln^2 J
//   P   = mu (F - F^-T) + lambda ln J F^-T
//   dP  = mu dF + (mu - lambda ln J) F^-T dF^T F^-T + lambda (F^-T : dF) F^-T
// No singular values are needed, but for the projected tangent. With G = F^T F - I the first two are also
//   psi = mu/2 (tr G - ln det(I + G)) + lambda/2 ln^2 J,   P = F^-T (mu G + lambda ln J I),
// where every term of psi is of second order in the strain: used near F = R, since Newton's line search compares
// energies far below mu.
#pragma once

#include "core/materials/lame.hpp"
#include "core/materials/principal.hpp"
#include "core/math/logarithm.hpp"
#include "core/math/small_linalg.hpp"

namespace pf {

struct NeoHookean {
  Lame lame;

  static LawInfo info();
  static NeoHookean from(std::span<const double> parameters) { return {lame_from(parameters)}; }

  /// G = F^T F - I, J, ln J and tr G - 2 ln J.
  template <class T, int D>
  struct State {
    Square<T, D> G;
    T J, ln_J, deviation;
    decltype(T{} < T{}) small_strain;
  };
  template <class T, int D>
  static State<T, D> state(const Square<T, D>& F);

  template <class T, int D>
  T psi(const Square<T, D>& F) const {
    return psi(state(F));
  }
  template <class T, int D>
  T psi(const State<T, D>& state) const {
    const T value = 0.5 * (lame.mu * state.deviation + lame.lambda * (state.ln_J * state.ln_J));
    return select(state.J <= 0.0, broadcast<T>(std::numeric_limits<double>::infinity()), value);
  }
  /// P; psi as a by-product.
  template <class T, int D>
  Square<T, D> P(const Square<T, D>& F, T& psi_out) const;
  template <class T, int D>
  void dP(const Square<T, D>& F, UpperTangent<T, D>& A) const;
  /// For the projection only: P_i = mu (s_i - 1/s_i) + lambda ln J / s_i.
  template <class T, int D>
  PrincipalTangent<T, D> principal_tangent(const T (&s)[D]) const;
};

template <class T, int D>
NeoHookean::State<T, D> NeoHookean::state(const Square<T, D>& F) {
  State<T, D> state;
  state.G = green_strain_twice(F);
  state.J = determinant(F);
  const T tr_G = trace(state.G);
  T higher = second_invariant(state.G);  // det(I + G) = 1 + tr G + higher
  if constexpr (D == 3) higher += determinant(state.G);
  const T y = tr_G + higher;
  const auto small = squared_norm(state.G) < 0.02;  // then |y| < 0.3, and ln J = ln(1 + y)/2
  BinarySplit<T> split = split_binary(state.J);
  split.f = select(small, y, split.f);
  split.exponent = select(small, T{}, split.exponent);
  const T excess = log_excess(split.f), log = join_log(split, excess);
  state.small_strain = small;
  state.ln_J = select(state.J == state.J, select(small, 0.5 * log, log), state.J);
  state.deviation = select(small, excess - higher, tr_G - 2.0 * state.ln_J);
  return state;
}

template <class T, int D>
Square<T, D> NeoHookean::P(const Square<T, D>& F, T& psi_out) const {
  const State<T, D> s = state(F);
  psi_out = psi(s);
  Square<T, D> A = cofactor(F), S = s.G;  // A = F^-T
  const T inverse_J = 1.0 / s.J, volumetric = lame.lambda * s.ln_J;
  for (T& entry : A.e) entry *= inverse_J;
  const T mu = broadcast<T>(lame.mu);
  for (T& entry : S.e) entry *= mu;
  for (int a = 0; a < D; ++a) S(a, a) += volumetric;
  Square<T, D> P = multiply(A, S);
  // At large strain F - F^-T loses less than F^-T G does.
  for (int k = 0; k < D * D; ++k) P.e[k] = select(s.small_strain, P.e[k], mu * F.e[k] + (volumetric - mu) * A.e[k]);
  return P;
}

template <class T, int D>
void NeoHookean::dP(const Square<T, D>& F, UpperTangent<T, D>& dP) const {
  const State<T, D> s = state(F);
  Square<T, D> A = cofactor(F);
  const T mu = broadcast<T>(lame.mu), lambda = broadcast<T>(lame.lambda);
  const T inverse_J = 1.0 / s.J, swapped = mu - lambda * s.ln_J;
  for (T& entry : A.e) entry *= inverse_J;
  for (int column = 0; column < D * D; ++column) {
    for (int row = 0; row <= column; ++row) {
      const int a = row % D, B = row / D, b = column % D, C = column / D;
      dP(row, column) = lambda * (A(a, B) * A(b, C)) + swapped * (A(b, B) * A(a, C));
    }
    dP(column, column) += mu;
  }
}

template <class T, int D>
PrincipalTangent<T, D> NeoHookean::principal_tangent(const T (&s)[D]) const {
  T J = s[0];
  for (int i = 1; i < D; ++i) J *= s[i];
  const T swapped = lame.mu - lame.lambda * log_of(J);
  PrincipalTangent<T, D> tangent;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) tangent.block(i, j) = lame.lambda / (s[i] * s[j]);
    tangent.block(i, i) += lame.mu + swapped / (s[i] * s[i]);
  }
  for (int k = 0; k < Pair<D>::count; ++k) {
    const Pair<D> pair(k);
    const T ratio = swapped / (s[pair.i] * s[pair.j]);
    tangent.flip[k] = lame.mu + ratio;
    tangent.twist[k] = lame.mu - ratio;
  }
  return tangent;
}

inline LawInfo NeoHookean::info() {
  return {.name = "neo_hookean",
          .label = "Neo-Hookean",
          .about =
              "Rubber-like solid for large strain; the energy grows without bound as a particle is crushed, so it "
              "never inverts. psi = mu/2 (tr F^T F - 3) - mu ln J + lambda/2 ln^2 J (Bonet and Wood 2008).",
          .parameters = isotropic_parameters(),
          .objective = true,
          .barrier_at_zero = true};
}

}  // namespace pf
