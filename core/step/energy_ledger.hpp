// Where the energy of one step came from and went to (THEORY T6): works of what is outside, and what the numerics made.
#pragma once

#include <optional>

#include "core/integrators/integrator.hpp"
#include "core/step_report.hpp"

namespace pf {

/// What the account is made of. All parts refer to the step's beginning, before particles move.
template <int D>
struct EnergySources {
  const StepProblem<D>& problem;
  const Integrator<D>& integrator;
  const StepResult& result;
  Vec<D> gravity;          ///< [m/s^2]; its work is the potential energy's change
  const Vector& momentum;  ///< M v^n [kg m/s]
  const Vector& gained;    ///< M (v^{n+1} - v^n) [kg m/s]
  bool inertia;            ///< else velocities are reported only, and have no energy
};

/// What the grid says; with the energies of the particles it makes the account (close_ledger).
struct GridEnergies {
  double kinetic_before = 0, kinetic_after = 0;  ///< v M v / 2 on the grid [J]
  double loads = 0, mouse = 0;                   ///< works of the mean force of the step over its displacement [J]
  double boundary = 0;                           ///< of the nodes that walls and constraints hold [J]
  double solver = 0;                             ///< of what Newton's method left unbalanced elsewhere [J]
  double inner = 0;  ///< of the mean inner force [J]; the elastic energy falls by as much, were there no time step
  double given = 0;  ///< of all mean forces together [J]; the kinetic energy rises by as much, were there no time step
};
template <int D>
GridEnergies grid_energies(const EnergySources<D>& sources);

/// `before` and `after` the step, of the particles; `edits`: what edits of the scene changed `before` by.
EnergyLedger close_ledger(const GridEnergies& grid, const Balance& before, const Balance& after, bool inertia,
                          double edits);

}  // namespace pf
