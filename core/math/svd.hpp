// Singular values of 2 x 2 and 3 x 3 matrices, for one matrix or a pack of them.
#pragma once

#include "core/math/small_linalg.hpp"

namespace pf {

/// F = U diag(s) V^T with rotations U, V (det = +1) and s[0] >= s[1] >= ... in size; only the last s may be
/// negative, and is where det F < 0 ("rotation variant", Irving et al. 2004). U, V and F are reproduced to about
/// 1e-15 of |F|. Each lane depends on its own F only. An F with NaN or infinity gives at least one s = NaN.
template <class T, int D>
struct Svd {
  Square<T, D> U, V;
  T s[D];
};

namespace detail {

/// The power of two 2^k <= max |F_ab| < 2^(k+1), so that dividing by it is exact; 1 for F = 0 and subnormal F.
template <class T, int D>
T power_of_two_below(const Square<T, D>& F) {
  using Bits = typename Lanes<T>::Bits;
  T largest{};
  for (const T& entry : F.e) {
    const T size = absolute(entry);
    largest = select(size > largest, size, largest);
  }
  const Bits exponent = std::bit_cast<Bits>(largest) & std::uint64_t{0x7ff0000000000000};
  // Above 2^1022 the reciprocal would be subnormal; such a matrix is no deformation.
  return select(largest < 0x1p-1021, broadcast<T>(1), std::bit_cast<T>(exponent));
}

/// c, s of the rotation by half of the angle whose cosine and sine are c2, s2.
template <class T>
void half_angle(const T& c2, const T& s2, T& c, T& s) {
  const auto near = c2 >= 0.0;
  const T x = select(near, 1.0 + c2, s2), y = select(near, s2, 1.0 - c2);
  const T scale = 1.0 / square_root(x * x + y * y);
  c = x * scale;
  s = y * scale;
}

}  // namespace detail

/// Closed form: F = q R(theta) + r M(phi), M a reflection; s = q +- r.
template <class T>
Svd<T, 2> svd(const Square<T, 2>& F) {
  const T one = broadcast<T>(1), scale = detail::power_of_two_below(F), factor = 0.5 / scale;
  const T x = (F(0, 0) + F(1, 1)) * factor, y = (F(1, 0) - F(0, 1)) * factor;
  const T z = (F(0, 0) - F(1, 1)) * factor, w = (F(1, 0) + F(0, 1)) * factor;
  const T q = square_root(x * x + y * y), r = square_root(z * z + w * w);
  const T per_q = 1.0 / q, per_r = 1.0 / r;
  const auto no_q = !(q > 1e-150), no_r = !(r > 1e-150);
  const T cos_theta = select(no_q, one, x * per_q), sin_theta = select(no_q, T{}, y * per_q);
  const T cos_phi = select(no_r, cos_theta, z * per_r), sin_phi = select(no_r, sin_theta, w * per_r);
  T c, s;
  detail::half_angle<T>(cos_phi * cos_theta + sin_phi * sin_theta, sin_phi * cos_theta - cos_phi * sin_theta, c, s);
  Svd<T, 2> result;
  result.V = {{c, s, -s, c}};
  const T cu = c * cos_theta - s * sin_theta, su = s * cos_theta + c * sin_theta;
  result.U = {{cu, su, -su, cu}};
  const T largest = q + r;
  // det / s0 keeps the digits of a small s1, which q - r would lose.
  const T det = 4.0 * ((F(0, 0) * factor) * (F(1, 1) * factor) - (F(0, 1) * factor) * (F(1, 0) * factor));
  result.s[0] = largest * scale;
  result.s[1] = select(largest > 0.0, det / largest, largest) * scale;
  return result;
}

namespace detail {

template <class T>
T squared_length(const Square<T, 3>& B, int column) {
  return B(0, column) * B(0, column) + B(1, column) * B(1, column) + B(2, column) * B(2, column);
}

/// Turns columns p and q so that those of B become orthogonal (one-sided Jacobi). To save a square root and to take
/// a division off the critical path, the rotation is left unscaled: the columns of B and V then are the true ones
/// times 1/sqrt(w). Says whether any lane still had to turn by more than rounding.
template <class T>
[[gnu::always_inline]] inline bool orthogonalise_columns(Square<T, 3>& B, Square<T, 3>& V, T (&w)[3], int p, int q) {
  const auto dot = [&B](int i, int j) { return B(0, i) * B(0, j) + B(1, i) * B(1, j) + B(2, i) * B(2, j); };
  const T a = dot(p, p), b = dot(q, q), g = dot(p, q);
  const auto turn = g * g > 1e-31 * (a * b);
  if (!any(turn)) return false;
  const T d = b * w[q] - a * w[p], twice = 2.0 * g;
  const T root = square_root(d * d + (twice * twice) * (w[p] * w[q]));
  const T slope = select(turn, twice / select(d < 0.0, d - root, d + root), T{});
  const T to_p = slope * w[q], to_q = slope * w[p];  // tan(angle) times the ratio of the columns' scales
  const T cos_squared = 1.0 / (1.0 + to_p * to_q);
  w[p] *= cos_squared;
  w[q] *= cos_squared;
  for (int row = 0; row < 3; ++row) {
    for (Square<T, 3>* M : {&B, &V}) {
      const T x = (*M)(row, p), y = (*M)(row, q);
      (*M)(row, p) = x - to_p * y;
      (*M)(row, q) = y + to_q * x;
    }
  }
  return true;
}

/// Where column p is the shorter one: exchanges columns p and q, turning one round so that det V stays +1.
template <class T>
[[gnu::always_inline]] inline void order_columns(Square<T, 3>& B, Square<T, 3>& V, T (&length)[3], int p, int q) {
  const auto exchange = length[p] < length[q];
  for (Square<T, 3>* M : {&B, &V}) {
    for (int a = 0; a < 3; ++a) {
      const T x = (*M)(a, p), y = (*M)(a, q);
      (*M)(a, p) = select(exchange, y, x);
      (*M)(a, q) = select(exchange, -x, y);
    }
  }
  const T x = length[p], y = length[q];
  length[p] = select(exchange, y, x);
  length[q] = select(exchange, x, y);
}

/// A unit vector in `out` orthogonal to the unit vector u.
template <class T>
[[gnu::always_inline]] inline void any_orthogonal(const T (&u)[3], T (&out)[3]) {
  const auto along_x = u[0] * u[0] > 0.5;  // then (-y, x, 0) is long enough, else (0, -z, y)
  const T x = select(along_x, -u[1], T{}), y = select(along_x, u[0], -u[2]), z = select(along_x, T{}, u[1]);
  const T scale = 1.0 / square_root(x * x + y * y + z * z);
  out[0] = x * scale;
  out[1] = y * scale;
  out[2] = z * scale;
}

/// U and s from the orthogonal columns of B = U diag(s), longest first; scale is put back into s.
template <class T>
[[gnu::always_inline]] inline void columns_to_rotation(const Square<T, 3>& B, const T& scale, Svd<T, 3>& out) {
  const T one = broadcast<T>(1);
  T u[3], v[3], w[3];
  const T n0 = square_root(B(0, 0) * B(0, 0) + B(1, 0) * B(1, 0) + B(2, 0) * B(2, 0));
  const auto some = n0 > 1e-140;
  const T per_n0 = 1.0 / n0;
  for (int a = 0; a < 3; ++a) u[a] = select(some, B(a, 0) * per_n0, a == 0 ? one : T{});
  const T along = u[0] * B(0, 1) + u[1] * B(1, 1) + u[2] * B(2, 1);
  for (int a = 0; a < 3; ++a) v[a] = B(a, 1) - along * u[a];
  const T n1 = square_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  const auto plane = n1 > 1e-140;
  const T per_n1 = 1.0 / n1;
  any_orthogonal(u, w);
  for (int a = 0; a < 3; ++a) v[a] = select(plane, v[a] * per_n1, w[a]);
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    w[a] = u[b] * v[c] - u[c] * v[b];
    out.U(a, 0) = u[a];
    out.U(a, 1) = v[a];
  }
  for (int a = 0; a < 3; ++a) out.U(a, 2) = w[a];
  out.s[0] = n0 * scale;
  out.s[1] = n1 * scale;
  out.s[2] = (w[0] * B(0, 2) + w[1] * B(1, 2) + w[2] * B(2, 2)) * scale;
}

}  // namespace detail

