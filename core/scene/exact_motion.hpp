// A motion x = phi(X, t) typed by the user ("exact"), with all its derivatives to second order, exactly.
#pragma once

#include <array>

#include "core/math/expression.hpp"
#include "core/scene/scene.hpp"

namespace pf {

/// The motion at one place and time.
template <int D>
struct MotionPoint {
  Vec<D> position;                 ///< phi [m]
  Vec<D> velocity;                 ///< d phi/dt [m/s]
  Vec<D> acceleration;             ///< d2 phi/dt2 [m/s^2]
  Mat<D> F;                        ///< F_aA = d phi_a/dX_A
  std::array<Mat<D>, D> gradient;  ///< gradient[b](A, B) = d2 phi_b/dX_A dX_B [1/m]
};

/// Evaluation allocates nothing and is thread-safe. Where an expression has no value the result is NaN.
template <int D>
class ExactMotion {
 public:
  /// Of scene.exact_position, which has D components, with scene.constants. Throws InputError naming the component
  /// that is no expression in X, Y, Z, t.
  explicit ExactMotion(const Scene& scene);

  MotionPoint<D> at(const Vec<D>& X, double t) const;
  /// Alone these are cheaper than at(): position needs no derivative.
  Vec<D> position(const Vec<D>& X, double t) const;
  Vec<D> velocity(const Vec<D>& X, double t) const { return at(X, t).velocity; }
  Vec<D> acceleration(const Vec<D>& X, double t) const { return at(X, t).acceleration; }
  Mat<D> F(const Vec<D>& X, double t) const { return at(X, t).F; }

 private:
  std::array<Expression, D> position_;
};

extern template class ExactMotion<2>;
extern template class ExactMotion<3>;

}  // namespace pf
