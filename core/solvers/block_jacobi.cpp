#include "core/solvers/block_jacobi.hpp"

#include <Eigen/LU>
#include <cmath>

#include "core/math/vector_ops.hpp"

namespace pf {

template <int D>
void whole_diagonal(const LinearProblem<D>& problem, std::vector<Mat<D>>& blocks) {
  blocks.assign(static_cast<std::size_t>(problem.g.size() / D), Mat<D>::Zero());
  problem.objective.diagonal(blocks);
}

template <int D>
void restrict_diagonal(const LinearProblem<D>& problem, std::vector<Mat<D>>& blocks) {
  for (std::size_t i = 0; i < problem.directions.size(); ++i) {
    Mat<D>& B = blocks[static_cast<std::size_t>(problem.set.constrained[i].node)];
    const Mat<D>& Q = problem.directions[i];
    B = (Q * B * Q + (Mat<D>::Identity() - Q) * std::abs(B.trace()) / D).eval();
  }
}

template <int D>
void invert_diagonal(std::vector<Mat<D>>& blocks) {
  for (Mat<D>& B : blocks) {
    const double size = B.trace();
    if (!(size > 0)) {
      B.setZero();
      continue;
    }
    const Mat<D> inverse = B.inverse();
    const bool usable = inverse.allFinite() && inverse.diagonal().minCoeff() > 0;
    B = usable ? Mat<D>(0.5 * (inverse + inverse.transpose())) : Mat<D>(Mat<D>::Identity() * (D / size));
  }
}

template <int D>
void BlockJacobi<D>::prepare(const LinearProblem<D>& problem) {
  if (!problem.same_hessian || whole_.size() * D != static_cast<std::size_t>(problem.g.size()))
    whole_diagonal(problem, whole_);
  inverse_ = whole_;
  restrict_diagonal(problem, inverse_);
  invert_diagonal<D>(inverse_);
  this->work_.operations += 2 * D * D * D * inverse_.size();
}

template <int D>
void BlockJacobi<D>::apply(const LinearProblem<D>& problem, const Vector& r, Vector& z) {
  for_pieces(parallel_, static_cast<std::ptrdiff_t>(inverse_.size()), [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = begin; i < begin + count; ++i)
      z.segment<D>(i * D).noalias() = inverse_[static_cast<std::size_t>(i)] * r.segment<D>(i * D);
  });
  problem.set.restrict_to(problem.directions, z);
  this->work_.operations += D * D * inverse_.size();
}

template void whole_diagonal<2>(const LinearProblem<2>&, std::vector<Mat<2>>&);
template void whole_diagonal<3>(const LinearProblem<3>&, std::vector<Mat<3>>&);
template void restrict_diagonal<2>(const LinearProblem<2>&, std::vector<Mat<2>>&);
template void restrict_diagonal<3>(const LinearProblem<3>&, std::vector<Mat<3>>&);
template void invert_diagonal<2>(std::vector<Mat<2>>&);
template void invert_diagonal<3>(std::vector<Mat<3>>&);
template class BlockJacobi<2>;
template class BlockJacobi<3>;

}  // namespace pf