/// One-sided Jacobi (Hestenes 1958), which unlike the eigenvalues of F^T F keeps the digits of small singular values.
template <class T>
Svd<T, 3> svd(const Square<T, 3>& F) {
  Svd<T, 3> result;
  const T scale = detail::power_of_two_below(F), factor = 1.0 / scale;
  Square<T, 3> B = F;
  for (T& entry : B.e) entry *= factor;
  result.V = identity_of<T, 3>();
  // Quadratic convergence: four sweeps are usual. The bound only matters for NaN-like input, and NaN never turns.
  T w[3] = {broadcast<T>(1), broadcast<T>(1), broadcast<T>(1)}, length[3];
  for (int sweep = 0; sweep < 12; ++sweep) {
    bool turned = detail::orthogonalise_columns(B, result.V, w, 0, 1);
    turned |= detail::orthogonalise_columns(B, result.V, w, 0, 2);
    turned |= detail::orthogonalise_columns(B, result.V, w, 1, 2);
    if (!turned) break;
  }
  for (int i = 0; i < 3; ++i) {
    const T per_v = 1.0 / square_root(detail::squared_length(result.V, i));
    for (int a = 0; a < 3; ++a) {
      result.V(a, i) *= per_v;
      B(a, i) *= per_v;
    }
    length[i] = detail::squared_length(B, i);
  }
  detail::order_columns(B, result.V, length, 0, 1);
  detail::order_columns(B, result.V, length, 0, 2);
  detail::order_columns(B, result.V, length, 1, 2);
  detail::columns_to_rotation(B, scale, result);
  return result;
}

}  // namespace pf
