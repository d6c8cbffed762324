#include "core/integrators/step_error.hpp"

#include <cmath>

namespace pf {

namespace {

template <int D>
class Filter {
 public:
  Filter(Objective<D>& objective, const StepProblem<D>& problem)
      : objective_(objective), problem_(problem), m_(problem.mass.lumped()), least_(1e-9 * m_.maxCoeff()) {}

  /// Zero in directions that are held, on nodes that may touch a wall and on those that weigh next to nothing.
  void restrict_to_free(Vector& x) const {
    for (const NodeConstraint<D>& c : problem_.set.constrained) {
      auto at = x.segment<D>(c.node * D);
      at = c.faces > 0 ? Vec<D>::Zero() : Vec<D>(c.free * at);
    }
    for (Eigen::Index i = 0; i < m_.size(); ++i)
      if (!(m_[i] > least_)) x.segment<D>(i * D).setZero();
  }
  /// sum m x^2.
  double squares(const Vector& x) const {
    double sum = 0;
    for (Eigen::Index i = 0; i < m_.size(); ++i) sum += m_[i] * x.segment<D>(i * D).squaredNorm();
    return sum;
  }
  /// e becomes e'.
  void apply(Vector& e) const {
    constexpr int most = 3;
    constexpr double enough = 0.1;
    const double per_dt2 = 1 / (problem_.dt * problem_.dt);
    Vector r, x = Vector::Zero(e.size()), p, Hp;
    problem_.mass.multiply(e, r);
    r *= per_dt2;
    restrict_to_free(r);
    Vector z = over_mass(r);
    const double first = r.dot(z);
    double rz = first;
    p = z;
    for (int k = 0; k < most && rz > enough * enough * first; ++k) {
      Hp.setZero(p.size());
      objective_.hessian_product(p, Hp);
      restrict_to_free(Hp);
      const double curvature = p.dot(Hp);
      if (!(curvature > 0)) break;
      x += rz / curvature * p;
      r -= rz / curvature * Hp;
      z = over_mass(r);
      const double next = r.dot(z);
      p = z + next / rz * p;
      rz = next;
    }
    if (x.squaredNorm() > 0) e = x;
  }

 private:
  Vector over_mass(const Vector& r) const {
    Vector z = Vector::Zero(r.size());
    for (Eigen::Index i = 0; i < m_.size(); ++i)
      if (m_[i] > least_) z.segment<D>(i * D) = r.segment<D>(i * D) / m_[i];
    return z;
  }

  Objective<D>& objective_;
  const StepProblem<D>& problem_;
  const Vector& m_;
  double least_;
};

}  // namespace

template <int D>
double step_error_rate(Objective<D>& objective, const StepProblem<D>& problem, bool has_hessian) {
  const Filter<D> filter(objective, problem);
  Vector e = 0.5 * (problem.grid.u - problem.dt * problem.grid.v);
  filter.restrict_to_free(e);
  const double mass = problem.mass.lumped().sum();
  if (!(mass > 0) || !e.allFinite() || e.isZero()) return 0;
  const double whole = filter.squares(e);
  if (has_hessian) filter.apply(e);
  return std::sqrt(std::sqrt(whole * filter.squares(e)) / mass) / problem.dt;
}

template double step_error_rate<2>(Objective<2>&, const StepProblem<2>&, bool);
template double step_error_rate<3>(Objective<3>&, const StepProblem<3>&, bool);

}  // namespace pf
