// Polar decomposition F = R S, for one matrix or a pack of them.
#pragma once

#include "core/math/svd.hpp"

namespace pf {

/// R the rotation (det R = +1) nearest to F, S = R^T F symmetric; S is indefinite where det F < 0.
template <class T, int D>
struct Polar {
  Square<T, D> R, S;
};

/// R = U V^T, S = V diag(s) V^T.
template <class T, int D>
Polar<T, D> polar(const Svd<T, D>& svd) {
  Polar<T, D> result;
  for (int b = 0; b < D; ++b) {
    for (int a = 0; a < D; ++a) {
      T r = svd.U(a, 0) * svd.V(b, 0), s = svd.V(a, 0) * svd.s[0] * svd.V(b, 0);
      for (int i = 1; i < D; ++i) {
        r += svd.U(a, i) * svd.V(b, i);
        s += svd.V(a, i) * svd.s[i] * svd.V(b, i);
      }
      result.R(a, b) = r;
      result.S(a, b) = s;
    }
  }
  return result;
}

template <class T, int D>
Polar<T, D> polar(const Square<T, D>& F) {
  return polar(svd(F));
}

}  // namespace pf
