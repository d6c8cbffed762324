// Energies and momenta of particles and grid (INTERFACE stats.csv; THEORY T6).
#pragma once

#include "core/energies/elastic.hpp"
#include "core/grid/particles.hpp"
#include "core/step_report.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

/// Sums over particles; `affine`: the particles' C takes part (APIC). `elastic`: the elastic energy, where it is known.
template <int D>
Balance particle_balance(const Particles<D>& particles, const Laws<D>& laws, const Plan<D>& plan, bool affine,
                         const Vec<D>& gravity, Parallel& parallel, const double* elastic = nullptr);
/// sum_i x_i x p_i about the origin, p_i a momentum a node at positions x_i + part u_i.
template <int D>
Vec3 grid_angular_momentum(const Plan<D>& plan, const Vector& u, double part, const Vector& momentum);

/// What `particles` are like.
template <int D>
StateCheck check_state(const Particles<D>& particles);
/// The id of the particle that is worst among those that have moved as `moved` says: the first that is not finite, or
/// the one of the smallest J.
template <int D>
std::uint32_t worst_particle(const Particles<D>& particles, const Motion<D>& moved);

}  // namespace pf
