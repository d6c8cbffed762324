#include "core/solvers/pcg_jacobi.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/math/vector_ops.hpp"

namespace pf {

template <int D>
void PcgJacobi<D>::invert_blocks(const LinearProblem<D>& problem) {
  inverse_.assign(static_cast<std::size_t>(problem.g.size() / D), Mat<D>::Zero());
  problem.objective.diagonal(inverse_);
  // On a constrained node invert what the free directions see of the block: Q B Q + (I - Q) t, t the block's own size.
  for (std::size_t i = 0; i < problem.directions.size(); ++i) {
    Mat<D>& B = inverse_[static_cast<std::size_t>(problem.set.constrained[i].node)];
    const Mat<D>& Q = problem.directions[i];
    B = (Q * B * Q + (Mat<D>::Identity() - Q) * std::abs(B.trace()) / D).eval();
  }
  for (Mat<D>& B : inverse_) {
    // A node that no particle weighs or stiffens (one exactly at the edge of its support) has nothing to solve for.
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
void PcgJacobi<D>::precondition(const LinearProblem<D>& problem, const Vector& r, Vector& z) {
  for_pieces(parallel_, static_cast<std::ptrdiff_t>(inverse_.size()), [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = begin; i < begin + count; ++i)
      z.segment<D>(i * D).noalias() = inverse_[static_cast<std::size_t>(i)] * r.segment<D>(i * D);
  });
  problem.set.restrict_to(problem.directions, z);
}

template <int D>
LinearResult PcgJacobi<D>::solve(const LinearProblem<D>& problem, Vector& p) {
  LinearResult result;
  const Eigen::Index n = problem.g.size();
  invert_blocks(problem);
  p = Vector::Zero(n);
  z_.resize(n);
  product_.resize(n);
  r_ = -problem.g;
  precondition(problem, r_, z_);
  direction_ = z_;
  double rz = dot(parallel_, r_, z_);
  const double target = problem.tolerance * std::sqrt(rz);
  const int most = static_cast<int>(std::clamp<Eigen::Index>(4 * n, 100, 20000));
  while (std::sqrt(rz) > target && result.iterations < most) {
    if (problem.cancel && problem.cancel->load(std::memory_order_relaxed)) {
      result.cancelled = true;
      return result;
    }
    product_.setZero();
    problem.objective.hessian_product(direction_, product_);
    problem.set.restrict_to(problem.directions, product_);
    ++result.iterations;
    const double curvature = dot(parallel_, direction_, product_);
    if (!(curvature > 0)) {
      result.negative_curvature = true;
      return result;
    }
    const double alpha = rz / curvature;
    for_pieces(parallel_, n, [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
      p.segment(begin, count) += alpha * direction_.segment(begin, count);
      r_.segment(begin, count) -= alpha * product_.segment(begin, count);
    });
    precondition(problem, r_, z_);
    const double next = dot(parallel_, r_, z_);
    const double beta = next / rz;
    for_pieces(parallel_, n, [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
      direction_.segment(begin, count) = z_.segment(begin, count) + beta * direction_.segment(begin, count);
    });
    rz = next;
  }
  return result;
}

template class PcgJacobi<2>;
template class PcgJacobi<3>;

}  // namespace pf
