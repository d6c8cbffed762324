#include "core/integrators/backward_euler.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/energies/external.hpp"
#include "core/energies/inertia.hpp"
#include "core/integrators/potential.hpp"
#include "core/integrators/step_error.hpp"

namespace pf {

namespace {

/// Whether any boundary of the step rubs; prepares slip's fixed normals.
template <int D>
bool prepare_friction(FeasibleSet<D>& set) {
  bool any = false;
  for (NodeConstraint<D>& c : set.constrained) {
    if (!(c.friction > 0)) continue;
    any = true;
    if (c.faces > 0) continue;
    const Mat<D> fixed = Mat<D>::Identity() - c.free;
    if (std::abs(fixed.trace() - 1) > 1e-9) continue;  // an edge of two slip walls: nothing left to rub along
    Eigen::Index column = 0;
    fixed.diagonal().maxCoeff(&column);
    c.rub_normal = fixed.col(column).normalized();
  }
  return any;
}

/// Sets each bound to mu times the reaction n.g of the minimum; `change` receives what that changes, as nodal forces.
template <int D>
void update_friction(const Vector& g, FeasibleSet<D>& set, Vector& change) {
  change.setZero(g.size());
  for (NodeConstraint<D>& c : set.constrained) {
    if (!(c.friction > 0)) continue;
    const Vec<D> force = g.segment<D>(c.node * D);
    double normal_force = std::abs(c.rub_normal.dot(force));  // a slip wall holds from both sides
    if (c.faces > 0) {
      normal_force = 0;
      for (int k = 0; k < c.faces; ++k) {
        const double f = c.normal[static_cast<std::size_t>(k)].dot(force);
        if (f <= normal_force) continue;
        normal_force = f;
        c.rub_normal = c.normal[static_cast<std::size_t>(k)];
      }
    }
    change.segment<D>(c.node * D) = c.rub_normal * (c.friction * normal_force - c.rub_bound);
    c.rub_bound = c.friction * normal_force;
  }
}

}  // namespace

template <int D>
NewtonResult BackwardEuler<D>::advance(const StepProblem<D>& problem) {
  FeasibleSet<D>& set = problem.set;
  const bool rubs = prepare_friction(set);
  Inertia<D> inertia(problem.mass, problem.grid.v, problem.dt, &inertia_);
  ExternalWork<D> external(problem.force);
  Friction<D> friction(set);
  terms_.clear();
  for (Energy<D>* term : {static_cast<Energy<D>*>(&inertia), static_cast<Energy<D>*>(&problem.elastic),
                          static_cast<Energy<D>*>(&external), static_cast<Energy<D>*>(problem.grab),
                          rubs ? static_cast<Energy<D>*>(&friction) : nullptr})
    if (term) terms_.push_back(term);
  inertia.free_flight_force(free_flight_);
  const std::array<const Vector*, 2> reference{&free_flight_, &problem.force};
  IncrementalPotential<D> potential(problem.plan, problem.mass.lumped(), set, terms_, reference, &potential_);

  // Start from rest or from free flight under the loads, whichever is lower on E: both are feasible once projected.
  Vector& u = problem.grid.u;
  u = Vector::Zero(problem.grid.v.size());
  set.project(u);
  Vector& flight = flight_;
  flight = problem.dt * problem.grid.v;
  const Vector& m = problem.mass.lumped();
  const double rounding = 1e-14 * m.maxCoeff();
  for (Eigen::Index i = 0; i < m.size(); ++i)
    if (m[i] > rounding)
      flight.segment<D>(i * D) += problem.dt * problem.dt / m[i] * problem.force.template segment<D>(i * D);
  set.project(flight);
  const double at_rest = potential.value(u), in_flight = potential.value(flight);
  if (in_flight < at_rest || !std::isfinite(at_rest)) u = flight;

  // While the friction forces settle, each minimisation need only be as exact as they are; the last one is exact.
  NewtonSettings newton = problem.newton;
  if (rubs) newton.tolerance = std::max(newton.tolerance, 1e-2);
  NewtonResult result = minimise(potential, set, problem.linear, newton, problem.cancel, u, &newton_);
  constexpr int most = 100;
  for (int k = 0; rubs && result.status == NewtonStatus::converged; ++k) {
    potential.gradient(u, g_);
    update_friction(g_, set, change_);
    const double unsettled = potential.norm(change_) / std::max(potential.scale(), 1e-300);
    if (newton.tolerance == problem.newton.tolerance && unsettled <= newton.tolerance) break;
    if (k == most) {
      result.status = NewtonStatus::not_converged;
      break;
    }
    newton.tolerance = std::clamp(0.1 * unsettled, problem.newton.tolerance, 1e-2);
    NewtonResult again = minimise(potential, set, problem.linear, newton, problem.cancel, u, &newton_);
    again.linear_iterations += result.linear_iterations;
    result.iterations.pop_back();  // where one minimisation ends the next begins
    again.iterations.insert(again.iterations.begin(), result.iterations.begin(), result.iterations.end());
    result = std::move(again);
  }
  problem.grid.v_end = u / problem.dt;
  if (problem.error_rate && result.status == NewtonStatus::converged)
    *problem.error_rate = step_error_rate(potential, problem, result.iterations.size() > 1);
  return result;
}

template class BackwardEuler<2>;
template class BackwardEuler<3>;

}  // namespace pf
