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
  void new_step() override { preconditioner_->new_step(); }

 private:
  std::string_view name_;
  std::unique_ptr<Preconditioner<D>> preconditioner_;
  Parallel& parallel_;
  Vector r_, z_, direction_, product_;
};

}  // namespace pf
