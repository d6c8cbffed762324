// One level of the multigrid: a stencil matrix, its smoother, and the way to the next coarser level.
#pragma once

#include "core/math/parallel.hpp"
#include "core/math/stencil_matrix.hpp"
#include "core/solvers/edge_patches.hpp"

namespace pf {

/// Vectors hold D floats a slot (core/math/stencil_layout.hpp).
template <int D>
class MultigridLevel {
 public:
  StencilLayout<D> layout;
  StencilMatrix<D> A;
  Floats inverse;  ///< of the diagonal blocks, as the free directions see them
  Floats b, x;     ///< A x = b
  EdgePatches<D> patches;

  /// Vectors for a new layout.
  void resize();
  /// Inverts the diagonal blocks; directions without stiffness are held still.
  void invert_diagonal(Parallel& parallel);

  /// x: one Gauss-Seidel sweep from 0; rest_ = A x - b. Even chunks before odd ones, rows in order, each row of the
  /// matrix read once.
  void smooth_from_zero(Parallel& parallel);
  /// The adjoint sweep from x.
  void smooth_back(Parallel& parallel);

  /// Multiply-adds of both sweeps: each entry of the lower half serves twice in either.
  std::uint64_t cycle_operations() const {
    return 4 * static_cast<std::uint64_t>(layout.rows()) * static_cast<std::uint64_t>(A.row_size()) +
           patches.sweep_operations();
  }

  /// Lays out `coarse` and how the two levels are connected.
  void connect(MultigridLevel& coarse);
  /// coarse.A = P^T A P.
  void coarsen(MultigridLevel& coarse, Parallel& parallel);
  /// Multiply-adds of that, as if all rows were inner ones.
  std::uint64_t coarsening_operations() const;
  /// coarse.b = P^T (b - A x), after smooth_from_zero().
  void restrict_to(MultigridLevel& coarse, Parallel& parallel) const;
  /// x += P coarse.x.
  void prolong_from(const MultigridLevel& coarse, Parallel& parallel);

 private:
  Floats rest_;                         ///< what the rows of a sweep leave in other rows
  std::vector<std::int32_t> parents_;   ///< a row: slots in the coarse layout, a line of the parents each
  std::vector<std::int32_t> children_;  ///< a coarse row: slots in this layout, a line of the children each
  // Of coarsen() and connect() alone.
  Floats upper_;
  std::vector<LatticeRun> pieces_;
};

extern template class MultigridLevel<2>;
extern template class MultigridLevel<3>;

}  // namespace pf
