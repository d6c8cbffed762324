// What the node displacements u may be: fixed components (Dirichlet) and rigid boundaries (THEORY T4, T7), node by
// node.
#pragma once

#include <algorithm>
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
  // At the step's end, of the fixed directions (free * ... = 0) and of the wall: for schemes that carry more than u.
  Vec<D> given_velocity = Vec<D>::Zero(), wall_velocity = Vec<D>::Zero();          ///< [m/s]
  Vec<D> given_acceleration = Vec<D>::Zero(), wall_acceleration = Vec<D>::Zero();  ///< mean over the step [m/s^2]
};

/// Lengths of no meaning: gaps and slips below this part of a cell are zero.
constexpr double rounding_of_cell = 1e-13;

/// Tangential slip of a displacement against the wall that a node rubs on.
template <int D>
Vec<D> rub_slip(const NodeConstraint<D>& c, const Vec<D>& u) {
  const Vec<D> w = u - c.wall;
  return c.free * (w - c.rub_normal * c.rub_normal.dot(w));
}

/// What a minimiser may do at a point of a FeasibleSet, one entry a constrained node.
template <int D>
struct ActiveSet {
  std::vector<Mat<D>> directions;  ///< projectors on the directions that are still free
  std::vector<unsigned> pressed;   ///< a bit for each face that is held with equality
  std::vector<char> stuck;         ///< whether the slip of a rubbing node is held at zero
};

/// Whether a slip is none but for rounding.
template <int D>
bool at_rest(const NodeConstraint<D>& c, const Vec<D>& slip, double rounding) {
  return slip.norm() <= std::max(rounding, 1e-14 * c.wall.norm());
}

/// A closed convex set, the product of one cone or subspace a node, with frozen friction b |t| as the one part of the
/// function that has a corner: at rest, t = 0, the node sticks while the tangential gradient stays below b.
template <int D>
class FeasibleSet {
 public:
  std::vector<NodeConstraint<D>> constrained;  ///< at most one entry a node, by ascending node
  double rounding = 0;                         ///< gaps and slips up to this are zero [m]

  /// The nearest point of the set, node by node.
  void project(Vector& u) const;
  /// project(), then stops every rubbing node at rest where the way from `from` along -`g` passes through rest (beyond
  /// the corner the gradient is another one) or where it sticks but for rounding.
  void project_from(const Vector& from, const Vector& g, const ActiveSet<D>& active, Vector& u) const;
  /// What a minimiser may still do at u when the gradient is g: fixed directions, faces that are touched and pressed
  /// on, and the slip of nodes that stick are left out. `g` becomes what the directions leave of it, the smallest
  /// subgradient: zero at a minimum.
  void active_set(const Vector& u, Vector& g, ActiveSet<D>& active) const;
  /// Whether u + d leaves the set through a face that is not held, or carries a rubbing node through rest.
  bool crosses(const Vector& u, const Vector& g, const Vector& d, const ActiveSet<D>& active) const;
  /// One update of the primal-dual active set method (Hintermueller, Ito and Kunisch 2003) for the quadratic model of
  /// the function at u: from a trial step d and the model's gradient there, r = g + H d, which faces hold next: those
  /// that the projection of u + d - tau r on the set touches. Nodes that d carries through rest stick. `held` becomes
  /// the part of the step that the active set prescribes, orthogonal to its directions. False: nothing has changed, d
  /// minimises the model over the set.
  bool update_active(const Vector& u, const Vector& g, const Vector& d, const Vector& r, double tau,
                     ActiveSet<D>& active, Vector& held) const;
  /// The function's slope at u along a step d that stays in the set, when its gradient is g.
  double slope(const Vector& u, const Vector& g, const Vector& d) const;
  /// The natural residual (u - P(u - tau g)) / tau of the constrained nodes, P the proximal map of the set and the
  /// friction, where it is smaller than what `free_g` of active_set holds. Unlike that it is continuous in u: a node
  /// that is pressed on a face and a hair away from it is not a force that nothing balances (Facchinei and Pang 2003,
  /// section 1.5.1). `tau`, one a node [m/N], about the inverse stiffness: gap / tau is the force that closes the gap.
  void natural_residual(const Vector& u, const Vector& g, const Vector& tau, Vector& free_g) const;
  /// Zeroes what the projectors leave out.
  void restrict_to(const std::vector<Mat<D>>& directions, Vector& p) const;
};

extern template class FeasibleSet<2>;
extern template class FeasibleSet<3>;

}  // namespace pf
