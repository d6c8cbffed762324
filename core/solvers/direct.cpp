#include "core/solvers/direct.hpp"

#include "core/solvers/free_matrix.hpp"

namespace pf {

template <int D>
LinearResult DirectSolver<D>::solve(const LinearProblem<D>& problem, Vector& p) {
  LinearResult result;
  free_matrix(problem, H_, matrix_);
  // Sorting an entry in, and ordering the unknowns once a step, measured in multiply-adds.
  this->work_.operations += (analysed_ ? 40u : 200u) * static_cast<std::uint64_t>(matrix_.nonZeros());
  if (!analysed_) factors_.analyzePattern(matrix_);
  analysed_ = true;
  factors_.factorize(matrix_);
  // A column of n entries below the diagonal costs n^2 in the factorisation and 2 n in the two substitutions.
  const auto& L = factors_.matrixL().nestedExpression();
  for (Eigen::Index column = 0; column < L.outerSize(); ++column) {
    const auto n = static_cast<std::uint64_t>(L.outerIndexPtr()[column + 1] - L.outerIndexPtr()[column]);
    this->work_.operations += n * n + 2 * n;
  }
  result.iterations = 1;
  if (problem.cancel && problem.cancel->load(std::memory_order_relaxed)) {
    result.cancelled = true;
    return result;
  }
  if (factors_.info() != Eigen::Success || !(factors_.vectorD().minCoeff() > 0)) {
    result.negative_curvature = true;
    return result;
  }
  p = factors_.solve(-problem.g);
  problem.set.restrict_to(problem.directions, p);
  return result;
}

template class DirectSolver<2>;
template class DirectSolver<3>;

}  // namespace pf
