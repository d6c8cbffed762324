#include "core/grid/domain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pf {

namespace {

/// Way across its main axis of a piece of a domain, over dx.
constexpr double longest_way[] = {1.0 / 16, 1.0 / 8};
/// A domain is not thinner than this, over dx: differences over its width would be rounding.
constexpr double least_width = 1e-6;

template <int D>
void shrink(Wide<lane_count<D>>* edge, int count, int& shrunk) {
  for (int lane = 0; lane < count; ++lane) {
    double reach = 0;
    for (int a = 0; a < D; ++a) {
      double sum = 0;
      for (int b = 0; b < D; ++b) sum += std::abs(edge[a + D * b][lane]);
      reach = std::max(reach, sum);
    }
    if (reach <= 1) continue;
    if (reach > 1 + 1e-9) ++shrunk;
    for (int k = 0; k < D * D; ++k) edge[k][lane] /= reach;
  }
}

/// Into how many pieces each particle's edges are cut, a lane a particle.
template <int D>
struct Pieces {
  Wide<lane_count<D>> count[D];
  std::array<int, D> most;
};

template <int D>
Pieces<D> pieces_of(const Wide<lane_count<D>>* edge, int count) {
  Pieces<D> pieces;
  pieces.most.fill(1);
  for (int b = 0; b < D; ++b) {
    pieces.count[b] = Wide<lane_count<D>>{} + 1;
    for (int lane = 0; lane < count; ++lane) {
      double most = 0, second = 0;
      for (int a = 0; a < D; ++a) {
        const double way = std::abs(edge[a + D * b][lane]);
        second = std::max(second, std::min(way, most));
        most = std::max(most, way);
      }
      const double n = std::max(1.0, std::ceil(second / longest_way[D - 2] - 1e-6));
      pieces.count[b][lane] = n;
      pieces.most[static_cast<std::size_t>(b)] =
          std::max(pieces.most[static_cast<std::size_t>(b)], static_cast<int>(n));
    }
  }
  return pieces;
}

template <int D, int K>
struct Means {
  using Lane = Wide<lane_count<D>>;
  static constexpr int nodes = D == 2 ? K * K : K * K * K;

  static void add_piece(const Lane* N, const Lane* dN, Lane* w) {
    for (int n = 0, k = 0; k < (D == 3 ? K : 1); ++k)
      for (int j = 0; j < K; ++j) {
        Lane both = N[K + j], along_y = dN[K + j], along_z{};
        if constexpr (D == 3) {
          along_z = both * dN[2 * K + k];
          both *= N[2 * K + k];
          along_y *= N[2 * K + k];
        }
        for (int i = 0; i < K; ++i, ++n) {
          w[n] += N[i] * both;
          w[nodes + n] += dN[i] * both;
          w[2 * nodes + n] += N[i] * along_y;
          if constexpr (D == 3) w[3 * nodes + n] += N[i] * along_z;
        }
      }
  }

  static void compute(const BasisInfo& basis, const Lane* t, const Lane* edge, const Pieces<D>& pieces, Lane* w) {
    for (int k = 0; k < (D + 1) * nodes; ++k) w[k] = Lane{};
    int total = 1;
    for (const int n : pieces.most) total *= n;
    Lane width[D];
    for (int a = 0; a < D; ++a) {
      width[a] = Lane{} + least_width;
      for (int b = 0; b < D; ++b) {
        const Lane e = edge[a + D * b] / pieces.count[b], size = e < 0 ? -e : e;
        width[a] = size > width[a] ? size : width[a];
      }
    }
    for (int q = 0; q < total; ++q) {
      Lane at[D], N[D * K], dN[D * K], share = Lane{} + 1;
      for (int a = 0; a < D; ++a) at[a] = t[a];
      for (int b = 0, rest = q; b < D; ++b) {
        const int n = pieces.most[static_cast<std::size_t>(b)];
        const Lane here = Lane{} + rest % n, &count = pieces.count[b];  // of no particle with fewer pieces
        const Lane part = here < count ? (here + 0.5) / count - 0.5 : Lane{};
        share *= here < count ? 1 / count : Lane{};
        rest /= n;
        for (int a = 0; a < D; ++a) at[a] += part * edge[a + D * b];
      }
      for (int a = 0; a < D; ++a) {
        if constexpr (D == 2)
          basis.mean_four(at[a], width[a], N + a * K, dN + a * K);
        else
          basis.mean_eight(at[a], width[a], N + a * K, dN + a * K);
      }
      for (int i = 0; i < K; ++i) N[i] *= share, dN[i] *= share;
      add_piece(N, dN, w);
    }
  }
};

}  // namespace

template <int D>
void domain_weights(const BasisInfo& basis, const Wide<lane_count<D>>* t, const Wide<lane_count<D>>* edge, int count,
                    Wide<lane_count<D>>* w, int& shrunk) {
  Wide<lane_count<D>> fit[D * D];
  std::copy_n(edge, D * D, fit);
  shrink<D>(fit, count, shrunk);
  const Pieces<D> pieces = pieces_of<D>(fit, count);
  if (basis.nodes_per_axis == 3)
    Means<D, 3>::compute(basis, t, fit, pieces, w);
  else
    Means<D, 4>::compute(basis, t, fit, pieces, w);
}

template <int D>
std::vector<DomainPiece> domain_pieces(const double* edge, int axis) {
  Wide<lane_count<D>> fit[D * D] = {};
  for (int k = 0; k < D * D; ++k) fit[k][0] = edge[k];
  int shrunk = 0;
  shrink<D>(fit, 1, shrunk);
  const Pieces<D> cut = pieces_of<D>(fit, 1);
  std::vector<DomainPiece> pieces{{0, least_width, 1}};
  for (int b = 0; b < D; ++b) {
    const int n = cut.most[static_cast<std::size_t>(b)];
    const double e = fit[axis + D * b][0] / n;
    std::vector<DomainPiece> finer;
    for (const DomainPiece& p : pieces)
      for (int k = 0; k < n; ++k)
        finer.push_back({p.at + (k + 0.5 - 0.5 * n) * e, std::max(p.width, std::abs(e)), p.share / n});
    pieces = std::move(finer);
  }
  return pieces;
}

template std::vector<DomainPiece> domain_pieces<2>(const double*, int);
template std::vector<DomainPiece> domain_pieces<3>(const double*, int);
template void domain_weights<2>(const BasisInfo&, const Wide<4>*, const Wide<4>*, int, Wide<4>*, int&);
template void domain_weights<3>(const BasisInfo&, const Wide<8>*, const Wide<8>*, int, Wide<8>*, int&);

}  // namespace pf
