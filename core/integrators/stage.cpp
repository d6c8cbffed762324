#include "core/integrators/stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/energies/external.hpp"
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

/// Starts from rest or from free flight under the loads, whichever is lower on E: both are feasible once projected.
template <int D>
void first_guess(const StepProblem<D>& problem, const Stage<D>& stage, Objective<D>& potential, Vector& flight,
                 Vector& u) {
  u.setZero(problem.grid.v.size());
  stage.set.project(u);
  flight = stage.u_free;
  const Vector& m = problem.mass.lumped();
  const double rounding = 1e-14 * m.maxCoeff();
  // With inner forces of an earlier configuration in the balance, loads alone say little of where the nodes go.
  if (stage.scale > 0 && !stage.inner)
    for (Eigen::Index i = 0; i < m.size(); ++i)
      if (m[i] > rounding)
        flight.segment<D>(i * D) += 1 / (stage.scale * m[i]) * stage.loads.template segment<D>(i * D);
  stage.set.project(flight);
  const double at_rest = potential.value(u), in_flight = potential.value(flight);
  if (in_flight < at_rest || !std::isfinite(at_rest)) u = flight;
}

}  // namespace

NewtonResult join(NewtonResult earlier, NewtonResult later) {
  later.linear_iterations += earlier.linear_iterations;
  if (!earlier.iterations.empty()) earlier.iterations.pop_back();
  later.iterations.insert(later.iterations.begin(), earlier.iterations.begin(), earlier.iterations.end());
  return later;
}

template <int D>
NewtonResult minimise_stage(const StepProblem<D>& problem, const Stage<D>& stage, StageMemory<D>& memory, Vector& u,
                            double* error_rate) {
  FeasibleSet<D>& set = stage.set;
  const bool rubs = prepare_friction(set);
  Inertia<D> inertia(problem.mass, stage.scale, stage.u_free, &memory.inertia);
  if (stage.inner) memory.force = stage.loads + *stage.inner;
  ExternalWork<D> external(stage.inner ? memory.force : stage.loads);
  Friction<D> friction(set);
  memory.terms.clear();
  for (Energy<D>* term :
       {stage.scale > 0 ? static_cast<Energy<D>*>(&inertia) : nullptr, static_cast<Energy<D>*>(&problem.elastic),
        static_cast<Energy<D>*>(&external), static_cast<Energy<D>*>(problem.grab), problem.ties,
        rubs ? static_cast<Energy<D>*>(&friction) : nullptr})
    if (term) memory.terms.push_back(term);
  inertia.free_flight_force(memory.free_flight);
  const std::array<const Vector*, 2> reference{&memory.free_flight, &stage.loads};
  IncrementalPotential<D> potential(problem.plan, problem.mass.lumped(), set, memory.terms, reference,
                                    &memory.potential);
  first_guess(problem, stage, potential, memory.flight, u);
  if (problem.observer) problem.observer->stage(stage.scale, stage.u_free, stage.loads, stage.inner);

  // While the friction forces settle, each minimisation need only be as exact as they are; the last one is exact.
  NewtonSettings newton = problem.newton;
  if (rubs) newton.tolerance = std::max(newton.tolerance, 1e-2);
  NewtonResult result =
      minimise(potential, set, problem.linear, newton, problem.cancel, u, &memory.newton, problem.observer);
  constexpr int most = 100;
  for (int k = 0; rubs && result.status == NewtonStatus::converged; ++k) {
    potential.gradient(u, memory.g);
    update_friction(memory.g, set, memory.change);
    const double unsettled = potential.norm(memory.change) / std::max(potential.scale(), 1e-300);
    if (newton.tolerance == problem.newton.tolerance && unsettled <= newton.tolerance) break;
    if (k == most) {
      result.status = NewtonStatus::not_converged;
      break;
    }
    newton.tolerance = std::clamp(0.1 * unsettled, problem.newton.tolerance, 1e-2);
    result = join(std::move(result), minimise(potential, set, problem.linear, newton, problem.cancel, u, &memory.newton,
                                              problem.observer));
  }
  if (error_rate && result.status == NewtonStatus::converged) {
    problem.grid.u = u;
    *error_rate = step_error_rate(potential, problem, result.iterations.size() > 1);
  }
  return result;
}

template <int D>
FeasibleSet<D> shortened(const FeasibleSet<D>& set, double factor) {
  FeasibleSet<D> part = set;
  for (NodeConstraint<D>& c : part.constrained) {
    c.given *= factor;
    c.wall *= factor;
    for (double& offset : c.offset) offset *= factor;
  }
  return part;
}

