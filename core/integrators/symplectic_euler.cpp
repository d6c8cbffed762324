#include "core/integrators/symplectic_euler.hpp"

#include <algorithm>

#include "core/integrators/stage.hpp"

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

/// The accelerations that lead to the displacements of `set` in u = dt (v + kick a).
template <int D>
FeasibleSet<D> in_accelerations(const FeasibleSet<D>& set, const Vector& v, double dt, double kick) {
  FeasibleSet<D> result = set;
  for (NodeConstraint<D>& c : result.constrained) {
    const Vec<D> v_i = v.segment<D>(c.node * D);
    c.given = ((c.given / dt - (v_i - c.free * v_i)) / kick).eval();
    for (std::size_t k = 0; k < static_cast<std::size_t>(c.faces); ++k)
      c.offset[k] = (c.offset[k] / dt - c.normal[k].dot(v_i)) / kick;
    c.friction = c.rub_bound = 0;
  }
  return result;
}

}  // namespace

template <int D>
StepResult SymplecticEuler<D>::advance(const StepProblem<D>& problem) {
  GridState<D>& grid = problem.grid;
  forces_at_start(problem, start_);
  force_ = start_.loads + start_.inner;
  const double dt = problem.dt, kick = problem.kick > 0 ? problem.kick : dt;
  const Vector& m = grid.mass;
  // A node whose mass is rounding has no acceleration of its own.
  const double rounding = 1e-14 * m.maxCoeff();
  const auto over_mass = [&](const Vector& f, Vector& a) {
    a.setZero(f.size());
    for (Eigen::Index i = 0; i < m.size(); ++i)
      if (m[i] > rounding) a.segment<D>(i * D) = f.segment<D>(i * D) / m[i];
  };
  NewtonResult result;
  over_mass(force_, a_);
  if (!problem.mass.consistent()) {
    before_ = dt * (grid.v + kick * a_);
  } else if (problem.set.constrained.empty()) {
    double residual = 0;
    a_.setZero();
    problem.mass.solve(force_, a_, residual);
    before_ = dt * (grid.v + kick * a_);
  } else {
    // A full mass couples what is held with what is free: both are one system. What the walls give is its residual.
    result = minimise_acceleration(problem, force_, in_accelerations(problem.set, grid.v, dt, kick), a_);
    Vector reaction, by_walls;
    problem.mass.multiply(a_, reaction);
    reaction -= force_;
    over_mass(reaction, by_walls);
    before_ = dt * (grid.v + kick * (a_ - by_walls));
    result.iterations.clear();  // of a linear system
  }
  grid.u = dt * (grid.v + kick * a_);
  problem.set.project(grid.u);
  rub(problem.set, before_, grid.u);
  grid.v_end = grid.u / dt;
  return {std::move(result), {}};
}

template class SymplecticEuler<2>;
template class SymplecticEuler<3>;

}  // namespace pf
