// Isotropic laws from their principal stretches: F = U diag(s) V^T, psi = psi(s).
//   P = U diag(P_i) V^T,   P_i = dpsi/ds_i
// In the frame of U and V the tangent falls apart into the D x D block psi_ij = d2psi/ds_i ds_j and, for each pair
// i < j, a 2 x 2 block on (dF_ij, dF_ji) with eigenvalues and eigenvectors
//   flip   (P_i - P_j)/(s_i - s_j)   (1,  1)/sqrt 2
//   twist  (P_i + P_j)/(s_i + s_j)   (1, -1)/sqrt 2
// (Stomakhin et al. 2012; Smith et al. 2019). Both are given by the law in closed form, so equal stretches need no
// care here, and clamping these few eigenvalues is the exact projection of the whole tangent.
#pragma once

#include "core/math/psd.hpp"
#include "core/math/svd.hpp"

namespace pf {

/// Upper half (row <= column) of dP/dF in the index order of Tangent<D>; the lower half is not set.
template <class T, int D>
using UpperTangent = Square<T, D * D>;

/// The pair of directions without direction k: (1, 2), (2, 0), (0, 1); in 2D the one pair is (0, 1).
template <int D>
struct Pair {
  static constexpr int count = D == 2 ? 1 : 3;
  int i, j;
  explicit constexpr Pair(int k) : i(D == 2 ? 0 : (k + 1) % 3), j(D == 2 ? 1 : (k + 2) % 3) {}
};

/// dP/dF in the principal frame.
template <class T, int D>
struct PrincipalTangent {
  Square<T, D> block;  ///< psi_ij, symmetric
  T flip[Pair<D>::count], twist[Pair<D>::count];
};

/// U diag(x) V^T
template <class T, int D>
Square<T, D> from_principal(const Svd<T, D>& svd, const T (&x)[D]) {
  Square<T, D> P;
  for (int b = 0; b < D; ++b) {
    T row[D];
    for (int i = 0; i < D; ++i) row[i] = x[i] * svd.V(b, i);
    for (int a = 0; a < D; ++a) {
      T sum = svd.U(a, 0) * row[0];
      for (int i = 1; i < D; ++i) sum += svd.U(a, i) * row[i];
      P(a, b) = sum;
    }
  }
  return P;
}

/// The nearest positive semi-definite tangent.
template <class T, int D>
void clamp_psd(PrincipalTangent<T, D>& tangent) {
  clamp_psd(tangent.block);
  for (int k = 0; k < Pair<D>::count; ++k) {
    tangent.flip[k] = select(tangent.flip[k] < 0.0, T{}, tangent.flip[k]);
    tangent.twist[k] = select(tangent.twist[k] < 0.0, T{}, tangent.twist[k]);
  }
}

namespace detail {

/// vec(u_i v_j^T)
template <class T, int D>
void dyad(const Svd<T, D>& svd, int i, int j, T (&out)[D * D]) {
  for (int b = 0; b < D; ++b)
    for (int a = 0; a < D; ++a) out[a + D * b] = svd.U(a, i) * svd.V(b, j);
}

/// A += x y^T (upper half)
template <class T, int D>
void add_outer(const T (&x)[D * D], const T (&y)[D * D], UpperTangent<T, D>& A) {
  for (int column = 0; column < D * D; ++column)
    for (int row = 0; row <= column; ++row) A(row, column) += x[row] * y[column];
}

}  // namespace detail

/// Back to the frame of F.
template <class T, int D>
void from_principal(const Svd<T, D>& svd, const PrincipalTangent<T, D>& tangent, UpperTangent<T, D>& A) {
  T normal[D][D * D];
  for (int i = 0; i < D; ++i) detail::dyad(svd, i, i, normal[i]);
  for (T& entry : A.e) entry = T{};
  for (int i = 0; i < D; ++i) {
    T weighted[D * D];
    for (int k = 0; k < D * D; ++k) {
      weighted[k] = tangent.block(i, 0) * normal[0][k];
      for (int j = 1; j < D; ++j) weighted[k] += tangent.block(i, j) * normal[j][k];
    }
    detail::add_outer<T, D>(normal[i], weighted, A);
  }
  for (int k = 0; k < Pair<D>::count; ++k) {
    const Pair<D> pair(k);
    T ij[D * D], ji[D * D], even[D * D], odd[D * D];
    detail::dyad(svd, pair.i, pair.j, ij);
    detail::dyad(svd, pair.j, pair.i, ji);
    for (int n = 0; n < D * D; ++n) {
      const T sum = ij[n] + ji[n], difference = ij[n] - ji[n];
      ij[n] = sum;
      ji[n] = difference;
      even[n] = (0.5 * tangent.flip[k]) * sum;
      odd[n] = (0.5 * tangent.twist[k]) * difference;
    }
    detail::add_outer<T, D>(ij, even, A);
    detail::add_outer<T, D>(ji, odd, A);
  }
}

/// out = (F_n (x) I) A (F_n (x) I)^T, upper halves: out_{aB,bD} = sum_EG F_n_BE F_n_DG A_{aE,bG}.
template <class T, int D>
void push_forward(const Square<T, D>& F_n, const UpperTangent<T, D>& A, UpperTangent<T, D>& out) {
  const auto entry = [&A](int row, int column) { return row <= column ? A(row, column) : A(column, row); };
  for (int b = 0; b < D; ++b) {
    for (int a = 0; a < D; ++a) {
      // The D x D piece of the rows (a, .) and the columns (b, .): C -> F_n C F_n^T.
      T half[D][D];
      for (int g = 0; g < D; ++g) {
        for (int B = 0; B < D; ++B) {
          T sum = F_n(B, 0) * entry(a, b + D * g);
          for (int e = 1; e < D; ++e) sum += F_n(B, e) * entry(a + D * e, b + D * g);
          half[B][g] = sum;
        }
      }
      for (int d = 0; d < D; ++d) {
        for (int B = 0; B < D; ++B) {
          if (a + D * B > b + D * d) continue;
          T sum = F_n(d, 0) * half[B][0];
          for (int g = 1; g < D; ++g) sum += F_n(d, g) * half[B][g];
          out(a + D * B, b + D * d) = sum;
        }
      }
    }
  }
}

}  // namespace pf
