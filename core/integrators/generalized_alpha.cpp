#include "core/integrators/generalized_alpha.hpp"

#include "core/integrators/stage.hpp"

namespace pf {

/// What the forces at t^n and the walls' own accelerations make of the nodes.
template <int D>
NewtonResult GeneralizedAlpha<D>::start_acceleration(const StepProblem<D>& problem) const {
  FeasibleSet<D> set = problem.set;
  for (NodeConstraint<D>& c : set.constrained) {
    c.given = c.given_acceleration;
    c.wall = c.wall_acceleration;
    for (std::size_t k = 0; k < static_cast<std::size_t>(c.faces); ++k)
      c.offset[k] = c.normal[k].dot(c.wall_acceleration);
    c.friction = c.rub_bound = 0;
  }
  StartForces start;
  forces_at_start(problem, start);
  problem.grid.a = Vector::Zero(start.loads.size());
  return minimise_acceleration(problem, Vector(start.loads + start.inner), set, problem.grid.a);
}

template <int D>
StepResult GeneralizedAlpha<D>::advance(const StepProblem<D>& problem) {
  GridState<D>& grid = problem.grid;
  const double dt = problem.dt, am = (2 * r_ - 1) / (r_ + 1), af = r_ / (r_ + 1);
  const double gamma = 0.5 - am + af, beta = (1 - am + af) * (1 - am + af) / 4, part = 1 - af;
  if (grid.a.size() == 0) {
    NewtonResult started = start_acceleration(problem);
    if (started.status != NewtonStatus::converged) {
      grid.u = grid.v_end = grid.a_end = Vector::Zero(grid.v.size());
      return {std::move(started), {}};
    }
  }
  // With w = (1-af) u: M (1-am)/(b dt^2 (1-af)) (w - w_free) = f(x + w), w_free where a^{n+1} would be -am/(1-am) a^n.
  const Vector drift = dt * grid.v + dt * dt * (0.5 - beta) * grid.a;
  FeasibleSet<D> set = shortened(problem.set, part);
  u_free_ = part * (drift - dt * dt * beta * am / (1 - am) * grid.a);
  problem.conditions.force(part, loads_);
  const Stage<D> stage{(1 - am) / (beta * dt * dt * part), u_free_, loads_, nullptr, set};
  Vector w;
  NewtonResult newton = minimise_stage(problem, stage, memory_, w);
  keep_friction(set, problem.set);
  grid.u = w / part;
  grid.a_end = (grid.u - drift) / (beta * dt * dt);
  Vector impulse;
  problem.mass.multiply(dt * (1 - am) * grid.a_end + dt * am * grid.a, impulse);
  grid.v_end = grid.v + dt * (1 - gamma) * grid.a + dt * gamma * grid.a_end;
  hold_velocities(problem.set, grid.u, grid.v_end);
  hold_accelerations(problem.set, grid.u, grid.a_end);
  return {std::move(newton), {{std::move(w), std::move(impulse)}}};
}

template class GeneralizedAlpha<2>;
template class GeneralizedAlpha<3>;

}  // namespace pf
