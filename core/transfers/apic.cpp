#include "core/transfers/apic.hpp"

#include <Eigen/LU>

#include "core/transfers/carry.hpp"
#include "core/transfers/moments.hpp"
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

  template <int K, bool Dense>
  void load(const Plan<D>& plan, const Block<D>& block, const GridState<D>& grid, double* nodes) const {
    load_block<D, K, D>(plan, block, grid.v_end.data(), nodes);
  }
  template <int K, bool Dense>
  void ride(const RidingBatch<D>& riding, const double* nodes, Lane* v, Lane* C) const {
    using S = Stencil<D, K, D, Dense>;
    const Lane* slopes = riding.weights + S::values;
    Lane room[S::values * (Dense ? D : 1)], second[D * D], rates[D][D];
    if (riding.plan.basis().affine_by_moments) {
      moment_weights<D, K, Dense>(riding.plan, riding.particles, riding.block, riding.batch, riding.weights, room);
      second_moments<D, K, Dense>(riding.plan, riding.particles, riding.block, riding.batch, riding.weights, second);
      if constexpr (!Dense) divide_axes<K>(riding.batch.count, second, room);
      slopes = room;
    }
    S::template gather<true, true>(nodes, riding.weights, slopes, v, rates);
    if constexpr (Dense) divide(riding.batch.count, second, rates);
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) C[a + D * b] = rates[a][b];
  }

 private:
  template <int K>
  static void divide_axes(int count, Lane* second, Lane* slopes) {
    for (int a = 0; a < D; ++a) {
      Lane inertia = second[a + D * a];
      for (int lane = count; lane < lane_count<D>; ++lane) inertia[lane] = 1;
      inertia = 1.0 / inertia;
      for (int r = 0; r < K; ++r) slopes[a * K + r] *= inertia;
    }
  }
  /// B becomes B D^-1, of the first `count` lanes.
  static void divide(int count, const Lane* second, Lane (*B)[D]) {
    for (int lane = 0; lane < count; ++lane) {
      Mat<D> inertia, rates;
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) {
          inertia(a, b) = second[a + D * b][lane];
          rates(a, b) = B[a][b][lane];
        }
      const Mat<D> affine_velocity = rates * inertia.inverse();
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) B[a][b][lane] = affine_velocity(a, b);
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

template <int D>
void ApicTransfer<D>::carry(const Plan<D>& plan, const Particles<D>& particles, const Vector& v, Parallel& parallel,
                            Vector& momentum) const {
  carry_velocities(plan, particles, v, parallel, momentum, AffineVelocities<D>());
}

template class ApicTransfer<2>;
template class ApicTransfer<3>;

}  // namespace pf
