// The nearest positive semi-definite 2 x 2 and 3 x 3 matrices, for one matrix or a pack of them.
#pragma once

#include "core/math/small_linalg.hpp"

namespace pf {

/// Negative eigenvalues of the symmetric A become zero; A that is definite (its determinant above rounding) is left
/// untouched, to the bit. NaN stays NaN.
template <class T>
void clamp_psd(Square<T, 2>& A) {
  const T half_sum = 0.5 * (A(0, 0) + A(1, 1)), half_gap = 0.5 * (A(0, 0) - A(1, 1)), off = A(0, 1);
  const T radius = square_root(half_gap * half_gap + off * off);
  const T low = half_sum - radius, high = half_sum + radius;
  // With low < 0 < high the projection is high v v^T, v the unit eigenvector of high.
  const T gain = 0.5 * high / radius;
  const auto indefinite = low < 0.0, negative = high <= 0.0;
  const T m00 = select(indefinite, gain * (radius + half_gap), A(0, 0));
  const T m11 = select(indefinite, gain * (radius - half_gap), A(1, 1));
  const T m01 = select(indefinite, gain * off, off);
  A(0, 0) = select(negative, T{}, m00);
  A(1, 1) = select(negative, T{}, m11);
  A(0, 1) = A(1, 0) = select(negative, T{}, m01);
}

namespace detail {

/// One Jacobi rotation that makes A(p, q) zero; columns of Q follow. Says whether any lane had to turn.
template <class T>
bool annihilate(Square<T, 3>& A, Square<T, 3>& Q, int p, int q) {
  const int r = 3 - p - q;
  const T g = A(p, q), d = A(q, q) - A(p, p);
  const auto turn = g * g > 1e-34 * (A(0, 0) * A(0, 0) + A(1, 1) * A(1, 1) + A(2, 2) * A(2, 2));
  if (!any(turn)) return false;
  const T twice = 2.0 * g, root = square_root(d * d + twice * twice);
  const T t = select(turn, twice / select(d < 0.0, d - root, d + root), T{});
  const T c = 1.0 / square_root(1.0 + t * t), s = c * t;
  A(p, p) -= t * g;
  A(q, q) += t * g;
  A(p, q) = A(q, p) = select(turn, T{}, g);
  const T rp = A(r, p), rq = A(r, q);
  A(r, p) = A(p, r) = c * rp - s * rq;
  A(r, q) = A(q, r) = s * rp + c * rq;
  for (int a = 0; a < 3; ++a) {
    const T x = Q(a, p), y = Q(a, q);
    Q(a, p) = c * x - s * y;
    Q(a, q) = s * x + c * y;
  }
  return true;
}

}  // namespace detail

/// Eigenvalues (not sorted) on A's diagonal afterwards, eigenvectors the columns of the result: A = Q diag Q^T to
/// about 1e-15 |A|. Jacobi's method; NaN ends at once.
template <class T>
Square<T, 3> diagonalise(Square<T, 3>& A) {
  Square<T, 3> Q = identity_of<T, 3>();
  for (int sweep = 0; sweep < 10; ++sweep) {
    bool turned = detail::annihilate(A, Q, 0, 1);
    turned |= detail::annihilate(A, Q, 0, 2);
    turned |= detail::annihilate(A, Q, 1, 2);
    if (!turned) break;
  }
  return Q;
}

template <class T>
void clamp_psd(Square<T, 3>& A) {
  const T minor = A(0, 0) * A(1, 1) - A(0, 1) * A(0, 1);
  const auto indefinite = !((A(0, 0) > 0.0) & (minor > 0.0) & (determinant(A) > 0.0));
  if (!any(indefinite)) return;
  const T all = (A(0, 0) + A(1, 1)) + (A(2, 2) + A(0, 1)) + (A(0, 2) + A(1, 2));  // NaN where any entry is
  Square<T, 3> values = A;
  const Square<T, 3> Q = diagonalise(values);
  T clamped[3];
  for (int i = 0; i < 3; ++i) clamped[i] = select(values(i, i) < 0.0, T{}, values(i, i));
  for (int b = 0; b < 3; ++b) {
    for (int a = 0; a <= b; ++a) {
      const T sum = clamped[0] * Q(a, 0) * Q(b, 0) + clamped[1] * Q(a, 1) * Q(b, 1) + clamped[2] * Q(a, 2) * Q(b, 2);
      A(a, b) = A(b, a) = select(indefinite, select(all == all, sum, all), A(a, b));
    }
  }
}

}  // namespace pf
