// What the node displacements u may be: fixed components (Dirichlet) and rigid boundaries (THEORY T4, T7), node by
// node.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace pf {

/// The constraints of one node: u = given on the fixed directions, n_k . u >= offset_k on the faces.
template <int D>
struct NodeConstraint {
  std::int32_t node = 0;
  Mat<D> free = Mat<D>::Identity();    ///< projector on the directions that are not fixed
  Vec<D> given = Vec<D>::Zero();       ///< displacement in the fixed directions (free * given = 0) [m]
  int faces = 0;                       ///< unilateral: separation is allowed, penetration is not
  std::array<Vec<D>, D> normal{};      ///< unit, out of the solid
  std::array<double, D> offset{};      ///< n . (displacement of the wall) [m]
  Vec<D> wall = Vec<D>::Zero();        ///< displacement of the wall during the step [m]
  double friction = 0;                 ///< Coulomb's coefficient
  Vec<D> rub_normal = Vec<D>::Zero();  ///< the face that it rubs against
  double rub_bound = 0;        ///< mu f_n, frozen during a minimisation [N]; starts from a guess, 0 when there is none
  bool by_constraint = false;  ///< fixed by "constraints", not by a boundary
};

/// Tangential slip of a displacement against the wall that a node rubs on.
template <int D>
Vec<D> rub_slip(const NodeConstraint<D>& c, const Vec<D>& u) {
  const Vec<D> w = u - c.wall;
  return c.free * (w - c.rub_normal * c.rub_normal.dot(w));
}

/// A closed convex set, the product of one cone or subspace a node, with frozen friction b |t| as the one part of the
/// function that has a corner: at rest, t = 0, the node sticks while the tangential gradient stays below b.
template <int D>
class FeasibleSet {
 public:
  std::vector<NodeConstraint<D>> constrained;  ///< at most one entry a node, by ascending node

  /// The nearest point of the set, node by node.
  void project(Vector& u) const;
  /// project(), then stops every rubbing node at rest where the way from `from` along -`g` passes through rest: beyond
  /// the corner the gradient is another one.
  /// `pressed`, of active_directions, faces that stay touched on the way: a node pressed on one face that meets another
  /// stops in the corner and does not slide off along the second one, uphill.
  void project_from(const Vector& from, const Vector& g, const std::vector<unsigned>& pressed, Vector& u) const;
  /// For each constrained node the projector on the directions that a minimiser may still take at u when the gradient
  /// is g: fixed directions, faces that are touched and pressed on, and the slip of nodes that stick are left out. `g`
  /// becomes what these directions leave of it, the smallest subgradient: zero at a minimum.
  /// `pressed`: a bit for each face that is touched and pressed on.
  void active_directions(const Vector& u, Vector& g, std::vector<Mat<D>>& directions,
                         std::vector<unsigned>& pressed) const;
  /// Zeroes what the projectors leave out.
  void restrict_to(const std::vector<Mat<D>>& directions, Vector& p) const;
};

extern template class FeasibleSet<2>;
extern template class FeasibleSet<3>;

}  // namespace pf
