// Conjugate gradients preconditioned by the inverse D x D diagonal blocks.
#pragma once

#include "core/solvers/linear_solver.hpp"

namespace pf {

template <int D>
class PcgJacobi final : public LinearSolver<D> {
 public:
  explicit PcgJacobi(Parallel& parallel) : parallel_(parallel) {}
  std::string_view name() const override { return "pcg_jacobi"; }
  LinearResult solve(const LinearProblem<D>& problem, Vector& p) override;

 private:
  void invert_blocks(const LinearProblem<D>& problem);
  void precondition(const LinearProblem<D>& problem, const Vector& r, Vector& z);

  Parallel& parallel_;
  std::vector<Mat<D>> inverse_;
  Vector r_, z_, direction_, product_;
};

}  // namespace pf
