#include "core/solvers/pcg.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/vector_ops.hpp"

namespace pf {

template <int D>
LinearResult Pcg<D>::solve(const LinearProblem<D>& problem, Vector& p) {
  LinearResult result;
  const Eigen::Index n = problem.g.size();
  preconditioner_->prepare(problem);
  p = Vector::Zero(n);
  z_.resize(n);
  product_.resize(n);
  r_ = -problem.g;
  preconditioner_->apply(problem, r_, z_);
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
    preconditioner_->apply(problem, r_, z_);
    const double next = dot(parallel_, r_, z_);
    const double beta = next / rz;
    for_pieces(parallel_, n, [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
      direction_.segment(begin, count) = z_.segment(begin, count) + beta * direction_.segment(begin, count);
    });
    rz = next;
  }
  return result;
}

template class Pcg<2>;
template class Pcg<3>;

}  // namespace pf
