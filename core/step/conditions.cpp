#include "core/step/conditions.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/scene_io.hpp"

namespace pf {

namespace {

template <int D>
Vec3 in_space(const Vec<D>& x) {
  Vec3 y = Vec3::Zero();
  y.head<D>() = x;
  return y;
}

}  // namespace

template <int D>
Conditions<D>::Conditions(const Scene& scene) : tolerance_(1e-9 * scene.grid.spacing) {
  for (const Boundary& b : scene.boundaries) {
    Wall wall;
    wall.solid = make_solid(b.shape, D, scene.constants);
    wall.velocity = FormulaField<D>(b.velocity, scene.constants, mask_time);
    wall.invert = b.invert;
    wall.contact = b.contact == "stick" ? Wall::stick : b.contact == "slip" ? Wall::slip : Wall::separate;
    wall.friction = b.friction;
    walls_.push_back(std::move(wall));
  }
  displacement_.assign(walls_.size(), Vec<D>::Zero());
  for (const Constraint& c : scene.constraints) {
    Fixing fixing;
    fixing.region = make_solid(c.region, D, scene.constants);
    fixing.velocity = FormulaField<D>(c.velocity, scene.constants, mask_time);
    for (std::size_t a = 0; a < D; ++a) fixing.fix[a] = a < c.fix.size() && c.fix[a];
    fixings_.push_back(std::move(fixing));
  }
}

template <int D>
typename Conditions<D>::Moved Conditions<D>::moved_by(const FormulaField<D>& velocity, double t, double dt) {
  if (velocity.zero()) return {Vec<D>::Zero(), Vec<D>::Zero(), Vec<D>::Zero()};
  const Vec<D> nowhere = Vec<D>::Zero(), end = velocity(nowhere, nowhere, t + dt);
  const Vec<D> gained = end - velocity(nowhere, nowhere, t);
  return {velocity.integral(t, dt), end, dt > 0 ? Vec<D>(gained / dt) : Vec<D>::Zero()};
}

template <int D>
void Conditions<D>::constrain(NodeConstraint<D>& c, const Vec<D>& x, const std::vector<Moved>& moved,
                              std::array<int, D>& by) const {
  for (std::size_t k = 0; k < fixings_.size(); ++k) {
    const Fixing& fixing = fixings_[k];
    if (!fixing.region->contains(in_space<D>(x), tolerance_)) continue;
    for (int a = 0; a < D; ++a) {
      const auto s = static_cast<std::size_t>(a);
      if (!fixing.fix[s]) continue;
      const double move = moved[k].displacement[a];
      if (by[s] >= 0 && std::abs(c.given[a] - move) > 1e-12 * (std::abs(c.given[a]) + std::abs(move)))
        throw InputError(
            "", {{"/constraints/" + std::to_string(k),
                  "another velocity for component " + std::to_string(a) + " than /constraints/" + std::to_string(by[s]),
                  "one velocity for each component where regions overlap", 0}});
      by[s] = static_cast<int>(k);
      c.given[a] = move;
      c.given_velocity[a] = moved[k].velocity[a];
      c.given_acceleration[a] = moved[k].acceleration[a];
      c.free(a, a) = 0;
      c.by_constraint = true;
    }
  }
}

template <int D>
void Conditions<D>::touch(NodeConstraint<D>& c, const Vec<D>& x, const std::vector<Moved>& moved) const {
  std::vector<Vec3>& normals = normals_;
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    const Wall& wall = walls_[k];
    normals.clear();
    wall.solid->contact_normals(in_space<D>(Vec<D>(x - displacement_[k])), wall.invert, tolerance_, normals);
    if (normals.empty()) continue;
    if (wall.contact == Wall::stick) {
      c.given += c.free * moved[k].displacement;
      c.given_velocity += c.free * moved[k].velocity;
      c.given_acceleration += c.free * moved[k].acceleration;
      c.free.setZero();
      continue;
    }
    for (const Vec3& full : normals) {
      const Vec<D> n = full.head<D>();
      const Vec<D> axis = c.free * n;
      if (axis.norm() < 1e-6) continue;  // a constraint or another wall has it already
      c.friction = std::max(c.friction, wall.friction);
      c.wall = moved[k].displacement;
      c.wall_velocity = moved[k].velocity;
      c.wall_acceleration = moved[k].acceleration;
      if (wall.contact == Wall::slip) {
        const Vec<D> direction = axis.normalized();
        const auto follow = [&](const Vec<D>& of_wall, Vec<D>& given) {
          given += direction * (n.dot(of_wall - given) / n.dot(direction));
        };
        follow(c.wall, c.given);
        follow(c.wall_velocity, c.given_velocity);
        follow(c.wall_acceleration, c.given_acceleration);
        c.free -= direction * direction.transpose();
      } else if (c.faces < D) {
        c.normal[static_cast<std::size_t>(c.faces)] = n;
        c.offset[static_cast<std::size_t>(c.faces)] = n.dot(c.wall);
        ++c.faces;
      }
    }
  }
  // A direction that was fixed after a face was noted leaves that face nothing to hold.
  int kept = 0;
  for (int f = 0; f < c.faces; ++f)
    if ((c.free * c.normal[static_cast<std::size_t>(f)]).norm() > 1e-6) {
      c.normal[static_cast<std::size_t>(kept)] = c.normal[static_cast<std::size_t>(f)];
      c.offset[static_cast<std::size_t>(kept++)] = c.offset[static_cast<std::size_t>(f)];
    }
  c.faces = kept;
}

