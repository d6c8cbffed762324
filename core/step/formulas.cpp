#include "core/step/formulas.hpp"

namespace pf {

template <int D>
FormulaField<D>::FormulaField(const FormulaVector& formulas, const Constants& constants, VariableMask allowed) {
  for (std::size_t a = 0; a < D && a < formulas.size(); ++a) {
    const Formula& f = formulas[a];
    component_[a] = f.is_number() ? Expression(f.number) : Expression::compile(f.text, constants, allowed);
    if (!f.is_number() || f.number != 0) zero_ = false;
  }
}

template <int D>
Vec<D> FormulaField<D>::operator()(const Vec<D>& X, const Vec<D>& x, double t) const {
  std::array<double, variable_count> v{};
  for (int a = 0; a < D; ++a) {
    v[var_X + static_cast<std::size_t>(a)] = X[a];
    v[var_x + static_cast<std::size_t>(a)] = x[a];
  }
  v[var_t] = t;
  Vec<D> result;
  for (int a = 0; a < D; ++a) result[a] = component_[static_cast<std::size_t>(a)](std::span<const double>(v));
  return result;
}

template <int D>
Vec<D> FormulaField<D>::integral(double t, double dt) const {
  if (zero_) return Vec<D>::Zero();
  constexpr double node[5] = {0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640, -0.9061798459386640};
  constexpr double weight[5] = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
                                0.2369268850561891};
  Vec<D> sum = Vec<D>::Zero();
  const Vec<D> nowhere = Vec<D>::Zero();
  for (int k = 0; k < 5; ++k) sum += 0.5 * dt * weight[k] * (*this)(nowhere, nowhere, t + 0.5 * dt * (1 + node[k]));
  return sum;
}

template class FormulaField<2>;
template class FormulaField<3>;

}  // namespace pf
