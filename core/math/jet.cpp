#include "core/math/jet.hpp"

#include <cmath>
#include <limits>

namespace pf {
namespace {

/// 0 * infinity = 0: the factor 0 is a derivative with respect to something that does not enter.
double product(double factor, double derivative) {
  return derivative == 0 ? 0 : factor * derivative;
}

/// f(a, b) from its partial derivatives: the chain rule in two arguments.
Jet2 chain(const Jet2& a, const Jet2& b, double f, double fa, double fb, double faa, double fab, double fbb) {
  Jet2 r(f);
  for (int i = 0; i < Jet2::variables; ++i) {
    const double ai = a.gradient[i], bi = b.gradient[i];
    r.gradient[i] = product(fa, ai) + product(fb, bi);
    for (int j = 0; j < Jet2::variables; ++j) {
      const double aj = a.gradient[j], bj = b.gradient[j];
      r.hessian(i, j) = product(fa, a.hessian(i, j)) + product(fb, b.hessian(i, j)) + product(faa, ai * aj) +
                        product(fab, ai * bj + aj * bi) + product(fbb, bi * bj);
    }
  }
  return r;
}

}  // namespace

Jet2 chain(const Jet2& a, double f, double f1, double f2) {
  Jet2 r(f);
  if (std::isfinite(f1) && std::isfinite(f2)) {
    r.gradient = f1 * a.gradient;
    r.hessian = f1 * a.hessian + f2 * a.gradient * a.gradient.transpose();
    return r;
  }
  for (int i = 0; i < Jet2::variables; ++i) {
    r.gradient[i] = product(f1, a.gradient[i]);
    for (int j = 0; j < Jet2::variables; ++j)
      r.hessian(i, j) = product(f1, a.hessian(i, j)) + product(f2, a.gradient[i] * a.gradient[j]);
  }
  return r;
}

Jet2 operator+(const Jet2& a, const Jet2& b) {
  Jet2 r(a.value + b.value);
  r.gradient = a.gradient + b.gradient;
  r.hessian = a.hessian + b.hessian;
  return r;
}

Jet2 operator-(const Jet2& a, const Jet2& b) {
  Jet2 r(a.value - b.value);
  r.gradient = a.gradient - b.gradient;
  r.hessian = a.hessian - b.hessian;
  return r;
}

Jet2 operator*(const Jet2& a, const Jet2& b) {
  Jet2 r(a.value * b.value);
  r.gradient = a.value * b.gradient + b.value * a.gradient;
  r.hessian = a.value * b.hessian + b.value * a.hessian + a.gradient * b.gradient.transpose() +
              b.gradient * a.gradient.transpose();
  return r;
}

Jet2 operator/(const Jet2& a, const Jet2& b) {
  // q = a/b: a = q b, so q' = (a' - q b')/b and q'' = (a'' - q b'' - q' b'^T - b' q'^T)/b.
  Jet2 q(a.value / b.value);
  const double inverse = 1 / b.value;
  q.gradient = inverse * (a.gradient - q.value * b.gradient);
  q.hessian = inverse * (a.hessian - q.value * b.hessian - q.gradient * b.gradient.transpose() -
                         b.gradient * q.gradient.transpose());
  return q;
}

Jet2 operator-(const Jet2& a) {
  Jet2 r(-a.value);
  r.gradient = -a.gradient;
  r.hessian = -a.hessian;
  return r;
}

Jet2 sin(const Jet2& a) {
  const double s = std::sin(a.value);
  return chain(a, s, std::cos(a.value), -s);
}

Jet2 cos(const Jet2& a) {
  const double c = std::cos(a.value);
  return chain(a, c, -std::sin(a.value), -c);
}

Jet2 tan(const Jet2& a) {
  const double t = std::tan(a.value), f1 = 1 + t * t;
  return chain(a, t, f1, 2 * t * f1);
}

Jet2 asin(const Jet2& a) {
  const double x = a.value, f1 = 1 / std::sqrt(1 - x * x);
  return chain(a, std::asin(x), f1, x * f1 * f1 * f1);
}

Jet2 acos(const Jet2& a) {
  const double x = a.value, f1 = 1 / std::sqrt(1 - x * x);
  return chain(a, std::acos(x), -f1, -x * f1 * f1 * f1);
}

Jet2 atan(const Jet2& a) {
  const double x = a.value, f1 = 1 / (1 + x * x);
  return chain(a, std::atan(x), f1, -2 * x * f1 * f1);
}

Jet2 atan2(const Jet2& y, const Jet2& x) {
  const double r2 = x.value * x.value + y.value * y.value;
  const double fy = x.value / r2, fx = -y.value / r2;
  // d2/dy2 = -2 x y/r^4 = -d2/dx2, d2/dxdy = (y^2 - x^2)/r^4.
  return chain(y, x, std::atan2(y.value, x.value), fy, fx, 2 * fy * fx, fx * fx - fy * fy, -2 * fy * fx);
}

Jet2 sinh(const Jet2& a) {
  const double s = std::sinh(a.value);
  return chain(a, s, std::cosh(a.value), s);
}

Jet2 cosh(const Jet2& a) {
  const double c = std::cosh(a.value);
  return chain(a, c, std::sinh(a.value), c);
}

Jet2 tanh(const Jet2& a) {
  const double t = std::tanh(a.value), f1 = 1 - t * t;
  return chain(a, t, f1, -2 * t * f1);
}

Jet2 exp(const Jet2& a) {
  const double e = std::exp(a.value);
  return chain(a, e, e, e);
}

Jet2 log(const Jet2& a) {
  const double f1 = 1 / a.value;
  return chain(a, std::log(a.value), f1, -f1 * f1);
}

Jet2 log10(const Jet2& a) {
  const double f1 = 1 / (a.value * std::log(10.0));
  return chain(a, std::log10(a.value), f1, -f1 / a.value);
}

Jet2 sqrt(const Jet2& a) {
  const double s = std::sqrt(a.value), f1 = 0.5 / s;
  return chain(a, s, f1, -0.5 * f1 / a.value);
}

Jet2 abs(const Jet2& a) {
  return a.value < 0 ? -a : a;
}

double integer_power(double x, int n) {
  double r = 1;
  double square = x;
  // The exponent's magnitude as unsigned: -INT_MIN does not fit an int.
  for (unsigned k = n < 0 ? 0u - static_cast<unsigned>(n) : static_cast<unsigned>(n); k != 0; k >>= 1) {
    if (k & 1u) r *= square;
    square *= square;
  }
  return n < 0 ? 1 / r : r;
}

Jet2 integer_power(const Jet2& a, int n) {
  const double x = a.value;
  // Not n x^(n-1) where n is 0, nor n (n-1) x^(n-2) where n is 1: at x = 0 they would be 0 * infinity.
  const double f1 = n == 0 ? 0 : n * integer_power(x, n - 1);
  const double f2 = n == 0 || n == 1 ? 0 : static_cast<double>(n) * (n - 1.0) * integer_power(x, n - 2);
  return chain(a, integer_power(x, n), f1, f2);
}

Jet2 pow(const Jet2& a, const Jet2& b) {
  const double x = a.value, y = b.value, f = std::pow(x, y);
  const double fx = y == 0 ? 0 : y * std::pow(x, y - 1);
  const double fxx = y == 0 || y == 1 ? 0 : y * (y - 1) * std::pow(x, y - 2);
  if (b.gradient.isZero(0) && b.hessian.isZero(0)) return chain(a, f, fx, fxx);
  if (x == 0 && y > 0) {  // limits of x^y ln x and x^y ln^2 x
    const double fxy = y > 1 ? 0 : -std::numeric_limits<double>::infinity();
    return chain(a, b, f, fx, 0, fxx, fxy, 0);
  }
  const double ln = std::log(x);
  return chain(a, b, f, fx, f * ln, fxx, std::pow(x, y - 1) * (1 + y * ln), f * ln * ln);
}

}  // namespace pf
