// What the solvers minimise: a smooth function of a long vector with D components a node. They know no particle and no
// grid.
#pragma once

#include <vector>

#include "core/math/block_matrix.hpp"
#include "core/math/projected.hpp"
#include "core/math/stencil_matrix.hpp"
#include "core/types.hpp"

namespace pf {

/// Where the nodes lie: multigrid coarsens their lattice.
template <int D>
struct Lattice {
  const std::vector<std::array<long long, D>>& index;
  int reach;  ///< nodes further apart than this along an axis are not coupled; the degree of the splines
};

template <int D>
class Objective {
 public:
  virtual ~Objective() = default;
  /// E(u); +infinity where u is not allowed.
  virtual double value(const Vector& u) = 0;
  /// E(u) and g = dE/du.
  virtual double gradient(const Vector& u, Vector& g) = 0;
  /// Fixes the Hessian at u, the point of the newest gradient(); its parts where `project` says so are positive
  /// semi-definite, and with them all, it is.
  virtual void prepare_hessian(const Vector& u, const Projected& project) = 0;
  virtual void hessian_product(const Vector& p, Vector& Hp) = 0;
  virtual void diagonal(std::vector<Mat<D>>& blocks) = 0;
  /// H, lower triangle; the pattern stays the same during a step.
  virtual void assemble(BlockMatrix<D>& H) = 0;
  virtual Lattice<D> lattice() const = 0;
  /// H for a preconditioner: nearly all of it, in single precision; node i is row row_of[i].
  virtual void assemble_stencil(StencilMatrix<D>& H, const std::vector<std::int32_t>& row_of) = 0;
  /// The norm of THEORY T4: components weighted by 1/sqrt(m_i).
  virtual double norm(const Vector& g) const = 0;
  /// What the norm of g is compared with at the point of the newest gradient(): T4's maximum.
  virtual double scale() const = 0;
  /// The norm of what rounding may leave of g where it should vanish. Found when it is asked for first: as much work as
  /// half a gradient.
  virtual double rounding() = 0;
  /// Size of the terms that E(u) is a sum of: below about 1e-15 of it differences of E are rounding. Once rounding()
  /// has been asked for, that of the numbers that they are made of.
  virtual double energy_scale() const = 0;
};

}  // namespace pf
