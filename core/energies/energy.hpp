// A term of the incremental potential E (THEORY T4) as a function of the node displacements u = x^ - x.
#pragma once

#include <functional>
#include <vector>

#include "core/math/block_matrix.hpp"
#include "core/math/projected.hpp"
#include "core/math/stencil_matrix.hpp"
#include "core/types.hpp"

namespace pf {

/// Vectors hold D components a node, node-major. All additions: the terms of a potential share their outputs.
template <int D>
class Energy {
 public:
  virtual ~Energy() = default;
  /// E(u) [J]; +infinity where the term does not allow u (J <= 0 under a barrier).
  virtual double value(const Vector& u) = 0;
  /// E(u), and g += dE/du. `magnitude`, one entry a node, += the sum of the sizes of what was added up in g (THEORY T4,
  /// s_i): zero for terms whose scale is known elsewhere.
  virtual double gradient(const Vector& u, Vector& g, Vector& magnitude) = 0;
  /// Fixes d2E/du2 at u for the calls below, its parts where `project` says so positive semi-definite.
  virtual void prepare_hessian(const Vector& u, const Projected& project) = 0;
  /// Hp += d2E/du2 p.
  virtual void hessian_product(const Vector& p, Vector& Hp) = 0;
  /// The D x D diagonal blocks, one a node, are added to `blocks`.
  virtual void diagonal(std::vector<Mat<D>>& blocks) = 0;
  /// Of terms that are differences of large numbers: `level`, one entry a node, += what rounding may leave in
  /// gradient() whatever u is [N]. Returns K [J] where value() E is as exact as rounding of sqrt(2 K E): strains are
  /// known to so many digits after the point.
  virtual double rounding(Vector& /*level*/) { return 0; }
  /// Calls add(i, j), i >= j, for each pair of nodes beside those that share a cell that assemble() adds to.
  virtual void far_pairs(const std::function<void(std::int32_t, std::int32_t)>& /*add*/) const {}
  /// All of d2E/du2 is added to H, whose pattern holds every pair of nodes that share a cell, and the far pairs.
  virtual void assemble(BlockMatrix<D>& H) = 0;
  /// The same for a preconditioner: node i is row row_of[i] of H. False, and nothing is added, where the term's
  /// diagonal blocks say enough.
  virtual bool assemble_stencil(StencilMatrix<D>& /*H*/, const std::vector<std::int32_t>& /*row_of*/) { return false; }
};

}  // namespace pf
