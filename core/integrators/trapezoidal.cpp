#include "core/integrators/trapezoidal.hpp"

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
StepResult Trapezoidal<D>::advance(const StepProblem<D>& problem) {
  GridState<D>& grid = problem.grid;
  const double dt = problem.dt;
  forces_at_start(problem, start_);
  // M (2 u/dt - 2 v) = dt/2 (f^n + f(u)): with 2/dt, 4/dt^2 M (u - dt v) = f^n + f(u).
  u_free_ = dt * grid.v;
  problem.conditions.force(1, loads_);
  loads_ += start_.loads;
  const Stage<D> stage{4 / (dt * dt), u_free_, loads_, &start_.inner, problem.set};
  NewtonResult newton = minimise_stage(problem, stage, memory_, grid.u);
  grid.v_end = 2 / dt * grid.u - grid.v;
  hold_velocities(problem.set, grid.u, grid.v_end);

  const Vector early = dt / 2 * start_.loads;
  Vector late;
  problem.mass.multiply(grid.v_end - grid.v, late);
  late -= early + dt / 2 * start_.inner;
  return {std::move(newton), {{Vector::Zero(grid.u.size()), early}, {grid.u, late}}};
}

template class Trapezoidal<2>;
template class Trapezoidal<3>;

}  // namespace pf
