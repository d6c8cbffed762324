// The scene's constraints and boundaries as a feasible set of each step (INTERFACE fine print 6, THEORY T7).
#pragma once

#include <memory>

#include "core/grid/plan.hpp"
#include "core/scene/solid.hpp"
#include "core/solvers/feasible_set.hpp"
#include "core/step/formulas.hpp"

namespace pf {

template <int D>
class Conditions {
 public:
  explicit Conditions(const Scene& scene);

  /// Classifies the plan's nodes at t and integrates the given velocities over [t, t + dt]. Throws InputError when two
  /// constraints set one component differently.
  FeasibleSet<D> at(const Plan<D>& plan, double t, double dt) const {
    FeasibleSet<D> set;
    at(plan, t, dt, set);
    return set;
  }
  /// The same in the memory of `set`.
  void at(const Plan<D>& plan, double t, double dt, FeasibleSet<D>& set) const;
  /// The boundaries move on over [t, t + dt].
  void advance(double t, double dt);

  /// Displacement of each boundary since t = 0 [m].
  std::vector<Vec<D>>& displacement() { return displacement_; }
  const std::vector<Vec<D>>& displacement() const { return displacement_; }
  /// Projector on the directions in which nothing holds the point where walls stand now: what a constraint fixes, a
  /// face's normal, all of a face that sticks or rubs.
  Mat<D> free_at(const Vec<D>& x) const;

 private:
  struct Wall {
    std::unique_ptr<Solid> solid;
    FormulaField<D> velocity;
    bool invert = false;
    enum { stick, slip, separate } contact = separate;
    double friction = 0;
  };
  struct Fixing {
    std::unique_ptr<Solid> region;
    FormulaField<D> velocity;
    std::array<bool, D> fix{};
  };

  /// How a wall or a fixed region moves over [t, t + dt].
  struct Moved {
    Vec<D> displacement;  ///< [m]
    Vec<D> velocity;      ///< at t + dt [m/s]
    Vec<D> acceleration;  ///< mean [m/s^2]
  };

  static Moved moved_by(const FormulaField<D>& velocity, double t, double dt);
  void constrain(NodeConstraint<D>& c, const Vec<D>& x, const std::vector<Moved>& moved, std::array<int, D>& by) const;
  void touch(NodeConstraint<D>& c, const Vec<D>& x, const std::vector<Moved>& moved) const;

  mutable std::vector<Moved> fixed_move_, wall_move_;  ///< of at(): kept for their memory alone
  mutable std::vector<Vec3> normals_;                  ///< of touch()
  std::vector<Wall> walls_;
  std::vector<Fixing> fixings_;
  std::vector<Vec<D>> displacement_;
  double tolerance_;
};

extern template class Conditions<2>;
extern template class Conditions<3>;

}  // namespace pf
