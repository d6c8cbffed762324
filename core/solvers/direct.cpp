#include "core/solvers/direct.hpp"

namespace pf {

template <int D>
void DirectSolver<D>::fill(const LinearProblem<D>& problem) {
  problem.objective.assemble(H_);
  const int rows = H_.rows();
  // Constrained nodes keep their free directions only: Q_i H_ij Q_j, and the identity elsewhere.
  std::vector<const Mat<D>*> Q(static_cast<std::size_t>(rows), nullptr);
  for (std::size_t i = 0; i < problem.directions.size(); ++i)
    Q[static_cast<std::size_t>(problem.set.constrained[i].node)] = &problem.directions[i];
  double size = 0;
  for (int i = 0; i < rows; ++i) size = std::max(size, H_.at(i, i).trace());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(H_.block.size() * D * D);
  for (int row = 0; row < rows; ++row)
    for (auto k = H_.row_start[static_cast<std::size_t>(row)]; k < H_.row_start[static_cast<std::size_t>(row) + 1];
         ++k) {
      const int column = H_.column[static_cast<std::size_t>(k)];
      Mat<D> B = H_.block[static_cast<std::size_t>(k)];
      if (const Mat<D>* q = Q[static_cast<std::size_t>(row)]) B = (*q * B).eval();
      if (const Mat<D>* q = Q[static_cast<std::size_t>(column)]) B = (B * *q).eval();
      if (row == column) {
        // What no particle weighs or stiffens is held still.
        if (const Mat<D>* q = Q[static_cast<std::size_t>(row)]) B += (Mat<D>::Identity() - *q) * size;
        for (int a = 0; a < D; ++a)
          if (!(B(a, a) > 1e-14 * size)) B(a, a) += 1e-14 * size;
      }
      for (int c = 0; c < D; ++c)
        for (int a = row == column ? c : 0; a < D; ++a) entries.emplace_back(row * D + a, column * D + c, B(a, c));
    }
  matrix_.resize(rows * D, rows * D);
  matrix_.setFromTriplets(entries.begin(), entries.end());
}

template <int D>
LinearResult DirectSolver<D>::solve(const LinearProblem<D>& problem, Vector& p) {
  LinearResult result;
  fill(problem);
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
