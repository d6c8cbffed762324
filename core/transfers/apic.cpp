#include "core/transfers/apic.hpp"

#include "core/grid/records.hpp"
#include "core/grid/stencil.hpp"

namespace pf {

template <int D>
void ApicTransfer<D>::grid_to_particles(const Plan<D>& plan, const GridState<D>& grid, const Particles<D>& particles,
                                        Parallel& parallel, const Motion<D>& to) const {
  const bool by_moments = plan.basis().affine_by_moments;
  with_nodes_per_axis(plan, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D>;
    using Lane = Wide<lane_count<D>>;
    for_each_block(plan, parallel, [&](const Block<D>& block, int) {
      double local[S::nodes * D];
      load_block<D, K, D>(plan, block, grid.v_end.data(), local);
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan.batches()[static_cast<std::size_t>(i)];
        Lane room[2 * D * K];
        const Lane* const w = plan.weights(i, room);
        // C = B D^-1 has the form of a gradient: N (x_j - x_p)_a / D_aa takes the place of dN_a; for the linear basis
        // D is singular on the nodes and C = sum_j v_j (x) grad N_j.
        Lane slopes[D * K];
        if (by_moments) {
          int node = batch.node;
          Lane x[D];
          load_lanes<D>(particles.x[static_cast<std::size_t>(batch.first)].data(), batch.count, x);
          for (int a = 0; a < D; ++a) {
            const double first =
                static_cast<double>(block.corner[static_cast<std::size_t>(a)] + node % S::edge) * plan.spacing();
            node /= S::edge;
            Lane inertia{};
            for (int r = 0; r < K; ++r) {
              const Lane distance = first + r * plan.spacing() - x[a];
              slopes[a * K + r] = w[a * K + r] * distance;
              inertia += slopes[a * K + r] * distance;
            }
            for (int lane = batch.count; lane < lane_count<D>; ++lane) inertia[lane] = 1;
            inertia = 1.0 / inertia;
            for (int r = 0; r < K; ++r) slopes[a * K + r] *= inertia;
          }
        } else {
          for (int r = 0; r < D * K; ++r) slopes[r] = w[D * K + r];
        }
        Lane value[D], C[D][D];
        S::template gather<true, true>(local + batch.node * D, w, slopes, value, C);
        const auto p = static_cast<std::size_t>(batch.first);
        store_lanes<D>(value, batch.count, to.v[p].data());
        Lane columns[D * D];
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b) columns[a + D * b] = C[a][b];
        store_lanes<D * D>(columns, batch.count, to.C[p].data());
      }
    });
  });
}

template class ApicTransfer<2>;
template class ApicTransfer<3>;

}  // namespace pf
