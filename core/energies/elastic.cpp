#include "core/energies/elastic.hpp"

#include <algorithm>
#include <cmath>

#include "core/grid/records.hpp"
#include "core/grid/stencil.hpp"

namespace pf {

namespace {

std::size_t at(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

/// Gradients of the cell's node (ix, iy, iz), a lane a particle.
template <int D, int K>
inline void node_gradient(const Wide<lane_count<D>>* w, int n, Wide<lane_count<D>>* grad) {
  const int ix = n % K, iy = n / K % K;
  if constexpr (D == 2) {
    grad[0] = w[D * K + ix] * w[K + iy];
    grad[1] = w[ix] * w[D * K + K + iy];
  } else {
    const int iz = n / (K * K);
    grad[0] = w[D * K + ix] * w[K + iy] * w[2 * K + iz];
    grad[1] = w[ix] * w[D * K + K + iy] * w[2 * K + iz];
    grad[2] = w[ix] * w[K + iy] * w[D * K + 2 * K + iz];
  }
}

}  // namespace

template <int D>
void ElasticEnergy<D>::deform(const Block<D>& block, const Vector& u) {
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D>;
    double local[S::nodes * D];
    load_block<D, K, D>(plan_, block, u.data(), local);
    for (int i = block.batch_begin; i < block.batch_end; ++i) {
      const Batch& batch = plan_.batches()[at(i)];
      Wide<W> w[2 * D * K];
      plan_.weights(i, w);
      Wide<W> gradient[D][D];
      S::template gather<false, true>(local + batch.node * D, w, w + D * K, nullptr, gradient);
      Wide<W> F_hat[D * D], F_n[D * D], F[D * D];
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) F_hat[a + D * b] = a == b ? gradient[a][b] + 1.0 : gradient[a][b];
      load_lanes<D * D>(particles_.F[at(batch.first)].data(), batch.count, F_n);
      multiply_lanes<D>(F_hat, F_n, F);
      store_lanes<D * D>(F, batch.count, F_[at(batch.first)].data());
    }
  });
}

template <int D>
double ElasticEnergy<D>::block_energy(const Block<D>& block) {
  for (int r = block.run_begin; r < block.run_end; ++r) {
    const MaterialRun& run = plan_.runs()[at(r)];
    const std::size_t n = at(run.end - run.begin);
    laws_[run.material]->energy({F_.data() + run.begin, n}, {psi_.data() + run.begin, n});
  }
  double sum = 0;
  for (int p = block.particle_begin; p < block.particle_end; ++p) sum += particles_.volume0[at(p)] * psi_[at(p)];
  return sum;
}

template <int D>
double ElasticEnergy<D>::ordered_sum() const {
  double sum = 0;
  for (const double s : block_sum_) sum += s;
  return sum;
}

template <int D>
double ElasticEnergy<D>::value(const Vector& u) {
  F_.resize(particles_.size());
  psi_.resize(particles_.size());
  block_sum_.resize(plan_.blocks().size());
  for_each_block(plan_, parallel_, [&](const Block<D>& block, int b) {
    deform(block, u);
    block_sum_[at(b)] = block_energy(block);
  });
  work_.energy += particles_.size();
  return ordered_sum();
}

template <int D>
void ElasticEnergy<D>::block_stress(const Block<D>& block, const std::vector<Mat<D>>& F) {
  for (int r = block.run_begin; r < block.run_end; ++r) {
    const MaterialRun& run = plan_.runs()[at(r)];
    const std::size_t n = at(run.end - run.begin);
    laws_[run.material]->stress({F.data() + run.begin, n}, {psi_.data() + run.begin, n}, {P_.data() + run.begin, n});
  }
}

