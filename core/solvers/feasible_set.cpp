#include "core/solvers/feasible_set.hpp"

#include <cmath>
#include <limits>

namespace pf {

namespace {

/// Nearest point to `target` with n_k . u >= offset_k, moving along `free` only: the few subsets of faces are tried.
/// `subset` receives the faces that hold with equality and push.
template <int D>
Vec<D> nearest(const NodeConstraint<D>& c, const Vec<D>& target, const std::array<double, D>& offset, unsigned candidates,
               unsigned& subset) {
  Vec<D> best = target;
  double best_distance = std::numeric_limits<double>::infinity();
  subset = 0;
  const double tolerance = 1e-12 * (1 + target.cwiseAbs().maxCoeff());
  for (unsigned s = 0; s < 1u << c.faces; ++s) {
    if ((s & candidates) != s) continue;
    // Gram-Schmidt over the chosen normals inside the free directions, satisfying each equality in turn.
    Vec<D> u = target;
    std::array<Vec<D>, D> axes;
    int count = 0;
    bool possible = true;
    for (int k = 0; k < c.faces && possible; ++k) {
      if (!(s >> k & 1)) continue;
      Vec<D> axis = c.free * c.normal[static_cast<std::size_t>(k)];
      for (int j = 0; j < count; ++j) axis -= axes[static_cast<std::size_t>(j)].dot(axis) * axes[static_cast<std::size_t>(j)];
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
    if (c.faces > 0) value = nearest<D>(c, value, c.offset, all_faces(c), subset);
    at = value;
  }
}

template <int D>
void FeasibleSet<D>::active_directions(const Vector& u, const Vector& g, std::vector<Mat<D>>& directions) const {
  directions.resize(constrained.size());
  for (std::size_t i = 0; i < constrained.size(); ++i) {
    const NodeConstraint<D>& c = constrained[i];
    directions[i] = c.free;
    if (c.faces == 0) continue;
    const Vec<D> value = u.segment<D>(c.node * D);
    unsigned touched = 0;
    for (int k = 0; k < c.faces; ++k) {
      const double gap = c.normal[static_cast<std::size_t>(k)].dot(value) - c.offset[static_cast<std::size_t>(k)];
      if (gap <= 1e-12 * (value.norm() + std::abs(c.offset[static_cast<std::size_t>(k)]))) touched |= 1u << k;
    }
    if (touched == 0) continue;
    // The steepest descent that stays in the set: what of -g the touched faces take away is their reaction.
    Vec<D> descent = c.free * -g.segment<D>(c.node * D);
    const double scale = descent.norm();
    if (scale == 0) continue;
    descent /= scale;
    unsigned pressed = 0;
    nearest<D>(c, descent, std::array<double, D>{}, touched, pressed);
    for (int k = 0; k < c.faces; ++k) {
      if (!(pressed >> k & 1)) continue;
      Vec<D> axis = directions[i] * c.normal[static_cast<std::size_t>(k)];
      const double length = axis.norm();
      if (length > 1e-9) directions[i] -= (axis / length) * (axis / length).transpose();
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
