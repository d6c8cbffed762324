#include "core/integrators/quasi_static.hpp"

#include "core/integrators/stage.hpp"

namespace pf {

template <int D>
StepResult QuasiStatic<D>::advance(const StepProblem<D>& problem) {
  const double dt = problem.dt;
  u_free_ = dt * problem.grid.v;
  problem.conditions.force(1, loads_);
  const Stage<D> stage{0, u_free_, loads_, nullptr, problem.set};
  NewtonResult newton = minimise_stage(problem, stage, memory_, problem.grid.u);
  problem.grid.v_end = problem.grid.u / dt;
  return {std::move(newton), {}};
}

template class QuasiStatic<2>;
template class QuasiStatic<3>;

}  // namespace pf
