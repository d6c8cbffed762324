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

template <bool project, class Model, class T, int D>
void dP_of(const Model& model, const Square<T, D>& F, UpperTangent<T, D>& A) {
  constexpr bool direct = requires {
    model.dP(F, A);
  };
  constexpr bool convex = requires {
    Model::convex;
  };
  if constexpr (direct && (!project || convex)) {
    model.dP(F, A);
  } else {
    const Svd<T, D> frame = svd(F);
    PrincipalTangent<T, D> tangent = model.principal_tangent(frame.s);
    if constexpr (project) clamp_psd(tangent);
    from_principal(frame, tangent, A);
  }
}

}  // namespace pf
