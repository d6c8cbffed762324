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

/// f(a), given f, f' and f'' at a.value: the chain rule. A variable that does not enter `a` keeps derivative 0
/// where f' or f'' is infinite (sqrt at 0).
Jet2 chain(const Jet2& a, double f, double f1, double f2);

Jet2 operator+(const Jet2& a, const Jet2& b);
Jet2 operator-(const Jet2& a, const Jet2& b);
Jet2 operator*(const Jet2& a, const Jet2& b);
Jet2 operator/(const Jet2& a, const Jet2& b);
Jet2 operator-(const Jet2& a);

Jet2 sin(const Jet2& a);
Jet2 cos(const Jet2& a);
Jet2 tan(const Jet2& a);
Jet2 asin(const Jet2& a);
Jet2 acos(const Jet2& a);
Jet2 atan(const Jet2& a);
Jet2 atan2(const Jet2& y, const Jet2& x);
Jet2 sinh(const Jet2& a);
Jet2 cosh(const Jet2& a);
Jet2 tanh(const Jet2& a);
Jet2 exp(const Jet2& a);
Jet2 log(const Jet2& a);
Jet2 log10(const Jet2& a);
Jet2 sqrt(const Jet2& a);
/// The derivative at 0 is the one from the right.
Jet2 abs(const Jet2& a);
/// a^b; where b is a constant integer also for a <= 0, with derivatives.
Jet2 pow(const Jet2& a, const Jet2& b);

/// x^n by repeated squaring; 0^0 = 1.
double integer_power(double x, int n);
Jet2 integer_power(const Jet2& a, int n);

/// The smaller and the larger value; of equal ones the first, with its derivatives; NaN if either is.
inline double smaller(double a, double b) {
  return b < a || b != b ? b : a;
}
inline double larger(double a, double b) {
  return b > a || b != b ? b : a;
}
inline const Jet2& smaller(const Jet2& a, const Jet2& b) {
  return b.value < a.value || b.value != b.value ? b : a;
}
inline const Jet2& larger(const Jet2& a, const Jet2& b) {
  return b.value > a.value || b.value != b.value ? b : a;
}

}  // namespace pf
