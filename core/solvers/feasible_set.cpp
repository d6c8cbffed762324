#include "core/solvers/feasible_set.hpp"

#include <cmath>
#include <limits>

namespace pf {

namespace {

/// Nearest point to `target` with n_k . u >= offset_k, moving along `free` only: the few subsets of faces are tried.
/// `subset` receives the faces that hold with equality and push.
template <int D>
Vec<D> nearest(const NodeConstraint<D>& c, const Vec<D>& target, const std::array<double, D>& offset,
               unsigned candidates, unsigned required, unsigned& subset) {
  Vec<D> best = target;
  double best_distance = std::numeric_limits<double>::infinity();
  subset = 0;
  const double tolerance = 1e-12 * (1 + target.cwiseAbs().maxCoeff());
  for (unsigned s = 0; s < 1u << c.faces; ++s) {
    if ((s & candidates) != s || (s & required) != required) continue;
    // Gram-Schmidt over the chosen normals inside the free directions, satisfying each equality in turn.
    Vec<D> u = target;
    std::array<Vec<D>, D> axes;
    int count = 0;
    bool possible = true;
    for (int k = 0; k < c.faces && possible; ++k) {
      if (!(s >> k & 1)) continue;
      Vec<D> axis = c.free * c.normal[static_cast<std::size_t>(k)];
      for (int j = 0; j < count; ++j)
        axis -= axes[static_cast<std::size_t>(j)].dot(axis) * axes[static_cast<std::size_t>(j)];
      const double length = axis.norm();
      if (length < 1e-9) {
        possible = false;
        break;
      }
      axis /= length;
      const double along = c.normal[static_cast<std::size_t>(k)].dot(axis);
      u += (offset[static_cast<std::size_t>(k)] - c.normal[static_cast<std::size_t>(k)].dot(u)) / along * axis;
      axes[static_cast<std::size_t>(count++)] = axis;
    }
    if (!possible) continue;
    for (int k = 0; k < c.faces && possible; ++k)
      if (candidates >> k & 1)
        possible = c.normal[static_cast<std::size_t>(k)].dot(u) >= offset[static_cast<std::size_t>(k)] - tolerance;
    const double distance = (u - target).squaredNorm();
    if (possible && distance < best_distance) {
      best = u;
      best_distance = distance;
      subset = s;
    }
  }
  // Faces that cannot hold together (nearly parallel ones) are left to whichever are the nearest.
  if (required != 0 && !std::isfinite(best_distance)) return nearest<D>(c, target, offset, candidates, 0, subset);
  return best;
}

template <int D>
unsigned all_faces(const NodeConstraint<D>& c) {
  return (1u << c.faces) - 1;
}

}  // namespace

template <int D>
void FeasibleSet<D>::project(Vector& u) const {
  for (const NodeConstraint<D>& c : constrained) {
    auto at = u.segment<D>(c.node * D);
    Vec<D> value = c.free * at + c.given;
    unsigned subset = 0;
    if (c.faces > 0) value = nearest<D>(c, value, c.offset, all_faces(c), 0, subset);
    at = value;
  }
}

namespace {

/// The faces that u touches.
template <int D>
unsigned touched_faces(const NodeConstraint<D>& c, const Vec<D>& u) {
  unsigned touched = 0;
  for (int k = 0; k < c.faces; ++k) {
    const double gap = c.normal[static_cast<std::size_t>(k)].dot(u) - c.offset[static_cast<std::size_t>(k)];
    if (gap <= 1e-12 * (u.norm() + std::abs(c.offset[static_cast<std::size_t>(k)]))) touched |= 1u << k;
  }
  return touched;
}

/// Takes `axis` out of a projector.
template <int D>
void remove_axis(const Vec<D>& axis, Mat<D>& projector) {
  const Vec<D> left = projector * axis;
  const double length = left.norm();
  if (length > 1e-9) projector -= (left / length) * (left / length).transpose();
}

template <int D>
bool at_rest(const NodeConstraint<D>& c, const Vec<D>& slip) {
  return slip.norm() <= 1e-14 * (c.wall.norm() + 1e-300) || slip.isZero(0);
}

}  // namespace

template <int D>
void FeasibleSet<D>::project_from(const Vector& from, const Vector& g, const std::vector<unsigned>& pressed,
                                  Vector& u) const {
  for (std::size_t i = 0; i < constrained.size(); ++i) {
    const NodeConstraint<D>& c = constrained[i];
    auto at = u.segment<D>(c.node * D);
    Vec<D> value = c.free * at + c.given;
    unsigned subset = 0;
    if (c.faces > 0) value = nearest<D>(c, value, c.offset, all_faces(c), pressed[i], subset);
    at = value;
    if (!(c.rub_bound > 0)) continue;
    const Vec<D> before = rub_slip(c, Vec<D>(from.segment<D>(c.node * D)));
    const Vec<D> slip = rub_slip(c, value);
    Vec<D> heading = before;
    if (at_rest(c, before)) {
      const Vec<D> pull = c.free * -g.segment<D>(c.node * D);
      heading = pull - c.rub_normal * c.rub_normal.dot(pull);
    }
    if (slip.dot(heading) <= 0) u.segment<D>(c.node * D) = value - slip;
  }
}

template <int D>
void FeasibleSet<D>::active_directions(const Vector& u, Vector& g, std::vector<Mat<D>>& directions,
                                       std::vector<unsigned>& pressed) const {
  directions.resize(constrained.size());
  pressed.assign(constrained.size(), 0);
  for (std::size_t i = 0; i < constrained.size(); ++i) {
    const NodeConstraint<D>& c = constrained[i];
    directions[i] = c.free;
    auto force = g.segment<D>(c.node * D);
    force = (c.free * force).eval();
    const double scale = force.norm();
    if (scale == 0) continue;
    const Vec<D> value = u.segment<D>(c.node * D);
    if (const unsigned touched = touched_faces(c, value)) {
      // The steepest descent that stays in the set: what of -g the touched faces take away is their reaction.
      nearest<D>(c, Vec<D>(force / -scale), std::array<double, D>{}, touched, 0, pressed[i]);
      for (int k = 0; k < c.faces; ++k)
        if (pressed[i] >> k & 1) remove_axis<D>(c.normal[static_cast<std::size_t>(k)], directions[i]);
      force = (directions[i] * force).eval();
    }
    if (c.rub_bound > 0 && at_rest(c, rub_slip(c, value))) {
      const Vec<D> along = directions[i] * (force - c.rub_normal * c.rub_normal.dot(force));
      const double pull = along.norm();
      if (pull <= c.rub_bound) {
        const Mat<D> Q = directions[i];
        for (int a = 0; a < D; ++a) {
          const Vec<D> axis = Q.col(a) - c.rub_normal * c.rub_normal.dot(Q.col(a));
          remove_axis<D>(axis, directions[i]);
        }
        force = (directions[i] * force).eval();
      } else {
        force -= along * (c.rub_bound / pull);
      }
    }
  }
}

template <int D>
void FeasibleSet<D>::restrict_to(const std::vector<Mat<D>>& directions, Vector& p) const {
  for (std::size_t i = 0; i < constrained.size(); ++i) {
    auto at = p.segment<D>(constrained[i].node * D);
    at = (directions[i] * at).eval();
  }
}

template class FeasibleSet<2>;
template class FeasibleSet<3>;

}  // namespace pf
