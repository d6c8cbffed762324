// Galerkin multigrid on the grid's own coarsenings: every level is spanned by the splines of a grid of twice the
// spacing (core/solvers/two_scale.hpp), A_coarse = P^T A P, one symmetric Gauss-Seidel sweep a level (core/solvers/
// multigrid_level.hpp), the coarsest level solved directly. A V-cycle with these sweeps is symmetric and positive
// definite as long as the diagonal blocks are, whatever H is. Single precision: conjugate gradients do not need more.
#pragma once

#include <Eigen/Cholesky>

#include "core/solvers/multigrid_level.hpp"
#include "core/solvers/preconditioner.hpp"

namespace pf {

/// Rows of nodes that are not free, and what of their directions is.
template <int D>
struct HeldRows {
  std::vector<std::int32_t> at;  ///< into Q, a row; -1 where it is free
  std::vector<Eigen::Matrix<float, D, D>> Q;
};

template <int D>
class Multigrid final : public Preconditioner<D> {
 public:
  explicit Multigrid(Parallel& parallel) : parallel_(parallel) {}
  void prepare(const LinearProblem<D>& problem) override;
  int cost() const override { return 12; }
  void apply(const LinearProblem<D>& problem, const Vector& r, Vector& z) override;
  /// With patches of light nodes (core/solvers/edge_patches.hpp).
  bool strengthen() override;
  void new_step() override { laid_out_ = strong_ = false; }

 private:
  void lay_out(const LinearProblem<D>& problem);
  void constrain(const LinearProblem<D>& problem);
  void build_patches();
  void factorize();
  void cycle(std::size_t level);
  void solve_coarsest();

  Parallel& parallel_;
  bool laid_out_ = false, factorized_ = false, strong_ = false;
  std::size_t count_ = 0;                                   ///< levels in use
  std::vector<std::unique_ptr<MultigridLevel<D>>> levels_;  ///< [0] the finest
  std::vector<std::int32_t> row_of_;                        ///< a node
  HeldRows<D> held_;
  Eigen::MatrixXd dense_;  ///< the coarsest level's
  Eigen::LLT<Eigen::MatrixXd> coarsest_;
  Vector solution_;
};

}  // namespace pf
