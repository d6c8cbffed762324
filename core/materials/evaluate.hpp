// psi, P and dP/dF of a law's struct at one F (or a pack of them). A struct gives either the functions of F
//   psi(F)   P(F, psi)   dP(F, A)
// or those of the principal stretches
//   principal_psi(s)   principal_P(s, P)   principal_tangent(s)
// or both, the second then for the projected tangent only; a tangent that is never indefinite says so by
// `static constexpr bool convex = true`.
#pragma once

#include "core/materials/principal.hpp"

namespace pf {

template <class Model, class T, int D>
T psi_of(const Model& model, const Square<T, D>& F) {
  if constexpr (requires { model.psi(F); }) {
    return model.psi(F);
  } else {
    return model.principal_psi(svd(F).s);
  }
}

template <class Model, class T, int D>
Square<T, D> P_of(const Model& model, const Square<T, D>& F, T& psi) {
  if constexpr (requires { model.P(F, psi); }) {
    return model.P(F, psi);
  } else {
    const Svd<T, D> frame = svd(F);
    T P[D];
    psi = model.principal_psi(frame.s);
    model.principal_P(frame.s, P);
    return from_principal(frame, P);
  }
}

/// Whether the projected, or the true, tangent of this model comes from principal stretches.
template <bool project, class Model, class T, int D>
inline constexpr bool tangent_by_stretches = [] {
  constexpr bool direct = requires(const Model& model, Square<T, D> F, UpperTangent<T, D> A) {
    model.dP(F, A);
  };
  constexpr bool convex = requires {
    Model::convex;
  };
  return !direct || (project && !convex);
}();

namespace detail {

template <bool project, class Model, class T, int D>
PrincipalTangent<T, D> principal_tangent_of(const Model& model, const Svd<T, D>& frame) {
  PrincipalTangent<T, D> tangent = model.principal_tangent(frame.s);
  if constexpr (project) clamp_psd(tangent);
  return tangent;
}

}  // namespace detail

/// dP/dF, or its projection.
template <bool project, class Model, class T, int D>
void dP_of(const Model& model, const Square<T, D>& F, UpperTangent<T, D>& A) {
  if constexpr (tangent_by_stretches<project, Model, T, D>) {
    const Svd<T, D> frame = svd(F);
    from_principal(frame, detail::principal_tangent_of<project>(model, frame), A);
  } else {
    model.dP(F, A);
  }
}

/// (F_n (x) I) dP/dF (F_n (x) I)^T, dP/dF or its projection: the tangent with respect to F^, F = F^ F_n.
template <bool project, class Model, class T, int D>
void grid_dP_of(const Model& model, const Square<T, D>& F, const Square<T, D>& F_n, UpperTangent<T, D>& A) {
  if constexpr (tangent_by_stretches<project, Model, T, D>) {
    Svd<T, D> frame = svd(F);
    const PrincipalTangent<T, D> tangent = detail::principal_tangent_of<project>(model, frame);
    frame.V = multiply(F_n, frame.V);  // u_i v_j^T becomes u_i (F_n v_j)^T
    from_principal(frame, tangent, A);
  } else {
    UpperTangent<T, D> reference;
    model.dP(F, reference);
    push_forward(F_n, reference, A);
  }
}

}  // namespace pf
