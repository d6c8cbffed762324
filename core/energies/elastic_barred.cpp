// The elastic energy where particles share their changes of volume (F-bar, core/energies/volume_patches.hpp): value and
// forces. With T_p = V_p^0 dpsi/dF(F-bar_p) : F-bar_p, F-bar changes with F^_p itself and with ln J~, so that
// dE/dF^_p = V_p^0 s_p P F_n^T - (T_p - w_p sum_q T_q) F^_p^-T / D, w_p the share of the patch's volume.
#include <Eigen/LU>
#include <limits>

#include "core/energies/elastic_kernels.hpp"
#include "core/energies/elastic_patches.hpp"
#include "core/grid/records.hpp"

namespace pf {

template <int D>
void ElasticEnergy<D>::deform_block(const Block<D>& block, const Vector* u, BarredBlock<D>& state) const {
  const auto n = index(block.particle_end - block.particle_begin);
  state.hat.assign(n, Mat<D>::Identity());
  state.F.resize(n);
  state.stretch.assign(n, 1);
  state.share.assign(n, 0);
  state.feasible = true;
  if (u)
    with_nodes_per_axis(plan_, [&](auto k) {
      constexpr int K = k;
      using S = Stencil<D, K, D, decltype(k)::dense>;
      double local[most_block_nodes * D];
      load_block<D, K, D>(plan_, block, u->data(), local);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[index(i)];
        Wide<W> room[2 * D * K], gradient[D][D], hat[D * D];
        const Wide<W>* const w = plan_.weights(i, room);
        S::template gather<false, true>(local + batch.node * D, w, w + S::values, nullptr, gradient);
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b) hat[a + D * b] = a == b ? gradient[a][b] + 1.0 : gradient[a][b];
        store_lanes<D * D>(hat, batch.count, state.hat[index(batch.first - block.particle_begin)].data());
      }
    });
  std::vector<double> volume(n), J(n);
  for (std::size_t k = 0; k < n; ++k) state.F[k] = state.hat[k] * particles_.F[index(block.particle_begin) + k];
  for_each_patch(plan_, particles_, laws_, block, [&](const VolumePatch& patch) {
    const auto first = index(patch.begin - block.particle_begin), size = index(patch.end - patch.begin);
    for (std::size_t k = first; k < first + size; ++k) {
      const auto p = index(block.particle_begin) + k;
      volume[k] = particles_.volume0[p] * particles_.F[p].determinant();
      J[k] = state.hat[k].determinant();
    }
    const bool good = share_volume<D>({volume.data() + first, size}, {J.data() + first, size},
                                      state.share.data() + first, state.stretch.data() + first);
    if (good)
      for (std::size_t k = first; k < first + size; ++k) state.F[k] *= state.stretch[k];
    state.feasible = state.feasible && good;
  });
}

template <int D>
double ElasticEnergy<D>::barred_value(const Vector& u) {
  memory_.block_sum.resize(plan_.blocks().size());
  for_each_block(plan_, parallel_, [&](const Block<D>& block, int b) {
    BarredBlock<D> state;
    deform_block(block, &u, state);
    state.psi.resize(state.F.size());
    for_each_material(plan_, block, block.particle_begin, block.particle_end,
                      [&](std::uint16_t material, int first, std::size_t n) {
                        const auto at = index(first - block.particle_begin);
                        laws_[material]->energy({state.F.data() + at, n}, {state.psi.data() + at, n});
                      });
    double sum = state.feasible ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < state.psi.size() && state.feasible; ++k)
      sum += particles_.volume0[index(block.particle_begin) + k] * state.psi[k];
    memory_.block_sum[index(b)] = sum;
  });
  work_.energy += particles_.size();
  return ordered_sum();
}

template <int D>
void ElasticEnergy<D>::block_stress(const Block<D>& block, BarredBlock<D>& state) const {
  state.psi.resize(state.F.size());
  state.P.resize(state.F.size());
  for_each_material(
      plan_, block, block.particle_begin, block.particle_end, [&](std::uint16_t material, int first, std::size_t n) {
        const auto at = index(first - block.particle_begin);
        laws_[material]->stress({state.F.data() + at, n}, {state.psi.data() + at, n}, {state.P.data() + at, n});
      });
}

/// dE/dF^ of each particle.
template <int D>
void ElasticEnergy<D>::block_flux(const Block<D>& block, BarredBlock<D>& state) const {
  state.flux.resize(state.F.size());
  for (std::size_t k = 0; k < state.F.size(); ++k) {
    const auto p = index(block.particle_begin) + k;
    state.flux[k] = particles_.volume0[p] * state.stretch[k] * state.P[k] * particles_.F[p].transpose();
  }
  for_each_patch(plan_, particles_, laws_, block, [&](const VolumePatch& patch) {
    const auto first = index(patch.begin - block.particle_begin), last = index(patch.end - block.particle_begin);
    double along_L = 0;
    for (std::size_t k = first; k < last; ++k) {
      const double along = state.flux[k].cwiseProduct(state.hat[k]).sum() / D;
      state.flux[k] -= along * state.hat[k].inverse().transpose();
      along_L += along;
    }
    for (std::size_t k = first; k < last; ++k)
      state.flux[k] += along_L * state.share[k] * state.hat[k].inverse().transpose();
  });
}

template <int D>
double ElasticEnergy<D>::barred_gradient(const Vector* u, Vector& g, Vector* magnitude) {
  memory_.block_sum.resize(plan_.blocks().size());
  with_nodes_per_axis(plan_, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D, decltype(k)::dense>;
    for_each_block_coloured(plan_, parallel_, [&](const Block<D>& block, int b) {
      BarredBlock<D> state;
      deform_block(block, u, state);
      memory_.block_sum[index(b)] = std::numeric_limits<double>::infinity();
      if (!state.feasible) return;
      block_stress(block, state);
      block_flux(block, state);
      double energy = 0;
      for (std::size_t p = 0; p < state.psi.size(); ++p)
        energy += particles_.volume0[index(block.particle_begin) + p] * state.psi[p];
      memory_.block_sum[index(b)] = energy;
      double local[S::nodes * D] = {}, local_size[S::nodes] = {};
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan_.batches()[index(i)];
        Wide<W> room[2 * D * K], lanes[D * D], flux[D][D];
        const Wide<W>* const w = plan_.weights(i, room);
        load_lanes<D * D>(state.flux[index(batch.first - block.particle_begin)].data(), batch.count, lanes);
        for (int a = 0; a < D; ++a)
          for (int c = 0; c < D; ++c) flux[a][c] = lanes[a + D * c];
        S::template scatter<false, true>(nullptr, flux, w, w + S::values, local + batch.node * D);
        if (magnitude) scatter_sizes<D, K, decltype(k)::dense>(flux, w, local_size + batch.node);
      }
      add_block<D, K, D>(plan_, block, local, g.data());
      if (magnitude) add_block<D, K, 1>(plan_, block, local_size, magnitude->data());
    });
  });
  return ordered_sum();
}

#define PF_INSTANTIATE(D)                                                                              \
  template double ElasticEnergy<D>::barred_value(const Vector&);                                       \
  template double ElasticEnergy<D>::barred_gradient(const Vector*, Vector&, Vector*);                  \
  template void ElasticEnergy<D>::deform_block(const Block<D>&, const Vector*, BarredBlock<D>&) const; \
  template void ElasticEnergy<D>::block_stress(const Block<D>&, BarredBlock<D>&) const;                \
  template void ElasticEnergy<D>::block_flux(const Block<D>&, BarredBlock<D>&) const;
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
