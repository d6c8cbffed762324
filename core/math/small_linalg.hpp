// D x D matrices whose entries are numbers or packs of numbers, and the few operations that material laws need.
#pragma once

#include "core/math/lanes.hpp"

namespace pf {

/// D x D, column-major as in Eigen: entry (a, b) at a + D b.
template <class T, int D>
struct Square {
  T e[D * D];
  T& operator()(int a, int b) { return e[a + D * b]; }
  const T& operator()(int a, int b) const { return e[a + D * b]; }
};

template <class T, int D>
Square<T, D> identity_of() {
  Square<T, D> I{};
  for (int a = 0; a < D; ++a) I(a, a) = broadcast<T>(1);
  return I;
}

template <class T>
T determinant(const Square<T, 2>& F) {
  return F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
}

/// d det / dF: the matrix of cofactors, F^-T det F.
template <class T>
Square<T, 2> cofactor(const Square<T, 2>& F) {
  return {{F(1, 1), -F(0, 1), -F(1, 0), F(0, 0)}};
}
template <class T>
Square<T, 3> cofactor(const Square<T, 3>& F) {
  Square<T, 3> C;
  for (int b = 0; b < 3; ++b) {
    for (int a = 0; a < 3; ++a) {
      const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, b1 = (b + 1) % 3, b2 = (b + 2) % 3;
      C(a, b) = F(a1, b1) * F(a2, b2) - F(a1, b2) * F(a2, b1);
    }
  }
  return C;
}
template <class T>
T determinant(const Square<T, 3>& F) {
  return F(0, 0) * (F(1, 1) * F(2, 2) - F(1, 2) * F(2, 1)) + F(1, 0) * (F(2, 1) * F(0, 2) - F(2, 2) * F(0, 1)) +
         F(2, 0) * (F(0, 1) * F(1, 2) - F(0, 2) * F(1, 1));
}

template <class T, int D>
T trace(const Square<T, D>& A) {
  T sum = A(0, 0);
  for (int a = 1; a < D; ++a) sum += A(a, a);
  return sum;
}

/// A : A
template <class T, int D>
T squared_norm(const Square<T, D>& A) {
  T sum = A.e[0] * A.e[0];
  for (int k = 1; k < D * D; ++k) sum += A.e[k] * A.e[k];
  return sum;
}

/// Sum of the principal 2 x 2 minors of a symmetric A.
template <class T, int D>
T second_invariant(const Square<T, D>& A) {
  T sum = A(0, 0) * A(1, 1) - A(0, 1) * A(0, 1);
  if constexpr (D == 3) {
    sum += A(1, 1) * A(2, 2) - A(1, 2) * A(1, 2);
    sum += A(2, 2) * A(0, 0) - A(0, 2) * A(0, 2);
  }
  return sum;
}

template <class T, int D>
Square<T, D> multiply(const Square<T, D>& A, const Square<T, D>& B) {
  Square<T, D> C;
  for (int b = 0; b < D; ++b) {
    for (int a = 0; a < D; ++a) {
      T sum = A(a, 0) * B(0, b);
      for (int c = 1; c < D; ++c) sum += A(a, c) * B(c, b);
      C(a, b) = sum;
    }
  }
  return C;
}

/// F^T F - I, written in F - I so that strains far below 1 keep their digits.
template <class T, int D>
Square<T, D> green_strain_twice(const Square<T, D>& F) {
  Square<T, D> H = F, G;
  for (int a = 0; a < D; ++a) H(a, a) -= 1.0;
  for (int b = 0; b < D; ++b) {
    for (int a = 0; a <= b; ++a) {
      T sum = H(0, a) * H(0, b);
      for (int c = 1; c < D; ++c) sum += H(c, a) * H(c, b);
      G(a, b) = G(b, a) = (H(a, b) + H(b, a)) + sum;
    }
  }
  return G;
}

}  // namespace pf