template <int D>
void Conditions<D>::at(const Plan<D>& plan, double t, double dt, FeasibleSet<D>& set) const {
  set.constrained.clear();
  set.rounding = rounding_of_cell * plan.spacing();
  if (walls_.empty() && fixings_.empty()) return;
  fixed_move_.clear();
  wall_move_.clear();
  for (const Fixing& f : fixings_) fixed_move_.push_back(moved_by(f.velocity, t, dt));
  for (const Wall& w : walls_) wall_move_.push_back(moved_by(w.velocity, t, dt));
  for (int i = 0; i < plan.node_count(); ++i) {
    NodeConstraint<D> c;
    c.node = i;
    const Vec<D> x = plan.node_position(i);
    std::array<int, D> by;
    by.fill(-1);
    constrain(c, x, fixed_move_, by);
    touch(c, x, wall_move_);
    if (c.faces > 0 || c.free != Mat<D>::Identity()) set.constrained.push_back(c);
  }
}

template <int D>
void Conditions<D>::advance(double t, double dt) {
  for (std::size_t k = 0; k < walls_.size(); ++k) displacement_[k] += walls_[k].velocity.integral(t, dt);
}

template <int D>
Mat<D> Conditions<D>::free_at(const Vec<D>& x) const {
  Mat<D> free = Mat<D>::Identity();
  for (const Fixing& f : fixings_) {
    if (!f.region->contains(in_space<D>(x), tolerance_)) continue;
    for (int a = 0; a < D; ++a)
      if (f.fix[static_cast<std::size_t>(a)]) free(a, a) = 0;
  }
  std::vector<Vec3> normals;
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    normals.clear();
    walls_[k].solid->contact_normals(in_space<D>(Vec<D>(x - displacement_[k])), walls_[k].invert, tolerance_, normals);
    if (!normals.empty() && (walls_[k].contact == Wall::stick || walls_[k].friction > 0)) free.setZero();
    for (const Vec3& full : normals) {
      const Vec<D> axis = free * full.head<D>();
      if (axis.norm() > 1e-6) free -= axis.normalized() * axis.normalized().transpose();
    }
  }
  return free;
}

template class Conditions<2>;
template class Conditions<3>;

}  // namespace pf
