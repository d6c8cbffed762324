#include "core/energies/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
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

}  // namespace

template <int D>
double stable_step(ElasticEnergy<D>& elastic, const Vector& mass, const FeasibleSet<D>& set) {
  constexpr int most = 60;
  constexpr double enough = 1e-3;
  const Eigen::Index n = mass.size() * D;
  const double rounding = 1e-14 * mass.maxCoeff();
  Vector scale(n);  // m^-1/2
  for (Eigen::Index i = 0; i < n; ++i) scale[i] = mass[i / D] > rounding ? 1 / std::sqrt(mass[i / D]) : 0;
  const auto free = [&](Vector& v) {
    for (const NodeConstraint<D>& c : set.constrained)
      v.segment<D>(c.node * D) = (c.free * v.segment<D>(c.node * D)).eval();
  };
  elastic.prepare_hessian(Vector::Zero(n), false);
  Vector q(n), before = Vector::Zero(n), p(n), Kp(n);
  for (Eigen::Index i = 0; i < n; ++i) q[i] = scale[i] > 0 ? scattered(i) : 0;
  free(q);
  if (q.norm() == 0) return std::numeric_limits<double>::infinity();
  q.normalize();
  std::vector<double> diagonal, beside;
  double found = 0, off = 0;
  for (int k = 0; k < most; ++k) {
    p = scale.cwiseProduct(q);
    Kp.setZero(n);
    elastic.hessian_product(p, Kp);
    p = scale.cwiseProduct(Kp);
    free(p);
    diagonal.push_back(p.dot(q));
    const double now = largest(diagonal, beside);
    if (k > 4 && now - found < enough * now) {
      found = now;
      break;
    }
    found = now;
    p -= diagonal.back() * q + off * before;
    off = p.norm();
    if (!(off > 1e-12 * found)) break;
    beside.push_back(off);
    before = q;
    q = p / off;
  }
  return found > 0 ? 2 / std::sqrt(found) : std::numeric_limits<double>::infinity();
}

template double stable_step<2>(ElasticEnergy<2>&, const Vector&, const FeasibleSet<2>&);
template double stable_step<3>(ElasticEnergy<3>&, const Vector&, const FeasibleSet<3>&);

}  // namespace pf
