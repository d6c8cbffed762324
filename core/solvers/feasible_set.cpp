#include "core/solvers/feasible_set.hpp"

#include <algorithm>
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

/// A face is touched where the gap to it is at most this.
template <int D>
double contact_tolerance(const NodeConstraint<D>& c, std::size_t face, const Vec<D>& u, double rounding) {
  return std::max(rounding, 1e-12 * (u.norm() + std::abs(c.offset[face])));
}

/// The faces that u touches.
template <int D>
unsigned touched_faces(const NodeConstraint<D>& c, const Vec<D>& u, double rounding) {
  unsigned touched = 0;
  for (int k = 0; k < c.faces; ++k) {
    const auto face = static_cast<std::size_t>(k);
    if (c.normal[face].dot(u) - c.offset[face] <= contact_tolerance(c, face, u, rounding)) touched |= 1u << k;
  }
  return touched;
}

/// Takes `axis` out of a projector.
template <int D>
void remove_axis(const Vec<D>& axis, Mat<D>& projector) {
  const Vec<D> left = projector * axis;
  const double length = left.norm();
  if (length > 1e-9) projector -= (left / length) * (left / length).transpose();
  if (projector.trace() < 0.5) projector.setZero();  // nothing is left but rounding
}

template <int D>
void remove_faces(const NodeConstraint<D>& c, unsigned faces, Mat<D>& projector) {
  for (int k = 0; k < c.faces; ++k)
    if (faces >> k & 1) remove_axis<D>(c.normal[static_cast<std::size_t>(k)], projector);
}

template <int D>
void remove_slip(const NodeConstraint<D>& c, Mat<D>& projector) {
  const Mat<D> Q = projector;
  for (int a = 0; a < D; ++a) {
    const Vec<D> axis = Q.col(a) - c.rub_normal * c.rub_normal.dot(Q.col(a));
    remove_axis<D>(axis, projector);
  }
}

/// Brings a node to rest against its wall, exactly where rounding allows.
template <int D, class Segment>
void stop(const NodeConstraint<D>& c, Segment&& at) {
  for (int k = 0; k < 2; ++k) at -= rub_slip(c, Vec<D>(at));
}

/// Whether a rubbing node that goes from `from`, where the gradient is g, to `to` comes to rest on the way.
template <int D>
bool passes_rest(const NodeConstraint<D>& c, const Vec<D>& from, const Vec<D>& g, const Vec<D>& to, double rounding) {
  if (!(c.rub_bound > 0)) return false;
  Vec<D> heading = rub_slip(c, from);
  if (at_rest(c, heading, rounding)) {
    const Vec<D> pull = c.free * -g;
    heading = pull - c.rub_normal * c.rub_normal.dot(pull);
  }
  return rub_slip(c, to).dot(heading) <= 0;
}

}  // namespace

template <int D>
void FeasibleSet<D>::project_from(const Vector& from, const Vector& g, const ActiveSet<D>& active, Vector& u) const {
  for (std::size_t i = 0; i < constrained.size(); ++i) {
    const NodeConstraint<D>& c = constrained[i];
    auto at = u.segment<D>(c.node * D);
    Vec<D> value = c.free * at + c.given;
    unsigned subset = 0;
    if (c.faces > 0) value = nearest<D>(c, value, c.offset, all_faces(c), 0, subset);
    at = value;
    if (!(c.rub_bound > 0)) continue;
    const Vec<D> start = from.segment<D>(c.node * D), slip = rub_slip(c, value);
    const bool rests = at_rest(c, slip, rounding) || (active.stuck[i] && slip.norm() <= 1e-9 * (value - start).norm());
    if (rests || passes_rest<D>(c, start, g.segment<D>(c.node * D), value, rounding)) stop(c, at);
  }
}

template <int D>
void FeasibleSet<D>::active_set(const Vector& u, Vector& g, ActiveSet<D>& active) const {
  std::vector<Mat<D>>& directions = active.directions;
  directions.resize(constrained.size());
  active.pressed.assign(constrained.size(), 0);
  active.stuck.assign(constrained.size(), 0);
  for (std::size_t i = 0; i < constrained.size(); ++i) {
    const NodeConstraint<D>& c = constrained[i];
    directions[i] = c.free;
    auto force = g.segment<D>(c.node * D);
    force = (c.free * force).eval();
    const double scale = force.norm();
    if (scale == 0) continue;
    const Vec<D> value = u.segment<D>(c.node * D);
    if (const unsigned touched = touched_faces(c, value, rounding)) {
      // The steepest descent that stays in the set: what of -g the touched faces take away is their reaction.
      nearest<D>(c, Vec<D>(force / -scale), std::array<double, D>{}, touched, 0, active.pressed[i]);
      remove_faces(c, active.pressed[i], directions[i]);
      force = (directions[i] * force).eval();
    }
    if (c.rub_bound > 0 && at_rest(c, rub_slip(c, value), rounding)) {
      const Vec<D> along = directions[i] * (force - c.rub_normal * c.rub_normal.dot(force));
      const double pull = along.norm();
      if (pull <= c.rub_bound) {
        remove_slip(c, directions[i]);
        active.stuck[i] = 1;
        force = (directions[i] * force).eval();
      } else {
        force -= along * (c.rub_bound / pull);
      }
    }
  }
}

