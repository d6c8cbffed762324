// Incomplete Cholesky (Lin and More 1999, Eigen's): factors with as many entries a column as the Hessian has, shifted
// until they exist. For 2D scenes of middling stiffness; in 3D its factors cost more than they save.
#pragma once

#include <Eigen/IterativeLinearSolvers>

#include "core/solvers/preconditioner.hpp"

namespace pf {

template <int D>
class IncompleteCholesky final : public Preconditioner<D> {
 public:
  void prepare(const LinearProblem<D>& problem) override;
  int cost() const override { return D == 2 ? 20 : 100; }
  void apply(const LinearProblem<D>& problem, const Vector& r, Vector& z) override;

 private:
  BlockMatrix<D> H_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> factors_;
  std::vector<Mat<D>> fallback_;  ///< inverse diagonal blocks, where no factors could be found
};

}  // namespace pf
