// Second-order truncated Taylor numbers in four variables (X, Y, Z, t): exact first and second derivatives.
#pragma once

#include <Eigen/Core>

namespace pf {

/// f and its gradient and Hessian with respect to (X, Y, Z, t).
struct Jet2 {
  static constexpr int variables = 4;
  double value = 0;
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
  Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();

  Jet2() = default;
  Jet2(double v) : value(v) {}  // NOLINT: numbers are constants
  /// The independent variable number `k`, with value v.
  static Jet2 variable(double v, int k) {
    Jet2 jet(v);
    jet.gradient[k] = 1;
    return jet;
  }
};

}  // namespace pf