template <int D>
void ElasticEnergy<D>::batch_flux(const Batch& batch, Wide<W> (*flux)[D]) const {
  Wide<W> P[D * D], F_n[D * D];
  load_lanes<D * D>(P_[at(batch.first)].data(), batch.count, P);
  load_lanes<D * D>(particles_.F[at(batch.first)].data(), batch.count, F_n);
  const auto V = load_lane<Wide<W>>(particles_.volume0.data() + batch.first, batch.count);
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c) {
      Wide<W> sum = P[a] * F_n[c];
      for (int k = 1; k < D; ++k) sum += P[a + D * k] * F_n[c + D * k];
      flux[a][c] = V * sum;
    }
}

template <int D>
void ElasticEnergy<D>::add_force_at_rest(Vector& g) {
  psi_.resize(particles_.size());
  P_.resize(particles_.size());
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int) {
      block_stress(block, particles_.F);
      double local[S::nodes * D] = {};
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[at(i)];
        Wide<W> w[2 * D * K];
        plan_.weights(i, w);
        Wide<W> flux[D][D];
        batch_flux(batch, flux);
        S::template scatter<false, true>(nullptr, flux, w, w + D * K, local + batch.node * D);
      }
      add_block<D, K, D>(plan_, block, local, g.data());
    });
  });
  work_.gradient += particles_.size();
}

template <int D>
double ElasticEnergy<D>::gradient(const Vector& u, Vector& g, Vector& magnitude) {
  F_.resize(particles_.size());
  psi_.resize(particles_.size());
  P_.resize(particles_.size());
  block_sum_.resize(plan_.blocks().size());
  for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int b) {
    deform(block, u);
    block_stress(block, F_);
    double sum = 0;
    for (int p = block.particle_begin; p < block.particle_end; ++p) sum += particles_.volume0[at(p)] * psi_[at(p)];
    block_sum_[at(b)] = sum;
    with_nodes_per_axis(plan_, [&](auto k) {
      constexpr int K = k;
      using S = Stencil<D, K, D>;
      double local[S::nodes * D] = {};
      double local_size[S::nodes] = {};
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[at(i)];
        Wide<W> w[2 * D * K];
        plan_.weights(i, w);
        Wide<W> flux[D][D];
        batch_flux(batch, flux);
        S::template scatter<false, true>(nullptr, flux, w, w + D * K, local + batch.node * D);
        // s_i: the sizes |V P F^nT grad N_i| are not linear, so there is no factorisation over the axes.
        for (int n = 0; n < (D == 2 ? K * K : K * K * K); ++n) {
          Wide<W> grad[D];
          node_gradient<D, K>(w, n, grad);
          Wide<W> square{};
          for (int a = 0; a < D; ++a) {
            Wide<W> f{};
            for (int c = 0; c < D; ++c) f += flux[a][c] * grad[c];
            square += f * f;
          }
          for (int lane = 0; lane < W; ++lane) square[lane] = __builtin_sqrt(square[lane]);
          local_size[batch.node + n % K + S::edge * (n / K % K + S::edge * (n / (K * K)))] += sum_lanes(square);
        }
      }
      add_block<D, K, D>(plan_, block, local, g.data());
      add_block<D, K, 1>(plan_, block, local_size, magnitude.data());
    });
  });
  work_.gradient += particles_.size();
  return ordered_sum();
}

template <int D>
void ElasticEnergy<D>::block_tangents(const Block<D>& block, bool project) {
  constexpr int group = 64;  // particles a call
  float* place[group];
  int i = block.batch_begin;
  for (int r = block.run_begin; r < block.run_end; ++r) {
    const MaterialRun& run = plan_.runs()[at(r)];
    for (int first = run.begin; first < run.end; first += group) {
      const int count = std::min(group, run.end - first);
      for (int p = first; p < first + count; ++p) {
        while (p >= plan_.batches()[at(i)].first + plan_.batches()[at(i)].count) ++i;
        Narrow<W>* batch = tangent_.data() + at(i) * components;
        place[p - first] = reinterpret_cast<float*>(batch) + (p - plan_.batches()[at(i)].first);
      }
      const std::size_t n = at(count);
      laws_[run.material]->grid_tangent({F_.data() + first, n}, {particles_.F.data() + first, n},
                                        {particles_.volume0.data() + first, n}, project, {place, n}, W);
    }
  }
}

