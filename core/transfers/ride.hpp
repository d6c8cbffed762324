// Particles ride the grid's motion (THEORY T5): what a step changes of them, in one pass. A transfer says what becomes
// of velocities; F follows the displacement for all.
#pragma once

#include <algorithm>
#include <array>

#include "core/grid/records.hpp"
#include "core/grid/stencil.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

/// A batch while it rides.
template <int D>
struct RidingBatch {
  const Plan<D>& plan;
  const Particles<D>& particles;
  const Block<D>& block;
  const Batch& batch;
  const Wide<lane_count<D>>* weights;
};

/// The extremes of some particles, a lane each.
template <int D>
struct LaneExtremes {
  using Lane = Wide<lane_count<D>>;
  Lane min_J = Lane{} + INFINITY, max_J = Lane{} - INFINITY, max_speed2{}, zero{};

  /// `count` lanes are particles.
  void add(const Lane* F, const Lane* v, int count) {
    Lane J, speed2{};
    if constexpr (D == 2)
      J = F[0] * F[3] - F[2] * F[1];
    else
      J = F[0] * (F[4] * F[8] - F[7] * F[5]) - F[3] * (F[1] * F[8] - F[7] * F[2]) + F[6] * (F[1] * F[5] - F[4] * F[2]);
    for (int a = 0; a < D; ++a) speed2 += v[a] * v[a];
    for (int lane = count; lane < lane_count<D>; ++lane) {
      J[lane] = J[0];
      speed2[lane] = speed2[0];
    }
    min_J = J < min_J ? J : min_J;
    max_J = J > max_J ? J : max_J;
    max_speed2 = speed2 > max_speed2 ? speed2 : max_speed2;
    zero += J * 0 + speed2 * 0;  // of a number that is not finite it is not
  }
  void add_to(StateCheck& check) const {
    for (int lane = 0; lane < lane_count<D>; ++lane) {
      check.min_J = std::min(check.min_J, min_J[lane]);
      check.max_J = std::max(check.max_J, max_J[lane]);
      check.max_speed = std::max(check.max_speed, std::sqrt(max_speed2[lane]));
      check.finite = check.finite && zero[lane] == 0;
    }
  }
};

/// The numbers of Eigen's vectors or matrices that stand side by side.
template <class T>
double* records(T* first) {
  return reinterpret_cast<double*>(first);
}

/// `Velocities` has, for K nodes an axis and dense weights or not, load<K, Dense>(plan, block, grid, nodes), which
/// fills D numbers for each node of a block, and ride<K, Dense>(batch, nodes, v, C), which makes the new velocities of
/// them and, if it is `affine`, C (entry a + D b).
template <int D, class Velocities>
StateCheck ride(const Plan<D>& plan, const GridState<D>& grid, const Particles<D>& particles, Parallel& parallel,
                const Motion<D>& to, const Velocities& velocities) {
  using Lane = Wide<lane_count<D>>;
  constexpr std::size_t together = 256;
  std::array<StateCheck, together> parts;
  StateCheck all{.min_J = INFINITY, .max_J = -INFINITY};
  const auto ride_block = [&]<int K, bool Dense>(const Block<D>& block, StateCheck& check) {
    using S = Stencil<D, K, D, Dense>;
    double nodes[S::nodes * D], u[S::nodes * D];
    velocities.template load<K, Dense>(plan, block, grid, nodes);
    if (to.F) load_block<D, K, D>(plan, block, grid.u.data(), u);
    LaneExtremes<D> extremes;
    for (int i = block.batch_begin; i < block.batch_end; ++i) {
      const Batch& batch = plan.batches()[static_cast<std::size_t>(i)];
      const auto p = static_cast<std::size_t>(batch.first);
      // Where the batch's first record goes, when all keep their places.
      const std::uint32_t* const place = to.place ? to.place + p : nullptr;
      const std::size_t first = place ? 0 : p;
      Lane room[2 * D * K], v[D], C[D * D];
      const Lane* const w = plan.weights(i, room);
      velocities.template ride<K, Dense>({plan, particles, block, batch, w}, nodes + batch.node * D, v, C);
      store_lanes_at<D>(v, batch.count, place, records(to.v) + first * D);
      if (Velocities::affine && to.C) store_lanes_at<D * D>(C, batch.count, place, records(to.C) + first * D * D);
      if (!to.F) continue;
      Lane gradient[D][D], F_hat[D * D], F_n[D * D], F[D * D];
      S::template gather<false, true>(u + batch.node * D, w, w + S::values, nullptr, gradient);
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) F_hat[a + D * b] = a == b ? gradient[a][b] + 1.0 : gradient[a][b];
      load_lanes<D * D>(particles.F[p].data(), batch.count, F_n);
      multiply_lanes<D>(F_hat, F_n, F);
      store_lanes_at<D * D>(F, batch.count, place, records(to.F) + first * D * D);
      extremes.add(F, v, batch.count);
    }
    check = {.min_J = INFINITY, .max_J = -INFINITY};
    if (to.F) extremes.add_to(check);
  };
  with_nodes_per_axis(plan, [&](auto k) {
    for (std::size_t first = 0; first < plan.blocks().size(); first += together) {
      const std::size_t count = std::min(together, plan.blocks().size() - first);
      parallel(static_cast<int>(count), [&](int i) {
        const auto b = static_cast<std::size_t>(i);
        ride_block.template operator()<k, decltype(k)::dense>(plan.blocks()[first + b], parts[b]);
      });
      for (std::size_t b = 0; b < count; ++b) all.include(parts[b]);
    }
  });
  return all;
}

}  // namespace pf
