// What all transfers share.
#include <cmath>

#include "core/grid/records.hpp"
#include "core/grid/stencil.hpp"
#include "core/transfers/moments.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

namespace {

std::size_t at(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

template <int D>
void particles_to_grid(const Plan<D>& plan, const Particles<D>& particles, bool affine, Parallel& parallel,
                       GridState<D>& grid) {
  constexpr int C = D + 1;  // momentum and mass travel together
  Vector& sums = grid.sums;
  sums.setZero(static_cast<Eigen::Index>(plan.node_count()) * C);
  with_nodes_per_axis(plan, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, C, decltype(k)::dense>;
    for_each_block_coloured(plan, parallel, [&](const Block<D>& block, int) {
      double local[S::nodes * C] = {};
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan.batches()[at(i)];
        Wide<lane_count<D>> room[2 * D * K];
        const Wide<lane_count<D>>* const w = plan.weights(i, room);
        using Lane = Wide<lane_count<D>>;
        Lane value[C], flux[D][D];
        const Lane m = value[D] = load_lane<Lane>(particles.mass.data() + batch.first, batch.count);
        load_lanes<D>(particles.v[at(batch.first)].data(), batch.count, value);
        for (int a = 0; a < D; ++a) value[a] *= m;
        if (affine) {
          Lane affine_velocity[D * D];
          load_lanes<D * D>(particles.C[at(batch.first)].data(), batch.count, affine_velocity);
          for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b) flux[a][b] = m * affine_velocity[a + D * b];
          Lane moments[S::values * (decltype(k)::dense ? D : 1)];
          moment_weights<D, K, decltype(k)::dense>(plan, particles, block, batch, w, moments);
          S::template scatter<true, true, 1>(value, flux, w, moments, local + batch.node * C);
        } else {
          S::template scatter<true, false>(value, nullptr, w, w, local + batch.node * C);
        }
      }
      add_block<D, K, C>(plan, block, local, sums.data());
    });
  });
  const Eigen::Index n = plan.node_count();
  grid.mass.resize(n);
  grid.momentum.resize(n * D);
  for (Eigen::Index i = 0; i < n; ++i) {
    grid.momentum.template segment<D>(i * D) = sums.segment<D>(i * C);
    grid.mass[i] = sums[i * C + D];
  }
}

namespace {

/// Nodes whose mass is rounding: their velocity is the mean of the particles of the cells that touch them.
template <int D>
void fill_massless(const Plan<D>& plan, const Particles<D>& particles, const std::vector<char>& massless, Vector& v) {
  const int K = plan.nodes_per_axis(), edge = block_edge + K - 1;
  std::vector<int> count(massless.size(), 0);
  for (const Block<D>& block : plan.blocks())
    for (int i = block.batch_begin; i < block.batch_end; ++i) {
      const Batch& batch = plan.batches()[at(i)];
      for (int n = 0; n < (D == 2 ? K * K : K * K * K); ++n) {
        const std::int32_t node =
            plan.node_table(block)[batch.node + n % K + edge * (n / K % K + edge * (n / (K * K)))];
        if (node < 0 || !massless[at(node)]) continue;
        for (int lane = 0; lane < batch.count; ++lane) {
          v.segment<D>(node * D) += particles.v[at(batch.first + lane)];
          ++count[at(node)];
        }
      }
    }
  for (std::size_t i = 0; i < count.size(); ++i)
    if (count[i] > 0) v.segment<D>(static_cast<Eigen::Index>(i) * D) /= count[i];
}

}  // namespace

template <int D>
void lumped_velocity(const Plan<D>& plan, const Particles<D>& particles, GridState<D>& grid) {
  const Eigen::Index n = grid.mass.size();
  grid.v.resize(n * D);
  const double rounding = 1e-14 * grid.mass.maxCoeff();
  std::vector<char> massless;  // seldom any
  for (Eigen::Index i = 0; i < n; ++i) {
    if (grid.mass[i] > rounding) {
      grid.v.template segment<D>(i * D) = grid.momentum.template segment<D>(i * D) / grid.mass[i];
    } else {
      grid.v.template segment<D>(i * D).setZero();
      massless.resize(static_cast<std::size_t>(n), 0);
      massless[static_cast<std::size_t>(i)] = 1;
    }
  }
  if (!massless.empty()) fill_massless(plan, particles, massless, grid.v);
}

template <int D>
void sharpen_velocity(const MassMatrix<D>& M, int order, Vector& v, const std::vector<HeldNode<D>>& held) {
  if (order < 2) return;
  const Vector& m = M.lumped();
  const double rounding = 1e-14 * m.maxCoeff();
  Vector term = v, product;
  for (const HeldNode<D>& node : held) {
    auto rate = v.segment<D>(node.node * D);
    rate = (node.free * rate + node.value).eval();
  }
  // The first term is what the particles' momentum m v0 has beyond M v, the others what each leaves of the one before.
  for (int k = 1; k < order; ++k) {
    M.multiply(k == 1 ? v : term, product);
    for (Eigen::Index i = 0; i < m.size(); ++i) {
      auto left = term.segment<D>(i * D);
      if (m[i] > rounding)
        left -= product.segment<D>(i * D) / m[i];
      else
        left.setZero();
    }
    for (const HeldNode<D>& node : held) {
      auto left = term.segment<D>(node.node * D);
      left = (node.free * left).eval();
    }
    v += term;
  }
}

