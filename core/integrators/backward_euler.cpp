#include "core/integrators/backward_euler.hpp"

#include <algorithm>
#include <cmath>

#include "core/energies/external.hpp"
#include "core/energies/inertia.hpp"
#include "core/integrators/potential.hpp"

namespace pf {

namespace {

/// The contacts that may rub, one a node and pressed face; forces still 0.
template <int D>
std::vector<FrictionContact<D>> rubbing(const FeasibleSet<D>& set) {
  std::vector<FrictionContact<D>> contacts;
  for (const NodeConstraint<D>& c : set.constrained) {
    if (!(c.friction > 0)) continue;
    for (int k = 0; k < c.faces; ++k)
      contacts.push_back({c.node, c.normal[static_cast<std::size_t>(k)], c.wall, c.friction, 0});
    if (c.faces == 0 && !c.free.isZero()) {  // slip: the normal is the fixed direction
      const Mat<D> fixed = Mat<D>::Identity() - c.free;
      if (std::abs(fixed.trace() - 1) > 1e-9) continue;  // an edge of two slip faces
      Eigen::Index column = 0;
      fixed.diagonal().maxCoeff(&column);
      contacts.push_back({c.node, Vec<D>(fixed.col(column).normalized()), c.wall, c.friction, 0});
    }
  }
  return contacts;
}

/// Sets each normal force to the reaction n.g of the minimum; returns the largest change relative to the largest force.
template <int D>
double update_normal_forces(const Vector& g, std::vector<FrictionContact<D>>& contacts) {
  double change = 0, largest = 0;
  for (FrictionContact<D>& c : contacts) {
    const double f = std::max(0.0, c.normal.dot(g.segment<D>(c.node * D)));
    change = std::max(change, std::abs(f - c.normal_force));
    largest = std::max(largest, f);
    c.normal_force = f;
  }
  return change == 0 ? 0 : change / std::max(largest, 1e-300);
}

}  // namespace

template <int D>
NewtonResult BackwardEuler<D>::advance(const StepProblem<D>& problem) {
  Inertia<D> inertia(problem.mass, problem.grid.v, problem.dt);
  ExternalWork<D> external(problem.force);
  std::vector<FrictionContact<D>> contacts = rubbing(problem.set);
  Friction<D> friction(contacts, 1e-6 * problem.plan.spacing());
  std::vector<Energy<D>*> terms{&inertia, &problem.elastic, &external};
  if (problem.grab) terms.push_back(problem.grab);
  if (!contacts.empty()) terms.push_back(&friction);
  const Vector free_flight = inertia.free_flight_force();
  IncrementalPotential<D> potential(problem.plan, problem.mass.lumped(), problem.set, terms, {&free_flight, &problem.force});

  // Start from rest or from free flight, whichever is lower on E: both are feasible once projected.
  Vector& u = problem.grid.u;
  u = Vector::Zero(problem.grid.v.size());
  problem.set.project(u);
  Vector flight = problem.dt * problem.grid.v;
  problem.set.project(flight);
  const double at_rest = potential.value(u), in_flight = potential.value(flight);
  if (in_flight < at_rest || !std::isfinite(at_rest)) u = flight;

  NewtonResult result = minimise(potential, problem.set, problem.linear, problem.newton, problem.cancel, u);
  constexpr int most = 100;
  for (int k = 0; !contacts.empty() && result.status == NewtonStatus::converged; ++k) {
    Vector g;
    potential.gradient(u, g);
    if (update_normal_forces(g, contacts) <= problem.newton.tolerance) break;
    if (k == most) {
      result.status = NewtonStatus::not_converged;
      break;
    }
    NewtonResult again = minimise(potential, problem.set, problem.linear, problem.newton, problem.cancel, u);
    again.linear_iterations += result.linear_iterations;
    again.iterations.insert(again.iterations.begin(), result.iterations.begin(), result.iterations.end());
    result = std::move(again);
  }
  problem.grid.v_end = u / problem.dt;
  return result;
}

template class BackwardEuler<2>;
template class BackwardEuler<3>;

}  // namespace pf
