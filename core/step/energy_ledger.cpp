#include "core/step/energy_ledger.hpp"

#include <cmath>

namespace pf {

namespace {

/// Where the nodes stood while forces of this part acted.
template <int D>
Vector place_of(const ForcePart& part, const EnergySources<D>& s) {
  if (part.stage >= 0) return s.result.impulses[static_cast<std::size_t>(part.stage)].u;
  return part.place * s.problem.grid.u;
}

}  // namespace

template <int D>
GridEnergies grid_energies(const EnergySources<D>& s) {
  const StepProblem<D>& problem = s.problem;
  const GridState<D>& grid = problem.grid;
  const Eigen::Index size = grid.u.size();
  Vector loads = Vector::Zero(size), mouse = Vector::Zero(size), inner = Vector::Zero(size), force(size);
  Vector magnitude = Vector::Zero(grid.mass.size());
  for (const ForcePart& part : s.integrator.parts(problem.kick > 0 ? problem.kick / problem.dt : 1)) {
    const Vector u = place_of(part, s);
    problem.conditions.force(part.fraction, force);
    loads += part.weight * force;
    force.setZero();
    problem.elastic.gradient(u, force, magnitude);
    inner -= part.weight * force;
    if (!problem.grab) continue;
    force.setZero();
    problem.grab->gradient(u, force, magnitude);
    mouse -= part.weight * force;
  }
  GridEnergies e;
  e.mouse = mouse.dot(grid.u);
  e.inner = inner.dot(grid.u);
  double weight = 0;  // of gravity, a part of the loads
  for (Eigen::Index i = 0; i < grid.mass.size(); ++i)
    weight += grid.mass[i] * s.gravity.dot(grid.u.template segment<D>(i * D));
  e.loads = loads.dot(grid.u) - weight;
  // What the forces gave the nodes: where the scheme carries accelerations along, v changes by another amount, and the
  // difference is the scheme's.
  Vector given = Vector::Zero(size);
  if (s.inertia) given = s.gained;
  if (s.inertia && s.integrator.carries_acceleration() && !s.result.impulses.empty())
    given = s.result.impulses.front().impulse;
  std::vector<char> held(static_cast<std::size_t>(grid.mass.size()), 0);
  for (const NodeConstraint<D>& c : problem.set.constrained) {
    held[static_cast<std::size_t>(c.node)] = 1;
    if (s.inertia) given.template segment<D>(c.node * D) = s.gained.template segment<D>(c.node * D);
  }
  for (Eigen::Index i = 0; i < grid.mass.size(); ++i) {
    const auto at = [&](const Vector& v) { return v.segment<D>(i * D); };
    const Vec<D> unbalanced = at(given) / problem.dt - at(loads) - at(inner) - at(mouse);
    e.given += at(given).dot(at(grid.u)) / problem.dt;
    (held[static_cast<std::size_t>(i)] ? e.boundary : e.solver) += unbalanced.dot(at(grid.u));
  }
  if (s.inertia) {
    e.kinetic_before = 0.5 * grid.v.dot(s.momentum);
    e.kinetic_after = 0.5 * grid.v_end.dot(s.momentum + s.gained);
  }
  return e;
}

EnergyLedger close_ledger(const GridEnergies& grid, const Balance& before, const Balance& after, bool inertia,
                          double edits) {
  EnergyLedger ledger;
  ledger.known = true;
  ledger.loads = grid.loads;
  ledger.mouse = grid.mouse;
  ledger.boundary = grid.boundary;
  ledger.solver = grid.solver;
  ledger.edits = edits;
  if (inertia) {
    ledger.to_grid = grid.kinetic_before - before.kinetic;
    ledger.to_particles = after.kinetic - grid.kinetic_after;
  }
  // Works of mean forces over the whole displacement are no exact integrals along the way.
  ledger.time_integration =
      (grid.kinetic_after - grid.kinetic_before - grid.given) + (after.elastic - before.elastic + grid.inner);
  return ledger;
}

template GridEnergies grid_energies<2>(const EnergySources<2>&);
template GridEnergies grid_energies<3>(const EnergySources<3>&);

}  // namespace pf
