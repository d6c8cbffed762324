#include "core/energies/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pf {

namespace {

/// Numbers that no smooth mode resembles, the same in every run.
double scattered(Eigen::Index i) {
  const auto bits = static_cast<std::uint32_t>(i + 1) * 2654435761u;
  return static_cast<double>(bits >> 8) / (1 << 24) - 0.5;
}

/// The largest eigenvalue of the tridiagonal matrix of Lanczos' method.
double largest(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  const auto n = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::Map<const Vector>(diagonal.data(), n),
                                Eigen::Map<const Vector>(beside.data(), n - 1), Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[n - 1];
}

/// Of the Chebyshev series of f on [0, 1], as many terms as leave 5e-3 of it.
std::vector<double> chebyshev(const std::function<double(double)>& f) {
  constexpr int n = 32;
  std::vector<double> terms(n);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j) {
      const double angle = M_PI * (j + 0.5) / n;
      terms[static_cast<std::size_t>(k)] +=
          (k == 0 ? 1.0 : 2.0) / n * f((1 + std::cos(angle)) / 2) * std::cos(k * angle);
    }
  double left = 0;
  while (terms.size() > 1 && left + std::abs(terms.back()) < 5e-3) {
    left += std::abs(terms.back());
    terms.pop_back();
  }
  return terms;
}

/// r(S) m^-1 of the free nodes: symmetric and positive.
template <int D>
class Softness {
 public:
  Softness(const Vector& mass, const FeasibleSet<D>& set, const BetweenSteps& between) : set_(set), between_(between) {
    const double rounding = 1e-14 * mass.maxCoeff();
    inverse_.resize(mass.size() * D);
    for (Eigen::Index i = 0; i < inverse_.size(); ++i) inverse_[i] = mass[i / D] > rounding ? 1 / mass[i / D] : 0;
    if (between.carry) terms_ = chebyshev(between.stiffening);
  }

  void apply(const Vector& force, Vector& out) {
    last_ = inverse_.cwiseProduct(force);
    free(last_);
    out = terms_[0] * last_;
    if (terms_.size() < 2) return;
    averaged(last_, term_);
    out += terms_[1] * term_;
    for (std::size_t k = 2; k < terms_.size(); ++k) {
      averaged(term_, next_);
      next_ = 2 * next_ - last_;
      out += terms_[k] * next_;
      last_.swap(term_);
      term_.swap(next_);
    }
  }

 private:
  void free(Vector& v) const {
    for (const NodeConstraint<D>& c : set_.constrained)
      v.segment<D>(c.node * D) = (c.free * v.segment<D>(c.node * D)).eval();
  }
  /// to = (2 S - 1) from, whose spectrum lies in [-1, 1].
  void averaged(const Vector& from, Vector& to) {
    between_.carry(from, to);
    to = inverse_.cwiseProduct(to);
    free(to);
    to = 2 * to - from;
  }

  const FeasibleSet<D>& set_;
  const BetweenSteps& between_;
  Vector inverse_, last_, term_, next_;
  std::vector<double> terms_{1};
};

}  // namespace

template <int D>
double stable_step(ElasticEnergy<D>& elastic, const Vector& mass, const FeasibleSet<D>& set,
                   const BetweenSteps& between) {
  constexpr int most = 60;
  constexpr double enough = 3e-3;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Eigen::Index n = mass.size() * D;
  Softness<D> softness(mass, set, between);
  elastic.prepare_hessian(Vector::Zero(n), false);
  // Forces f and the displacements q = r(S) m^-1 f that go with them; f.q is the square of either's length.
  Vector f(n), before = Vector::Zero(n), q(n), next(n);
  for (Eigen::Index i = 0; i < n; ++i) f[i] = mass[i / D] * scattered(i);
  softness.apply(f, q);
  double length = std::sqrt(f.dot(q));
  if (!(length > 0)) return infinity;
  std::vector<double> diagonal, beside;
  double found = 0;
  for (int k = 0; k < most; ++k) {
    f /= length;
    q /= length;
    next.setZero(n);
    elastic.hessian_product(q, next);
    diagonal.push_back(next.dot(q));
    const double now = largest(diagonal, beside);
    const bool settled = k > 4 && now - found < enough * now;
    found = now;
    if (settled) break;
    next -= diagonal.back() * f + (beside.empty() ? 0 : beside.back()) * before;
    before.swap(f);
    f.swap(next);
    softness.apply(f, q);
    const double square = f.dot(q);
    length = square > 0 ? std::sqrt(square) : 0;
    if (!(length > 1e-12 * found)) break;
    beside.push_back(length);
  }
  return found > 0 ? 2 / std::sqrt(found) : infinity;
}

template double stable_step<2>(ElasticEnergy<2>&, const Vector&, const FeasibleSet<2>&, const BetweenSteps&);
template double stable_step<3>(ElasticEnergy<3>&, const Vector&, const FeasibleSet<3>&, const BetweenSteps&);

}  // namespace pf
