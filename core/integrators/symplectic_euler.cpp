#include "core/integrators/symplectic_euler.hpp"

#include <algorithm>

namespace pf {

namespace {

/// Coulomb's law as an impulse: the wall took `correction` along the normal, it may take mu times that along the slip.
template <int D>
void rub(const FeasibleSet<D>& set, const Vector& before, Vector& u) {
  for (const NodeConstraint<D>& c : set.constrained) {
    if (!(c.friction > 0)) continue;
    auto value = u.segment<D>(c.node * D);
    const Vec<D> correction = value - before.segment<D>(c.node * D);
    const double pushed = correction.norm();
    if (pushed == 0) continue;
    const Vec<D> n = correction / pushed;
    const Vec<D> slip = (value - c.wall) - n * n.dot(value - c.wall);
    const double length = slip.norm();
    if (length > 0) value -= std::min(1.0, c.friction * pushed / length) * slip;
  }
}

}  // namespace

template <int D>
NewtonResult SymplecticEuler<D>::advance(const StepProblem<D>& problem) {
  GridState<D>& grid = problem.grid;
  Vector &g = g_, &a = a_, &u = grid.u;
  g = -problem.force;
  problem.elastic.add_force_at_rest(g);
  if (problem.grab) {
    Vector magnitude = Vector::Zero(grid.mass.size());
    u.setZero(grid.v.size());
    problem.grab->gradient(u, g, magnitude);
  }
  a.setZero(grid.v.size());
  if (problem.mass.consistent()) {
    double residual = 0;
    problem.mass.solve(-g, a, residual);
  } else {
    // A node whose mass is rounding has no acceleration of its own.
    const double rounding = 1e-14 * grid.mass.maxCoeff();
    for (Eigen::Index i = 0; i < grid.mass.size(); ++i)
      if (grid.mass[i] > rounding) a.segment<D>(i * D) = -g.segment<D>(i * D) / grid.mass[i];
  }
  const double kick = problem.kick > 0 ? problem.kick : problem.dt;
  u = problem.dt * (grid.v + kick * a);
  before_ = u;
  problem.set.project(u);
  rub(problem.set, before_, u);
  grid.v_end = u / problem.dt;
  return {};
}

template class SymplecticEuler<2>;
template class SymplecticEuler<3>;

}  // namespace pf
