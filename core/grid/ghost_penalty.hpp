// What makes the consistent mass safe at free edges. Splines that reach but a sliver of the body have next to no mass
// and share what they have with their neighbours: M is nearly singular, and noise grows on them. The penalty
//   G = gamma m D^T D,  (D c)_i = -c_i + 3 c_{i+1} - 3 c_{i+2} + c_{i+3},
// on third differences of the coefficients along the grid's lines through a light node ties such a spline to its
// neighbours' extrapolation. It vanishes on quadratic fields, so it keeps momentum, angular momentum and the order
// (Burman 2010, Comptes Rendus 348: the ghost penalty; Coombs 2023, IJNME 124: ghost stabilisation of the MPM). Along
// an axis whose walls end the splines (core/grid/edges.hpp) lines that meet such a wall are left alone.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/grid/plan.hpp"
#include "core/math/block_matrix.hpp"

namespace pf {

template <int D>
class GhostPenalty {
 public:
  /// A node is light where it has less than this part of the heaviest mass within three nodes of it along each axis.
  static constexpr double light = 0.6;

  /// `lumped`: m_i, one a node [kg]; `gamma` > 0. m is the heaviest mass about the line.
  void build(const Plan<D>& plan, const Vector& lumped, double gamma);
  void clear() { lines_.clear(); }
  std::size_t lines() const { return lines_.size(); }

  /// out += G v, D components a node.
  void add_product(const Vector& v, Vector& out) const;
  /// One entry a node.
  void add_diagonal(Vector& diagonal) const;
  /// Calls add(i, j), i >= j, for each pair of nodes that G couples.
  void pairs(const std::function<void(std::int32_t, std::int32_t)>& add) const;
  /// H += factor G; H has a place for each of the pairs.
  void assemble(double factor, BlockMatrix<D>& H) const;

 private:
  void find_full(const Plan<D>& plan, const Vector& lumped);

  struct Line {
    std::array<std::int32_t, 4> node;
    double strength;  ///< gamma m [kg]
  };
  std::vector<Line> lines_;
  std::array<std::vector<std::int32_t>, D> next_;  ///< of each node along each axis; -1: none is active
  Vector full_, spread_;                           ///< the heaviest mass about each node [kg]
};

extern template class GhostPenalty<2>;
extern template class GhostPenalty<3>;

}  // namespace pf