template <int D>
bool FeasibleSet<D>::crosses(const Vector& u, const Vector& g, const Vector& d, const ActiveSet<D>& active) const {
  for (std::size_t i = 0; i < constrained.size(); ++i) {
    const NodeConstraint<D>& c = constrained[i];
    const Vec<D> from = u.segment<D>(c.node * D), step = d.segment<D>(c.node * D);
    const Vec<D> to = from + step;
    for (int k = 0; k < c.faces; ++k) {
      if (active.pressed[i] >> k & 1) continue;
      const auto face = static_cast<std::size_t>(k);
      if (c.normal[face].dot(to) - c.offset[face] < -contact_tolerance(c, face, to, rounding)) return true;
    }
    if (!active.stuck[i] && passes_rest<D>(c, from, g.segment<D>(c.node * D), to, rounding)) return true;
  }
  return false;
}

template <int D>
bool FeasibleSet<D>::update_active(const Vector& u, const Vector& g, const Vector& d, const Vector& r, double tau,
                                   ActiveSet<D>& active, Vector& held) const {
  held.setZero(u.size());
  bool changed = false;
  for (std::size_t i = 0; i < constrained.size(); ++i) {
    const NodeConstraint<D>& c = constrained[i];
    const Vec<D> from = u.segment<D>(c.node * D), step = d.segment<D>(c.node * D);
    const Vec<D> to = c.free * (from + step) + c.given;
    // A node at rest is held by friction too, which is no part of r: only the normal part is the faces' business.
    Vec<D> reaction = c.free * r.segment<D>(c.node * D);
    if (c.rub_bound > 0 && at_rest(c, rub_slip(c, from), rounding))
      reaction = c.rub_normal * c.rub_normal.dot(reaction);
    unsigned faces = 0, ignored = 0;
    Vec<D> point = to;
    if (c.faces > 0) nearest<D>(c, Vec<D>(to - tau * reaction), c.offset, all_faces(c), 0, faces);
    if (faces != 0) point = nearest<D>(c, to, c.offset, faces, faces, ignored);
    const bool stuck = active.stuck[i] || passes_rest<D>(c, from, g.segment<D>(c.node * D), point, rounding);
    changed |= faces != active.pressed[i] || stuck != static_cast<bool>(active.stuck[i]);
    active.pressed[i] = faces;
    active.stuck[i] = stuck;
    Mat<D>& Q = active.directions[i];
    Q = c.free;
    remove_faces(c, faces, Q);
    if (stuck) {
      remove_slip(c, Q);
      stop(c, point);
    }
    held.segment<D>(c.node * D) = (c.free - Q) * (point - from);
  }
  return changed;
}

template <int D>
double FeasibleSet<D>::slope(const Vector& u, const Vector& g, const Vector& d) const {
  double slope = g.dot(d);
  for (const NodeConstraint<D>& c : constrained) {
    if (!(c.rub_bound > 0)) continue;
    const Vec<D> from = u.segment<D>(c.node * D), step = d.segment<D>(c.node * D);
    if (at_rest(c, rub_slip(c, from), rounding)) slope += c.rub_bound * rub_slip(c, Vec<D>(from + step)).norm();
  }
  return slope;
}

template <int D>
void FeasibleSet<D>::natural_residual(const Vector& u, const Vector& g, const Vector& tau, Vector& free_g) const {
  for (const NodeConstraint<D>& c : constrained) {
    const double t = tau[c.node];
    if ((c.faces == 0 && !(c.rub_bound > 0)) || !(t > 0)) continue;
    auto rest = free_g.segment<D>(c.node * D);
    if (rest.isZero(0)) continue;
    const Vec<D> from = u.segment<D>(c.node * D);
    Vec<D> force = c.free * g.segment<D>(c.node * D);
    const Vec<D> slip = rub_slip(c, from);
    // g holds the friction of a node that slides; the proximal map brings its own.
    if (c.rub_bound > 0 && !at_rest(c, slip, rounding)) force -= c.rub_bound / slip.norm() * slip;
    Vec<D> to = from - t * force;
    unsigned ignored = 0;
    if (c.faces > 0) to = nearest<D>(c, to, c.offset, all_faces(c), 0, ignored);
    if (c.rub_bound > 0) {
      const Vec<D> way = rub_slip(c, to);
      const double length = way.norm();
      if (length > 0) to -= way * std::min(1.0, t * c.rub_bound / length);
    }
    const Vec<D> natural = (from - to) / t;
    if (natural.norm() < rest.norm()) rest = natural;
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
