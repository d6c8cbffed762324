// The inverse D x D diagonal blocks: cheap, and enough for soft scenes.
#pragma once

#include "core/solvers/preconditioner.hpp"

namespace pf {

/// Inverts symmetric blocks in place. A block that is not positive definite is replaced by its mean size, one without
/// size (a node that no particle weighs or stiffens) by zero: nothing is solved for there.
template <int D>
void invert_diagonal(std::vector<Mat<D>>& blocks);

/// The diagonal blocks of H.
template <int D>
void whole_diagonal(const LinearProblem<D>& problem, std::vector<Mat<D>>& blocks);
/// They as the free directions see them: Q B Q + (I - Q) t on constrained nodes, t the block's own size.
template <int D>
void restrict_diagonal(const LinearProblem<D>& problem, std::vector<Mat<D>>& blocks);

template <int D>
class BlockJacobi final : public Preconditioner<D> {
 public:
  explicit BlockJacobi(Parallel& parallel) : parallel_(parallel) {}
  void prepare(const LinearProblem<D>& problem) override;
  int cost() const override { return 0; }  // two iterations, and contact wants the newest
  void apply(const LinearProblem<D>& problem, const Vector& r, Vector& z) override;

 private:
  Parallel& parallel_;
  std::vector<Mat<D>> whole_, inverse_;
};

}  // namespace pf
