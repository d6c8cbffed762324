#include "core/integrators/tr_bdf2.hpp"

#include <numbers>

#include "core/integrators/stage.hpp"

namespace pf {

namespace {

constexpr double g = 2 - std::numbers::sqrt2, weight = 1 / (g * (2 - g)), past = (1 - g) * (1 - g);

}  // namespace

template <int D>
std::vector<ForcePart> TrBdf2<D>::parts(double) const {
  return {{g / 2 * weight, 0, 0}, {g / 2 * weight, g, 0, 1}, {g / 2, 1, 1}};
}

template <int D>
StepResult TrBdf2<D>::advance(const StepProblem<D>& problem) {
  GridState<D>& grid = problem.grid;
  const double k = g / 2 * problem.dt;  // = (1-g)/(2-g) dt
  const Vector &v = grid.v, nowhere = Vector::Zero(v.size());
  forces_at_start(problem, start_);

  FeasibleSet<D> set_g = problem.conditions.set_of_part(g);
  u_free_ = 2 * k * v;
  problem.conditions.force(g, loads_);
  loads_ += start_.loads;
  Vector u_g;
  const Stage<D> first{1 / (k * k), u_free_, loads_, &start_.inner, set_g};
  NewtonResult newton = minimise_stage(problem, first, memory_, u_g);
  if (newton.status != NewtonStatus::converged) {
    grid.u = grid.v_end = nowhere;
    return {std::move(newton), {}};
  }
  Vector v_g = 1 / k * u_g - v;
  hold_velocities(set_g, u_g, v_g);

  const Vector v_past = weight * (v_g - past * v), u_past = weight * u_g;
  u_free_ = u_past + k * v_past;
  problem.conditions.force(1, loads_);
  const Stage<D> second{1 / (k * k), u_free_, loads_, nullptr, problem.set};
  newton = join(std::move(newton), minimise_stage(problem, second, memory_, grid.u));
  grid.v_end = 1 / k * (grid.u - u_past);
  hold_velocities(problem.set, grid.u, grid.v_end);

  // In all M (v_1 - v) = weight [k (f_0 + f_g)] + k f_1.
  Vector middle, last;
  problem.mass.multiply(v_g - v, middle);
  middle -= k * (start_.loads + start_.inner);
  problem.mass.multiply(grid.v_end - v_past, last);
  return {std::move(newton), {{nowhere, weight * k * start_.loads}, {u_g, weight * middle}, {grid.u, last}}};
}

template class TrBdf2<2>;
template class TrBdf2<3>;

}  // namespace pf
