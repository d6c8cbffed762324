#include "core/integrators/backward_euler.hpp"

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
StepResult BackwardEuler<D>::advance(const StepProblem<D>& problem) {
  const double dt = problem.dt;
  u_free_ = dt * problem.grid.v;
  problem.conditions.force(1, loads_);
  const Stage<D> stage{1 / (dt * dt), u_free_, loads_, nullptr, problem.set};
  NewtonResult newton = minimise_stage(problem, stage, memory_, problem.grid.u, problem.error_rate);
  problem.grid.v_end = problem.grid.u / dt;
  return {std::move(newton), {}};
}

template class BackwardEuler<2>;
template class BackwardEuler<3>;

}  // namespace pf
