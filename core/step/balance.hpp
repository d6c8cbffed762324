// Energies and momenta of particles and grid (INTERFACE stats.csv; THEORY T6).
#pragma once

#include "core/energies/elastic.hpp"
#include "core/grid/particles.hpp"
#include "core/step_report.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

/// Sums over particles; `affine`: the particles' C takes part (APIC).
template <int D>
Balance particle_balance(const Particles<D>& particles, const Laws<D>& laws, const Plan<D>& plan, bool affine,
                         const Vec<D>& gravity, Parallel& parallel);
/// sum_i x_i x p_i about the origin, p_i a momentum a node at positions x_i + part u_i.
template <int D>
Vec3 grid_angular_momentum(const Plan<D>& plan, const Vector& u, double part, const Vector& momentum);

/// Extremes that decide whether a state may stand.
struct StateCheck {
  bool finite = true;
  double min_J = 1, max_J = 1, max_speed = 0;
  std::uint32_t worst = 0;  ///< id of the particle with the smallest J, or of the first that is not finite
};
template <int D>
StateCheck check_state(const Particles<D>& particles, const Motion<D>& moved);

}  // namespace pf