template <int D>
void ElasticEnergy<D>::prepare_hessian(const Vector&, bool project) {
  tangent_.resize(plan_.batches().size() * components);
  for_each_block(plan_, parallel_, [&](const Block<D>& block, int) {
    std::fill(tangent_.begin() + block.batch_begin * components, tangent_.begin() + block.batch_end * components,
              Narrow<W>{});
    block_tangents(block, project);
  });
  work_.tangent += particles_.size();
}

template <int D>
void ElasticEnergy<D>::hessian_product(const Vector& p, Vector& Hp) {
  constexpr int n2 = D * D;
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int) {
      double local[S::nodes * D], result[S::nodes * D] = {};
      load_block<D, K, D>(plan_, block, p.data(), local);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[at(i)];
        Wide<W> w[2 * D * K];
        plan_.weights(i, w);
        const Narrow<W>* A = tangent_.data() + at(i) * components;
        Wide<W> gradient[D][D];
        S::template gather<false, true>(local + batch.node * D, w, w + D * K, nullptr, gradient);
        // Each number of the symmetric tangent is read once and used twice.
        Wide<W> flux[D][D] = {};
#pragma GCC unroll 9
        for (int row = 0; row < n2; ++row)
#pragma GCC unroll 9
          for (int column = row; column < n2; ++column) {
            const Wide<W> a = widen<W>(A[packed_tangent_index<D>(row, column)]);
            flux[row % D][row / D] += a * gradient[column % D][column / D];
            if (column != row) flux[column % D][column / D] += a * gradient[row % D][row / D];
          }
        S::template scatter<false, true>(nullptr, flux, w, w + D * K, result + batch.node * D);
      }
      add_block<D, K, D>(plan_, block, result, Hp.data());
    });
  });
  work_.hessian_product += particles_.size();
}

namespace {

/// T[a][c][b] = sum_d A_{ab,cd} grad_d: half of the contraction of a tangent with two gradients.
template <int D>
inline void contract(const Narrow<lane_count<D>>* A, const Wide<lane_count<D>>* grad, Wide<lane_count<D>> (*T)[D][D]) {
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c)
      for (int b = 0; b < D; ++b) {
        Wide<lane_count<D>> sum{};
        for (int d = 0; d < D; ++d) {
          const int row = a + D * b, column = c + D * d;
          sum +=
              widen<lane_count<D>>(A[packed_tangent_index<D>(std::min(row, column), std::max(row, column))]) * grad[d];
        }
        T[a][c][b] = sum;
      }
}

}  // namespace

