// Preconditioned conjugate gradients; the Hessian is only multiplied with, never formed.
#pragma once

#include "core/solvers/preconditioner.hpp"

namespace pf {

template <int D>
class Pcg final : public LinearSolver<D> {
 public:
  Pcg(std::string_view name, std::unique_ptr<Preconditioner<D>> preconditioner, Parallel& parallel)
      : name_(name), preconditioner_(std::move(preconditioner)), parallel_(parallel) {}
  std::string_view name() const override { return name_; }
  LinearResult solve(const LinearProblem<D>& problem, Vector& p) override;
  void new_step() override;

 private:
  /// Makes a new preconditioner, unless the one at hand costs fewer iterations than making one would.
  void prepare(const LinearProblem<D>& problem);
  /// z_ = B^-1 r_.
  void precondition(const LinearProblem<D>& problem);

  std::string_view name_;
  std::unique_ptr<Preconditioner<D>> preconditioner_;
  Parallel& parallel_;
  bool prepared_ = false;
  double fresh_iterations_ = -1;    ///< a decimal digit, of the first solve with this preconditioner
  double wasted_ = 0;               ///< iterations above that, since
  std::vector<Mat<D>> directions_;  ///< that it was made for
  Vector r_, z_, direction_, product_;
};

}  // namespace pf
