#include "core/transfers/flip.hpp"

#include "core/transfers/carry.hpp"
#include "core/transfers/ride.hpp"

namespace pf {

namespace {

/// One gather: what the grid adds is sum_j (v_j^{n+1} - a v_j^n) N_j.
template <int D>
class BlendedVelocities {
 public:
  using Lane = Wide<lane_count<D>>;
  static constexpr bool affine = false;

  explicit BlendedVelocities(double flip_ratio) : flip_ratio_(flip_ratio) {}
  template <int K, bool Dense>
  void load(const Plan<D>& plan, const Block<D>& block, const GridState<D>& grid, double* nodes) const {
    load_block<D, K, D>(plan, block, grid.v_end.data(), nodes);
    if (flip_ratio_ == 0) return;
    double before[Stencil<D, K, D, Dense>::nodes * D];
    load_block<D, K, D>(plan, block, grid.v.data(), before);
    for (int i = 0; i < Stencil<D, K, D, Dense>::nodes * D; ++i) nodes[i] -= flip_ratio_ * before[i];
  }
  template <int K, bool Dense>
  void ride(const RidingBatch<D>& riding, const double* nodes, Lane* v, Lane*) const {
    Lane gained[D];
    Stencil<D, K, D, Dense>::template gather<true, false>(nodes, riding.weights, riding.weights, gained, nullptr);
    load_lanes<D>(riding.particles.v[static_cast<std::size_t>(riding.batch.first)].data(), riding.batch.count, v);
    for (int a = 0; a < D; ++a) v[a] = flip_ratio_ * v[a] + gained[a];
  }

 private:
  double flip_ratio_;
};

}  // namespace

template <int D>
StateCheck FlipTransfer<D>::grid_to_particles(const Plan<D>& plan, const GridState<D>& grid,
                                              const Particles<D>& particles, Parallel& parallel,
                                              const Motion<D>& to) const {
  return ride(plan, grid, particles, parallel, to, BlendedVelocities<D>(flip_ratio_));
}

template <int D>
void FlipTransfer<D>::carry(const Plan<D>& plan, const Particles<D>& particles, const Vector& v, Parallel& parallel,
                            Vector& momentum) const {
  carry_velocities(plan, particles, v, parallel, momentum, BlendedVelocities<D>(0));
}

template class FlipTransfer<2>;
template class FlipTransfer<3>;

}  // namespace pf
