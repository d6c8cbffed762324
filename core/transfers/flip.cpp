#include "core/transfers/flip.hpp"

#include "core/grid/records.hpp"
#include "core/grid/stencil.hpp"

namespace pf {

template <int D>
void FlipTransfer<D>::grid_to_particles(const Plan<D>& plan, const GridState<D>& grid, const Particles<D>& particles,
                                        Parallel& parallel, const Motion<D>& to) const {
  with_nodes_per_axis(plan, [&](auto k) {
    constexpr int K = k;
    using S = Stencil<D, K, D>;
    using Lane = Wide<lane_count<D>>;
    for_each_block(plan, parallel, [&](const Block<D>& block, int) {
      // One gather: what the grid adds is sum_j (v_j^{n+1} - a v_j^n) N_j.
      double gained[S::nodes * D];
      load_block<D, K, D>(plan, block, grid.v_end.data(), gained);
      if (flip_ratio_ != 0) {
        double before[S::nodes * D];
        load_block<D, K, D>(plan, block, grid.v.data(), before);
        for (int i = 0; i < S::nodes * D; ++i) gained[i] -= flip_ratio_ * before[i];
      }
      for (int i = block.batch_begin; i < block.batch_end; ++i) {
        const Batch& batch = plan.batches()[static_cast<std::size_t>(i)];
        Lane room[2 * D * K], value[D], v[D];
        const Lane* const w = plan.weights(i, room);
        S::template gather<true, false>(gained + batch.node * D, w, w, value, nullptr);
        const auto p = static_cast<std::size_t>(batch.first);
        load_lanes<D>(particles.v[p].data(), batch.count, v);
        for (int a = 0; a < D; ++a) v[a] = flip_ratio_ * v[a] + value[a];
        store_lanes<D>(v, batch.count, to.v[p].data());
      }
    });
  });
}

template class FlipTransfer<2>;
template class FlipTransfer<3>;

}  // namespace pf
