// What the implicit schemes share: one stage, forces at the step's start, and velocities of nodes that are held.
#pragma once

#include "core/energies/inertia.hpp"
#include "core/integrators/integrator.hpp"
#include "core/integrators/potential.hpp"

namespace pf {

/// What a stage computes with; kept between steps for its memory alone.
template <int D>
struct StageMemory {
  std::vector<Energy<D>*> terms;
  InertiaVectors inertia;
  PotentialVectors<D> potential;
  NewtonVectors<D> newton;
  Vector force, flight, free_flight, g, change;
};

/// A stage asks for the minimum over `set` of
///     scale/2 (u - u_free)^T M (u - u_free) + sum_p V_p^0 psi(F_p(x + u)) - (loads + inner) . u.
template <int D>
struct Stage {
  double scale;          ///< [1/s^2]; 0: no inertia
  const Vector& u_free;  ///< [m]
  const Vector& loads;   ///< outside forces [N]
  const Vector* inner;   ///< inner forces of an earlier configuration [N]; null: none
  FeasibleSet<D>& set;   ///< in and out: the friction bounds
};

/// Newton's method on a stage, and around it the iteration for Coulomb's bounds (THEORY T7). `u`: the minimum, as a
/// displacement of the stage. `error_rate` is filled in for backward Euler's stage alone.
template <int D>
NewtonResult minimise_stage(const StepProblem<D>& problem, const Stage<D>& stage, StageMemory<D>& memory, Vector& u,
                            double* error_rate = nullptr);

/// Joins the iterations of a later stage to those of an earlier one: where one minimisation ends the next begins.
NewtonResult join(NewtonResult earlier, NewtonResult later);

/// A set whose displacements are `factor` times as long: of a stage that is extrapolated over the whole step.
template <int D>
FeasibleSet<D> shortened(const FeasibleSet<D>& set, double factor);
/// Takes over what the friction of a stage came to.
template <int D>
void keep_friction(const FeasibleSet<D>& stage, FeasibleSet<D>& set);

/// Forces at the step's start, x = x^n.
struct StartForces {
  Vector loads;  ///< f_ext and the mouse's spring [N]
  Vector inner;  ///< - sum_p V_p^0 P F_p^nT grad N_i [N]
};
template <int D>
void forces_at_start(const StepProblem<D>& problem, StartForces& forces);

/// M a = force over what `set` allows, whose displacements are read as accelerations: the minimum of a^T M a / 2 -
/// force . a. To be started from any a.
template <int D>
NewtonResult minimise_acceleration(const StepProblem<D>& problem, const Vector& force, const FeasibleSet<D>& set,
                                   Vector& a);

/// Velocities at a stage's end: fixed directions move as they must, a node that touches a wall takes the wall's normal
/// velocity (it does not rebound by itself; the body does, by its elasticity), one that sticks the wall's whole.
/// Without this a scheme that extrapolates, v_end = 2 v_mid - v, would turn about whatever velocity the particles near
/// a wall have given a held node.
template <int D>
void hold_velocities(const FeasibleSet<D>& set, const Vector& u, Vector& v);
/// The same for accelerations.
template <int D>
void hold_accelerations(const FeasibleSet<D>& set, const Vector& u, Vector& a);

}  // namespace pf
