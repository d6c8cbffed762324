#include "core/integrators/implicit_midpoint.hpp"

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
StepResult ImplicitMidpoint<D>::advance(const StepProblem<D>& problem) {
  GridState<D>& grid = problem.grid;
  const double half = problem.dt / 2;
  FeasibleSet<D> middle = shortened(problem.set, 0.5);
  u_free_ = half * grid.v;
  problem.conditions.force(0.5, loads_);
  const Stage<D> stage{1 / (half * half), u_free_, loads_, nullptr, middle};
  NewtonResult newton = minimise_stage(problem, stage, memory_, u_);
  keep_friction(middle, problem.set);
  grid.u = 2 * u_;
  grid.v_end = 2 / half * u_ - grid.v;
  hold_velocities(problem.set, grid.u, grid.v_end);
  return {std::move(newton), {}};
}

template class ImplicitMidpoint<2>;
template class ImplicitMidpoint<3>;

}  // namespace pf
