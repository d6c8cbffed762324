// What F-bar (core/energies/volume_patches.hpp) adds to the elastic energy's Hessian: beside tangents of particles, for
// each patch a coupling of the cell's nodes
//
//     a b^T + b a^T + k b b^T,   b = d ln J~ / du,
//
// two vectors and a number. Its nodes share a cell, so it lies within the pattern of the particles' own part.
#pragma once

#include "core/energies/volume_patches.hpp"
#include "core/grid/stencil.hpp"

namespace pf {

/// A block's particles at a displacement.
template <int D>
struct BarredBlock {
  std::vector<Mat<D>> hat, F;   ///< F^, and F or F-bar
  std::vector<double> stretch;  ///< (J~ / J^)^(1/D)
  std::vector<double> share;    ///< part of the patch's volume; 0: in no patch
  std::vector<double> psi;
  std::vector<Mat<D>> P, flux;  ///< flux: sum_p flux_p : grad N_i is the force on node i
  bool feasible = true;
};

/// Numbers that a patch's coupling is kept in: a and b, D components a node of the cell, and k.
template <int D, int K>
struct PatchCoupling {
  static constexpr int nodes = D == 2 ? K * K : K * K * K, values = nodes * D, size = 2 * values + 1;
  const double *a, *b;
  double k;
  explicit PatchCoupling(const double* numbers) : a(numbers), b(numbers + values), k(numbers[size - 1]) {}
  /// Entry (row component r of node m, component c of node n).
  double operator()(int m, int r, int n, int c) const {
    const double b_m = b[m * D + r], b_n = b[n * D + c];
    return a[m * D + r] * b_n + b_m * a[n * D + c] + k * b_m * b_n;
  }
};

/// body(coupling, the cell's first node in the block's lattice) for the patches of block b.
template <int D, int K, class Body>
void for_each_coupling(const ElasticMemory& memory, int b, Body&& body) {
  const auto at = static_cast<std::size_t>(b);
  for (std::int32_t i = memory.patch_start[at]; i < memory.patch_start[at + 1]; ++i) {
    const auto patch = static_cast<std::size_t>(i);
    body(PatchCoupling<D, K>(memory.patch_coupling.data() + patch * PatchCoupling<D, K>::size),
         memory.patch_node[patch]);
  }
}

template <int D>
template <int K>
void ElasticEnergy<D>::couple(int b, const double* p, double* Hp) const {
  for_each_coupling<D, K>(memory_, b, [&](const PatchCoupling<D, K>& patch, int first) {
    double along_a = 0, along_b = 0;
    for (int n = 0; n < patch.nodes; ++n)
      for (int c = 0; c < D; ++c) {
        const double x = p[(first + node_offset<D, K>(n)) * D + c];
        along_a += patch.a[n * D + c] * x;
        along_b += patch.b[n * D + c] * x;
      }
    const double of_b = along_a + patch.k * along_b;
    for (int n = 0; n < patch.nodes; ++n)
      for (int c = 0; c < D; ++c)
        Hp[(first + node_offset<D, K>(n)) * D + c] += patch.a[n * D + c] * along_b + patch.b[n * D + c] * of_b;
  });
}

template <int D>
template <int K>
void ElasticEnergy<D>::couple_diagonal(int b, double* upper) const {
  for_each_coupling<D, K>(memory_, b, [&](const PatchCoupling<D, K>& patch, int first) {
    for (int n = 0; n < patch.nodes; ++n) {
      double* to = upper + (first + node_offset<D, K>(n)) * D * (D + 1) / 2;
      for (int r = 0; r < D; ++r)
        for (int c = r; c < D; ++c) *to++ += patch(n, r, n, c);
    }
  });
}

template <int D>
template <int K>
void ElasticEnergy<D>::couple_blocks(const Block<D>& block, int b, BlockMatrix<D>& H) const {
  const std::int32_t* const table = plan_.node_table(block);
  for_each_coupling<D, K>(memory_, b, [&](const PatchCoupling<D, K>& patch, int first) {
    for (int n = 0; n < patch.nodes; ++n)
      for (int m = 0; m < patch.nodes; ++m) {
        const std::int32_t row = table[first + node_offset<D, K>(m)], column = table[first + node_offset<D, K>(n)];
        if (column < 0 || row < column) continue;
        Mat<D>& h = H.at(row, column);
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) h(r, c) += patch(m, r, n, c);
      }
  });
}

template <int D>
template <int K>
void ElasticEnergy<D>::couple_stencil(const Block<D>& block, int b, const std::vector<std::int32_t>& row_of,
                                      StencilMatrix<D>& H) const {
  constexpr int R = K - 1, nodes = PatchCoupling<D, K>::nodes, edge = Stencil<D, K, 1>::edge;
  const std::int32_t* const table = plan_.node_table(block);
  // Of the layout's own axes, the fastest first: a node's place in the block's lattice and in the coupling.
  int offset[nodes] = {}, own[nodes] = {};
  for (int n = 0; n < nodes; ++n)
    for (int j = 0, rest = n; j < D; ++j, rest /= K) {
      const int axis = H.layout->axes()[static_cast<std::size_t>(j)];
      offset[n] += rest % K * (axis == 0 ? 1 : axis == 1 ? edge : edge * edge);
      own[n] += rest % K * (axis == 0 ? 1 : axis == 1 ? K : K * K);
    }
  for_each_coupling<D, K>(memory_, b, [&](const PatchCoupling<D, K>& patch, int first) {
    for (int m = 0; m < nodes; ++m) {
      const std::int32_t node = table[first + offset[m]];
      if (node < 0) continue;
      const std::int32_t row = row_of[static_cast<std::size_t>(node)];
      const int i = m % K, line = m / K;
      for (int n = 0; n < m; ++n) {
        const int j = n % K, other = n / K, dy = other % K - line % K, dz = other / K - line / K;
        const int place = D == 2 ? dy + R : (dz + R) * (2 * R + 1) + dy + R;
        float* const to = H.row(row) + static_cast<std::ptrdiff_t>(place) * D * H.width + D * (R - i + j);
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) to[r * H.width + c] += static_cast<float>(patch(own[m], r, own[n], c));
      }
      for (int r = 0; r < D; ++r)
        for (int c = 0; c < D; ++c) H.diagonal_block(row)[r + D * c] += static_cast<float>(patch(own[m], r, own[m], c));
    }
  });
}

}  // namespace pf
