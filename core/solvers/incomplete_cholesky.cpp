#include "core/solvers/incomplete_cholesky.hpp"

#include "core/solvers/block_jacobi.hpp"
#include "core/solvers/free_matrix.hpp"

namespace pf {

template <int D>
void IncompleteCholesky<D>::prepare(const LinearProblem<D>& problem) {
  free_matrix(problem, H_, matrix_);
  factors_.compute(matrix_);
  fallback_.clear();
  // Measured in multiply-adds of a factorisation: an entry sorted in costs 40; then each column is subtracted from
  // those that it meets, by indices.
  const auto& L = factors_.matrixL();
  this->work_.operations += 40 * static_cast<std::uint64_t>(L.nonZeros());
  for (Eigen::Index column = 0; column < L.outerSize(); ++column) {
    const auto n = static_cast<std::uint64_t>(L.outerIndexPtr()[column + 1] - L.outerIndexPtr()[column]);
    this->work_.operations += 10 * n * n;
  }
  if (factors_.info() == Eigen::Success) return;
  whole_diagonal(problem, fallback_);
  restrict_diagonal(problem, fallback_);
  invert_diagonal<D>(fallback_);
}

template <int D>
void IncompleteCholesky<D>::apply(const LinearProblem<D>& problem, const Vector& r, Vector& z) {
  if (fallback_.empty()) {
    z = factors_.solve(r);
    this->work_.operations += 4 * static_cast<std::uint64_t>(factors_.matrixL().nonZeros());
  } else {
    z.resize(r.size());
    for (std::size_t i = 0; i < fallback_.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i) * D;
      z.segment<D>(at) = fallback_[i] * r.segment<D>(at);
    }
    this->work_.operations += D * D * fallback_.size();
  }
  problem.set.restrict_to(problem.directions, z);
}

template class IncompleteCholesky<2>;
template class IncompleteCholesky<3>;

}  // namespace pf
