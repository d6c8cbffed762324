#include "core/transfers/apic.hpp"

#include "core/transfers/ride.hpp"

namespace pf {

namespace {

/// C = B D^-1 has the form of a gradient: N (x_j - x_p)_a / D_aa takes the place of dN_a; for the linear basis D is
/// singular on the nodes and C = sum_j v_j (x) grad N_j.
template <int D>
class AffineVelocities {
 public:
  using Lane = Wide<lane_count<D>>;
  static constexpr bool affine = true;

  template <int K>
  void load(const Plan<D>& plan, const Block<D>& block, const GridState<D>& grid, double* nodes) const {
    load_block<D, K, D>(plan, block, grid.v_end.data(), nodes);
  }
  template <int K>
  void ride(const RidingBatch<D>& riding, const double* nodes, Lane* v, Lane* C) const {
    const Lane* slopes = riding.weights + D * K;
    Lane room[D * K];
    if (riding.plan.basis().affine_by_moments) {
      moments<K>(riding, room);
      slopes = room;
    }
    Lane rates[D][D];
    Stencil<D, K, D>::template gather<true, true>(nodes, riding.weights, slopes, v, rates);
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) C[a + D * b] = rates[a][b];
  }

 private:
  template <int K>
  void moments(const RidingBatch<D>& riding, Lane* slopes) const {
    const double spacing = riding.plan.spacing();
    int node = riding.batch.node;
    Lane x[D];
    load_lanes<D>(riding.particles.x[static_cast<std::size_t>(riding.batch.first)].data(), riding.batch.count, x);
    for (int a = 0; a < D; ++a) {
      const double first =
          static_cast<double>(riding.block.corner[static_cast<std::size_t>(a)] + node % Stencil<D, K, D>::edge) *
          spacing;
      node /= Stencil<D, K, D>::edge;
      Lane inertia{};
      for (int r = 0; r < K; ++r) {
        const Lane distance = first + r * spacing - x[a];
        slopes[a * K + r] = riding.weights[a * K + r] * distance;
        inertia += slopes[a * K + r] * distance;
      }
      for (int lane = riding.batch.count; lane < lane_count<D>; ++lane) inertia[lane] = 1;
      inertia = 1.0 / inertia;
      for (int r = 0; r < K; ++r) slopes[a * K + r] *= inertia;
    }
  }
};

}  // namespace

template <int D>
StateCheck ApicTransfer<D>::grid_to_particles(const Plan<D>& plan, const GridState<D>& grid,
                                              const Particles<D>& particles, Parallel& parallel,
                                              const Motion<D>& to) const {
  return ride(plan, grid, particles, parallel, to, AffineVelocities<D>());
}

template class ApicTransfer<2>;
template class ApicTransfer<3>;

}  // namespace pf
