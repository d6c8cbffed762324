// What the node displacements u may be: fixed components (Dirichlet) and rigid boundaries (THEORY T4, T7), node by node.
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
  Mat<D> free = Mat<D>::Identity();  ///< projector on the directions that are not fixed
  Vec<D> given = Vec<D>::Zero();     ///< displacement in the fixed directions (free * given = 0) [m]
  int faces = 0;                     ///< unilateral: separation is allowed, penetration is not
  std::array<Vec<D>, D> normal{};    ///< unit, out of the solid
  std::array<double, D> offset{};    ///< n . (displacement of the wall) [m]
  double friction = 0;               ///< Coulomb's coefficient against the faces, or against slip's fixed normal
  Vec<D> wall = Vec<D>::Zero();      ///< displacement of the wall during the step [m]
  std::uint16_t boundary = 0;        ///< the boundary whose friction acts
  bool by_constraint = false;        ///< fixed by "constraints", not by a boundary
};

/// A closed convex set, the product of one cone or subspace a node.
template <int D>
class FeasibleSet {
 public:
  std::vector<NodeConstraint<D>> constrained;  ///< at most one entry a node, by ascending node

  /// The nearest point of the set, node by node.
  void project(Vector& u) const;
  /// For each constrained node the projector on the directions that a minimiser may still take at u when the gradient
  /// is g: fixed directions and faces that are touched and pressed on are left out.
  void active_directions(const Vector& u, const Vector& g, std::vector<Mat<D>>& directions) const;
  /// Zeroes what the projectors leave out.
  void restrict_to(const std::vector<Mat<D>>& directions, Vector& p) const;
};

extern template class FeasibleSet<2>;
extern template class FeasibleSet<3>;

}  // namespace pf
