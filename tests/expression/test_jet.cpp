#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/math/expression.hpp"

using namespace pf;

namespace {

using Point = std::array<double, Jet2::variables>;

/// X, Y, Z, t as the independent variables; the current position is taken to be the reference one.
std::array<Jet2, variable_count> jets(const Point& p) {
  std::array<Jet2, variable_count> v;
  for (int k = 0; k < 3; ++k) v[k] = v[k + 3] = Jet2::variable(p[k], k);
  v[var_t] = Jet2::variable(p[3], 3);
  return v;
}

std::array<double, variable_count> numbers(const Point& p) {
  return {p[0], p[1], p[2], p[0], p[1], p[2], p[3]};
}

Jet2 jet_at(const std::string& text, const Point& p) {
  return Expression::compile(text, {}, mask_all)(std::span<const Jet2>(jets(p)));
}

}  // namespace

TEST_CASE("derivatives of every function agree with finite differences to second order") {
  const std::vector<std::string> texts = {
      "X*Y - Z/t + X*X*Y",   "sin(X*Y) + cos(t - Z)", "tan(X/3)*Y",       "asin(X*Y/4) + acos(Z/5)", "atan(X*t - Y)",
      "atan2(Y - 2*t, X)",   "sinh(X)*cosh(Y)",       "tanh(X*Z)",        "exp(-X^2 - Y*t)",         "ln(X + Y^2)*t",
      "log10(X*Y + 3)",      "sqrt(X*X + Y*Y + t)",   "abs(X - 2*Y)",     "X^3*Y^-2 + t^5",          "X^2.5 + Y^0.5",
      "X^Y + (1 + t)^(X*Z)", "min(X, Y, Z)*t",        "max(X*X, Y, Z)^2", "X > Y ? X*t : Y*Z",       "-X^2 + !Y*t",
  };
  const Point p = {0.7, 1.3, 0.4, 0.9};
  for (const std::string& text : texts) {
    CAPTURE(text);
    const Expression f = Expression::compile(text, {}, mask_all);
    const Jet2 exact = jet_at(text, p);
    const auto value = [&](const Point& q) { return f(std::span<const double>(numbers(q))); };
    CHECK(exact.value == value(p));
    CHECK((exact.hessian - exact.hessian.transpose()).norm() == doctest::Approx(0));
    const double h = 1e-4;
    for (int i = 0; i < 4; ++i) {
      Point a = p, b = p;
      a[i] += h;
      b[i] -= h;
      CHECK(exact.gradient[i] == doctest::Approx((value(a) - value(b)) / (2 * h)).epsilon(1e-6));
      const Jet2 ja = jet_at(text, a), jb = jet_at(text, b);
      for (int j = 0; j < 4; ++j)
        CHECK(exact.hessian(i, j) ==
              doctest::Approx((ja.gradient[j] - jb.gradient[j]) / (2 * h)).epsilon(1e-6).scale(1));
    }
  }
}

TEST_CASE("second derivatives equal those found by hand") {
  const double X = 0.3, t = 0.7, pi = 3.14159265358979323846;
  const Jet2 u = jet_at("0.05*sin(pi*X)*cos(10*t)", {X, 0, 0, t});
  CHECK(u.hessian(0, 0) == doctest::Approx(-0.05 * pi * pi * std::sin(pi * X) * std::cos(10 * t)));
  CHECK(u.hessian(3, 3) == doctest::Approx(-5 * std::sin(pi * X) * std::cos(10 * t)));
  CHECK(u.hessian(0, 3) == doctest::Approx(-0.5 * pi * std::cos(pi * X) * std::sin(10 * t)));
  CHECK(u.hessian(1, 1) == 0);
}

TEST_CASE("integer powers have exact derivatives at zero and below") {
  const Jet2 cube = jet_at("X^3", {-2, 0, 0, 0});
  CHECK(cube.value == -8);
  CHECK(cube.gradient[0] == 12);
  CHECK(cube.hessian(0, 0) == -12);
  const Jet2 square = jet_at("X^2", {0, 0, 0, 0});
  CHECK(square.value == 0);
  CHECK(square.gradient[0] == 0);
  CHECK(square.hessian(0, 0) == 2);
  const Jet2 one = jet_at("X^1 + Y^0", {0, 0, 0, 0});
  CHECK(one.value == 1);
  CHECK(one.gradient[0] == 1);
  CHECK(one.hessian.norm() == 0);
  const Jet2 large = jet_at("X^100", {-1, 0, 0, 0});  // too large an exponent for repeated squaring
  CHECK(large.gradient[0] == -100);
  CHECK(large.hessian(0, 0) == 9900);
  const Jet2 variable_exponent = jet_at("X^(2 + 0*t)", {-3, 0, 0, 1});  // a constant in value, not in form
  CHECK(variable_exponent.gradient[0] == -6);
}

TEST_CASE("a variable that does not enter keeps derivative zero where the slope is infinite") {
  const Jet2 root = jet_at("sqrt(t) + X", {2, 0, 0, 0});
  CHECK(root.gradient[0] == 1);
  CHECK(root.gradient[1] == 0);
  CHECK(std::isinf(root.gradient[3]));
}

TEST_CASE("kinks take the derivative from one side and never NaN") {
  const Jet2 a = jet_at("abs(X)", {0, 0, 0, 0});
  CHECK(a.gradient[0] == 1);
  const Jet2 m = jet_at("min(X, 2*X)", {0, 0, 0, 0});
  CHECK(m.gradient[0] == 1);
  const Jet2 guarded = jet_at("X > 0 ? sqrt(X) : 0", {-1, 0, 0, 0});
  CHECK(guarded.value == 0);
  CHECK(guarded.gradient.norm() == 0);
}