/// The diagonal blocks of one batch, upper halves row by row, added to the cell's nodes `out`. grad_b grad_d of a node
/// is a product of N^2, N N' and N'^2 of the axes, so one axis after the other, as in core/grid/stencil.hpp.
template <int D, int K>
inline void scatter_diagonal(const Narrow<lane_count<D>>* A, const Wide<lane_count<D>>* w, double* out) {
  using Lane = Wide<lane_count<D>>;
  constexpr int C = D * (D + 1) / 2, edge = Stencil<D, K, 1>::edge, z = D - 1;
  Lane NN[D * K], Nd[D * K], dd[D * K];
  for (int r = 0; r < D * K; ++r) {
    NN[r] = w[r] * w[r];
    Nd[r] = w[r] * w[D * K + r];
    dd[r] = w[D * K + r] * w[D * K + r];
  }
  // Of grad_b grad_d, b <= d, in each component.
  Lane part[D][D][C];
  for (int b = 0; b < D; ++b)
    for (int d = b; d < D; ++d)
      for (int a = 0, m = 0; a < D; ++a)
        for (int c = a; c < D; ++c, ++m) {
          const int p = a + D * b, q = c + D * d, r = a + D * d, s = c + D * b;
          part[b][d][m] = widen<lane_count<D>>(A[packed_tangent_index<D>(std::min(p, q), std::max(p, q))]);
          if (b != d) part[b][d][m] += widen<lane_count<D>>(A[packed_tangent_index<D>(std::min(r, s), std::max(r, s))]);
        }
  for (int k = 0; k < (D == 3 ? K : 1); ++k)
    for (int j = 0; j < K; ++j) {
      Lane row[K * C];
      for (int m = 0; m < C; ++m) {
        Lane xx = part[0][0][m], xy = part[0][1][m], yy = part[1][1][m], x0{}, y0{}, zz{};
        if constexpr (D == 3) {
          xx *= NN[z * K + k], xy *= NN[z * K + k], yy *= NN[z * K + k];
          x0 = part[0][z][m] * Nd[z * K + k];
          y0 = part[1][z][m] * Nd[z * K + k];
          zz = part[z][z][m] * dd[z * K + k];
        }
        const Lane of_dd = xx * NN[K + j], of_Nd = xy * Nd[K + j] + x0 * NN[K + j];
        const Lane of_NN = yy * dd[K + j] + y0 * Nd[K + j] + zz * NN[K + j];
        for (int i = 0; i < K; ++i) row[i * C + m] = of_dd * dd[i] + of_Nd * Nd[i] + of_NN * NN[i];
      }
      add_lane_sums<K * C>(row, out + edge * (j + edge * k) * C);
    }
}

template <int D>
void ElasticEnergy<D>::diagonal(std::vector<Mat<D>>& blocks) {
  constexpr int symmetric = D * (D + 1) / 2;
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, 1>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int) {
      double local[S::nodes * symmetric] = {};
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        Wide<W> w[2 * D * K];
        plan_.weights(i, w);
        scatter_diagonal<D, K>(tangent_.data() + at(i) * components, w,
                               local + plan_.batches()[at(i)].node * symmetric);
      }
      const std::int32_t* table = plan_.node_table(block);
      for (int n = 0; n < S::nodes; ++n) {
        if (table[n] < 0) continue;
        Mat<D>& H = blocks[at(table[n])];
        int m = n * symmetric;
        for (int a = 0; a < D; ++a)
          for (int c = a; c < D; ++c, ++m) {
            H(a, c) += local[m];
            if (a != c) H(c, a) += local[m];
          }
      }
    });
  });
  work_.diagonal += particles_.size();
}

template <int D>
void ElasticEnergy<D>::assemble(BlockMatrix<D>& H) {
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k, count = D == 2 ? K * K : K * K * K;
    constexpr int edge = Stencil<D, K, 1>::edge;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int) {
      const std::int32_t* table = plan_.node_table(block);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[at(i)];
        const Narrow<W>* A = tangent_.data() + at(i) * components;
        Wide<W> w[2 * D * K], grad[count][D];
        plan_.weights(i, w);
        for (int n = 0; n < count; ++n) node_gradient<D, K>(w, n, grad[n]);
        for (int n = 0; n < count; ++n) {
          Wide<W> T[D][D][D];
          contract<D>(A, grad[n], T);
          const std::int32_t column = table[batch.node + n % K + edge * (n / K % K + edge * (n / (K * K)))];
          for (int m = 0; m < count; ++m) {
            const std::int32_t row = table[batch.node + m % K + edge * (m / K % K + edge * (m / (K * K)))];
            if (row < column) continue;
            Mat<D>& h = H.at(row, column);
            for (int a = 0; a < D; ++a)
              for (int c = 0; c < D; ++c) {
                Wide<W> sum{};
                for (int b = 0; b < D; ++b) sum += T[a][c][b] * grad[m][b];
                h(a, c) += sum_lanes(sum);
              }
          }
        }
      }
    });
  });
  work_.assembly += particles_.size();
}

template class ElasticEnergy<2>;
template class ElasticEnergy<3>;

}  // namespace pf
