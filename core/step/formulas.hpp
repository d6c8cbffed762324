// The scene's formulas, compiled: one expression a component.
#pragma once

#include <array>

#include "core/math/expression.hpp"
#include "core/scene/scene.hpp"

namespace pf {

template <int D>
class FormulaField {
 public:
  FormulaField() = default;
  /// An empty vector is zero.
  FormulaField(const FormulaVector& formulas, const Constants& constants, VariableMask allowed);

  bool zero() const { return zero_; }
  /// At reference point X, current point x [m] and time t [s].
  Vec<D> operator()(const Vec<D>& X, const Vec<D>& x, double t) const;
  /// Integral over [t, t + dt] of formulas in t alone, by Gauss-Legendre quadrature with five points (exact for
  /// polynomials of degree 9).
  Vec<D> integral(double t, double dt) const;

 private:
  std::array<Expression, D> component_;
  bool zero_ = true;
};

extern template class FormulaField<2>;
extern template class FormulaField<3>;

}  // namespace pf