template <int D>
void keep_friction(const FeasibleSet<D>& stage, FeasibleSet<D>& set) {
  for (std::size_t k = 0; k < set.constrained.size(); ++k) {
    set.constrained[k].rub_normal = stage.constrained[k].rub_normal;
    set.constrained[k].rub_bound = stage.constrained[k].rub_bound;
  }
}

template <int D>
void forces_at_start(const StepProblem<D>& problem, StartForces& forces) {
  problem.conditions.force(0, forces.loads);
  forces.inner.setZero(forces.loads.size());
  problem.elastic.add_force_at_rest(forces.inner);
  forces.inner *= -1;
  if (problem.grab) {
    Vector g = Vector::Zero(forces.loads.size()), magnitude = Vector::Zero(problem.grid.mass.size());
    problem.grab->gradient(Vector::Zero(g.size()), g, magnitude);
    forces.loads -= g;
  }
}

template <int D>
NewtonResult minimise_acceleration(const StepProblem<D>& problem, const Vector& force, const FeasibleSet<D>& set,
                                   Vector& a) {
  set.project(a);
  Inertia<D> inertia(problem.mass, 1.0, Vector(Vector::Zero(force.size())));
  ExternalWork<D> external(force);
  Vector held;  // what fixed directions alone take: the size of the problem where there is no force
  problem.mass.multiply(a, held);
  const std::vector<Energy<D>*> terms{&inertia, &external};
  const std::array<const Vector*, 2> reference{&force, &held};
  IncrementalPotential<D> potential(problem.plan, problem.mass.lumped(), set, terms, reference);
  NewtonSettings exact = problem.newton;
  exact.tolerance = std::min(exact.tolerance, 1e-9);
  return minimise(potential, set, problem.linear, exact, problem.cancel, a);
}

namespace {

/// `given`, `wall`: which members of the constraints the nodes that are held take.
template <int D>
void hold(const FeasibleSet<D>& set, const Vector& u, Vec<D> NodeConstraint<D>::*given, Vec<D> NodeConstraint<D>::*wall,
          Vector& rate) {
  for (const NodeConstraint<D>& c : set.constrained) {
    auto value = rate.segment<D>(c.node * D);
    const Vec<D> at = u.segment<D>(c.node * D);
    value = (c.free * value + c.*given).eval();
    bool touches = c.faces == 0 && c.rub_bound > 0;
    // Where faces meet at an angle one pass is not enough.
    for (int pass = 0; pass < (c.faces > 1 ? 20 : 1); ++pass)
      for (std::size_t k = 0; k < static_cast<std::size_t>(c.faces); ++k) {
        if (c.normal[k].dot(at) - c.offset[k] > std::max(set.rounding, 1e-12 * (at.norm() + std::abs(c.offset[k]))))
          continue;
        touches = true;
        const Vec<D> axis = c.free * c.normal[k];
        value -= axis * (c.normal[k].dot(value - c.*wall) / axis.squaredNorm());
      }
    if (touches && c.rub_bound > 0 && at_rest(c, rub_slip(c, at), set.rounding)) {
      const Vec<D> relative = value - c.*wall;
      value -= c.free * (relative - c.rub_normal * c.rub_normal.dot(relative));
    }
  }
}

}  // namespace

template <int D>
void hold_velocities(const FeasibleSet<D>& set, const Vector& u, Vector& v) {
  hold(set, u, &NodeConstraint<D>::given_velocity, &NodeConstraint<D>::wall_velocity, v);
}
template <int D>
void hold_accelerations(const FeasibleSet<D>& set, const Vector& u, Vector& a) {
  hold(set, u, &NodeConstraint<D>::given_acceleration, &NodeConstraint<D>::wall_acceleration, a);
}

#define PF_INSTANTIATE(D)                                                                                             \
  template NewtonResult minimise_stage<D>(const StepProblem<D>&, const Stage<D>&, StageMemory<D>&, Vector&, double*); \
  template FeasibleSet<D> shortened<D>(const FeasibleSet<D>&, double);                                                \
  template void keep_friction<D>(const FeasibleSet<D>&, FeasibleSet<D>&);                                             \
  template NewtonResult minimise_acceleration<D>(const StepProblem<D>&, const Vector&, const FeasibleSet<D>&,         \
                                                 Vector&);                                                            \
  template void forces_at_start<D>(const StepProblem<D>&, StartForces&);                                              \
  template void hold_velocities<D>(const FeasibleSet<D>&, const Vector&, Vector&);                                    \
  template void hold_accelerations<D>(const FeasibleSet<D>&, const Vector&, Vector&);
PF_INSTANTIATE(2)
PF_INSTANTIATE(3)
#undef PF_INSTANTIATE

}  // namespace pf