template <int D>
void gather_field(const Plan<D>& plan, const Vector& field, Parallel& parallel, std::vector<Vec<D>>& values) {
  with_nodes_per_axis(plan, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D, decltype(k)::dense>;
    for_each_block(plan, parallel, [&](const Block<D>& block, int) {
      double local[S::nodes * D];
      load_block<D, K, D>(plan, block, field.data(), local);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan.batches()[at(i)];
        Wide<lane_count<D>> room[2 * D * K], value[D];
        const Wide<lane_count<D>>* const w = plan.weights(i, room);
        S::template gather<true, false>(local + batch.node * D, w, w, value, nullptr);
        for (int lane = 0; lane < batch.count; ++lane)
          for (int a = 0; a < D; ++a) values[at(batch.first + lane)][a] = value[a][lane];
      }
    });
  });
}

template <int D>
void scatter_field(const Plan<D>& plan, const std::vector<Vec<D>>& values, Parallel& parallel, Vector& field) {
  with_nodes_per_axis(plan, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D, decltype(k)::dense>;
    for_each_block_coloured(plan, parallel, [&](const Block<D>& block, int) {
      double local[S::nodes * D] = {};
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan.batches()[at(i)];
        Wide<lane_count<D>> room[2 * D * K];
        const Wide<lane_count<D>>* const w = plan.weights(i, room);
        Wide<lane_count<D>> value[D] = {};
        for (int lane = 0; lane < batch.count; ++lane)
          for (int a = 0; a < D; ++a) value[a][lane] = values[at(batch.first + lane)][a];
        S::template scatter<true, false>(value, nullptr, w, w, local + batch.node * D);
      }
      add_block<D, K, D>(plan, block, local, field.data());
    });
  });
}

template <int D>
Vec<D> affine_inertia(const BasisInfo& basis, double spacing, const Vec<D>& x) {
  if (basis.affine_by_moments) return Vec<D>::Constant(basis.moment * spacing * spacing);
  Vec<D> inertia = Vec<D>::Zero();
  for (int a = 0; a < D; ++a) {
    double N[max_nodes_per_axis], dN[max_nodes_per_axis];
    long long base = 0;
    const double s = x[a] / spacing;
    basis.weights(s, base, N, dN);
    for (int r = 0; r < basis.nodes_per_axis; ++r) {
      const double distance = static_cast<double>(base + r) - s;
      inertia[a] += N[r] * distance * distance;
    }
  }
  return inertia * spacing * spacing;
}

template <int D>
void affine_inertias(const Plan<D>& plan, const Particles<D>& particles, const Block<D>& block, Mat<D>* inertia) {
  if (plan.regular()) {
    for (std::int32_t p = block.particle_begin; p < block.particle_end; ++p)
      *inertia++ = affine_inertia<D>(plan.basis(), plan.spacing(), particles.x[at(p)]).asDiagonal();
    return;
  }
  with_nodes_per_axis(plan, [&](auto k) {
    constexpr int K = k;
    using Lane = Wide<lane_count<D>>;
    for (int i = block.batch_begin; i < block.batch_end; ++i) {
      const Batch& batch = plan.batches()[at(i)];
      Lane room[2 * D * K], S[D * D];
      second_moments<D, K, decltype(k)::dense>(plan, particles, block, batch, plan.weights(i, room), S);
      for (int lane = 0; lane < batch.count; ++lane, ++inertia)
        for (int c = 0; c < D * D; ++c) (*inertia)(c) = S[c][lane];
    }
  });
}

// NOLINTBEGIN(bugprone-macro-parentheses): D is a template argument.
#define PF_INSTANTIATE(D)                                                                                  \
  template void particles_to_grid<D>(const Plan<D>&, const Particles<D>&, bool, Parallel&, GridState<D>&); \
  template void lumped_velocity<D>(const Plan<D>&, const Particles<D>&, GridState<D>&);                    \
  template void sharpen_velocity<D>(const MassMatrix<D>&, int, Vector&, const std::vector<HeldNode<D>>&);  \
  template void gather_field<D>(const Plan<D>&, const Vector&, Parallel&, std::vector<Vec<D>>&);           \
  template void scatter_field<D>(const Plan<D>&, const std::vector<Vec<D>>&, Parallel&, Vector&);          \
  template Vec<D> affine_inertia<D>(const BasisInfo&, double, const Vec<D>&);                              \
  template void affine_inertias<D>(const Plan<D>&, const Particles<D>&, const Block<D>&, Mat<D>*);
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace pf
