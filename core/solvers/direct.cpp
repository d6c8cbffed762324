#include "core/solvers/direct.hpp"

#include "core/solvers/free_matrix.hpp"

namespace pf {

template <int D>
LinearResult DirectSolver<D>::solve(const LinearProblem<D>& problem, Vector& p) {
  LinearResult result;
  free_matrix(problem, H_, matrix_);
  if (!analysed_) factors_.analyzePattern(matrix_);
  analysed_ = true;
  factors_.factorize(matrix_);
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
