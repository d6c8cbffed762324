// Sparse Cholesky (LDL^T, Eigen) of the assembled Hessian: exact, and unmoved by stiffness; its cost grows faster than
// the grid's (small 2D scenes).
#pragma once

#include <Eigen/SparseCholesky>

#include "core/solvers/linear_solver.hpp"

namespace pf {

template <int D>
class DirectSolver final : public LinearSolver<D> {
 public:
  std::string_view name() const override { return "direct"; }
  LinearResult solve(const LinearProblem<D>& problem, Vector& p) override;
  void new_step() override { analysed_ = false; }

 private:
  BlockMatrix<D> H_;
  Eigen::SparseMatrix<double> matrix_;  ///< lower triangle
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors_;
  bool analysed_ = false;
};

}  // namespace pf
