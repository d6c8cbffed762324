#include "core/solvers/pcg.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/vector_ops.hpp"

namespace pf {

namespace {

/// After so many iterations the preconditioner shall do what it can.
constexpr int patience = 8;

}  // namespace

template <int D>
void Pcg<D>::new_step() {
  prepared_ = false;
  preconditioner_->new_step();
}

template <int D>
void Pcg<D>::prepare(const LinearProblem<D>& problem) {
  if (prepared_ && directions_ == problem.directions && wasted_ < preconditioner_->cost()) return;
  preconditioner_->prepare(problem);
  prepared_ = true;
  directions_ = problem.directions;
  fresh_iterations_ = -1;
  wasted_ = 0;
}

template <int D>
void Pcg<D>::precondition(const LinearProblem<D>& problem) {
  preconditioner_->apply(problem, r_, z_);
  this->work_ += preconditioner_->take_work();
}

template <int D>
LinearResult Pcg<D>::solve(const LinearProblem<D>& problem, Vector& p) {
  LinearResult result;
  const Eigen::Index n = problem.g.size();
  prepare(problem);
  p = Vector::Zero(n);
  z_.resize(n);
  product_.resize(n);
  r_ = -problem.g;
  precondition(problem);
  direction_ = z_;
  double rz = dot(parallel_, r_, z_);
  // What an approximate factorisation or a cycle makes of an indefinite Hessian need not be positive itself.
  const auto indefinite = [&] {
    result.negative_curvature = true;
    prepared_ = false;  // no good for the projected Hessian either
    return result;
  };
  if (!(rz >= 0)) return indefinite();
  double target = problem.tolerance * std::sqrt(rz);
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
    this->work_.operations += 6 * static_cast<std::uint64_t>(n);
    const double curvature = dot(parallel_, direction_, product_);
    if (!(curvature > 0)) return indefinite();
    const double alpha = rz / curvature;
    for_pieces(parallel_, n, [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
      p.segment(begin, count) += alpha * direction_.segment(begin, count);
      r_.segment(begin, count) -= alpha * product_.segment(begin, count);
    });
    precondition(problem);
    double next = dot(parallel_, r_, z_);
    if (!(next >= 0)) return indefinite();
    const double beta = next / rz;
    for_pieces(parallel_, n, [&](std::ptrdiff_t begin, std::ptrdiff_t count) {
      direction_.segment(begin, count) = z_.segment(begin, count) + beta * direction_.segment(begin, count);
    });
    rz = next;
    if (result.iterations == patience && std::sqrt(rz) > target && preconditioner_->strengthen()) {
      // From here as from the start, but towards what the other norm makes of the same target.
      precondition(problem);
      direction_ = z_;
      next = dot(parallel_, r_, z_);
      if (!(next >= 0)) return indefinite();
      target *= std::sqrt(next / rz);
      rz = next;
    }
  }
  // Compared by digits won: later solves of a step are asked for more or fewer of them.
  const double digits = std::max(0.1, -std::log10(std::max(problem.tolerance, 1e-15)));
  const double each = result.iterations / digits;
  if (fresh_iterations_ < 0) fresh_iterations_ = each;
  wasted_ = std::max(0.0, wasted_ + (each - fresh_iterations_) * digits);
  return result;
}

template class Pcg<2>;
template class Pcg<3>;

}  // namespace pf
