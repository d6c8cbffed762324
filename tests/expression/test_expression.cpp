#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/math/expression.hpp"

using namespace pf;

namespace {

double value(const std::string& text, double X = 0, double t = 0, const Constants& constants = {}) {
  const std::array<double, variable_count> v = {X, 0, 0, 0, 0, 0, t};
  return Expression::compile(text, constants, mask_all)(std::span<const double>(v));
}

/// The error's message and position; fails the test when the text is accepted.
ExpressionError refused(const std::string& text, VariableMask allowed = mask_all, const Constants& constants = {}) {
  try {
    (void)Expression::compile(text, constants, allowed);
  } catch (const ExpressionError& error) {
    return error;
  }
  FAIL("accepted: " << text.substr(0, 80));
  return {"", 0};
}

bool says(const ExpressionError& error, const std::string& part) {
  INFO(error.what());
  return std::string(error.what()).find(part) != std::string::npos;
}

std::string repeat(const std::string& part, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += part;
  return all;
}

}  // namespace

TEST_CASE("operators bind as in mathematics") {
  CHECK(value("1 + 2*3") == 7);
  CHECK(value("(1 + 2)*3") == 9);
  CHECK(value("7 - 2 - 1") == 4);
  CHECK(value("8/4/2") == 1);
  CHECK(value("2^3^2") == 512);
  CHECK(value("-2^2") == -4);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("-2^-2") == -0.25);
  CHECK(value("2*-3") == -6);
  CHECK(value("1 - -1") == 2);
  CHECK(value("1 + 2 < 2*2 && 3 > 2") == 1);
  CHECK(value("0 || 1 && 0") == 0);
  CHECK(value("1 == 2 < 3") == 1);
  CHECK(value("!0 + 1") == 2);
  CHECK(value("!(1 != 1)") == 1);
  CHECK(value("0 ? 1 : 0 ? 2 : 3") == 3);
  CHECK(value("1 ? 0 ? 1 : 2 : 3") == 2);
  CHECK(value("1 <= 1 && 1 >= 1") == 1);
}

TEST_CASE("every function and pi give their value") {
  const double a = 0.4;
  CHECK(value("sin(X)", a) == doctest::Approx(std::sin(a)).epsilon(1e-15));
  CHECK(value("cos(X)", a) == doctest::Approx(std::cos(a)).epsilon(1e-15));
  CHECK(value("tan(X)", a) == doctest::Approx(std::tan(a)).epsilon(1e-15));
  CHECK(value("asin(X)", a) == doctest::Approx(std::asin(a)).epsilon(1e-15));
  CHECK(value("acos(X)", a) == doctest::Approx(std::acos(a)).epsilon(1e-15));
  CHECK(value("atan(X)", a) == doctest::Approx(std::atan(a)).epsilon(1e-15));
  CHECK(value("atan2(X, -1)", a) == std::atan2(a, -1.0));
  CHECK(value("sinh(X)", a) == doctest::Approx(std::sinh(a)).epsilon(1e-15));
  CHECK(value("cosh(X)", a) == doctest::Approx(std::cosh(a)).epsilon(1e-15));
  CHECK(value("tanh(X)", a) == doctest::Approx(std::tanh(a)).epsilon(1e-15));
  CHECK(value("exp(X)", a) == doctest::Approx(std::exp(a)).epsilon(1e-15));
  CHECK(value("ln(X)", a) == doctest::Approx(std::log(a)).epsilon(1e-15));
  CHECK(value("log10(X)", a) == doctest::Approx(std::log10(a)).epsilon(1e-15));
  CHECK(value("sqrt(X)", a) == doctest::Approx(std::sqrt(a)).epsilon(1e-15));
  CHECK(value("abs(-X)", a) == a);
  CHECK(value("min(3, X, 2)", a) == a);
  CHECK(value("max(X, -1, 2)", a) == 2);
  CHECK(value("pi") == std::numbers::pi);
}

TEST_CASE("numbers are read as JSON and C write them") {
  CHECK(value("1e-3") == 1e-3);
  CHECK(value("1.5E+2") == 150);
  CHECK(value(".5") == 0.5);
  CHECK(value("2.") == 2);
  CHECK(value("  1\t+\n1 ") == 2);
}

TEST_CASE("constants of the scene are known by name and fold away") {
  const Expression e = Expression::compile("2*A*sin(c*0)+A^2", {{"A", 3}, {"c", 10}}, mask_none);
  CHECK(e.is_constant());
  CHECK(e(std::span<const double>{}) == 9);
  CHECK(Expression::compile("1 ? 2 : X", {}, mask_all).is_constant());
  CHECK(Expression::compile("0 ? X : 2 + 1", {}, mask_all).is_constant());
  CHECK(Expression(2.5)(std::span<const double>{}) == 2.5);
  CHECK(Expression()(std::span<const double>{}) == 0);
}

TEST_CASE("an expression knows what it depends on") {
  const Expression e = Expression::compile("X*t + 0", {}, mask_all);
  CHECK(e.depends_on(var_X));
  CHECK(e.depends_on(var_t));
  CHECK_FALSE(e.depends_on(var_x));
  CHECK_FALSE(e.is_constant());
}

TEST_CASE("NaN is not hidden by min and max") {
  CHECK(std::isnan(value("min(sqrt(X), 1)", -1)));
  CHECK(std::isnan(value("max(1, sqrt(X))", -1)));
  CHECK(std::isnan(value("min(1, sqrt(X))", -1)));
}

TEST_CASE("batches give the same bits as single values") {
  std::vector<double> X, Y, result(1000);
  for (int i = 0; i < 1000; ++i) {
    X.push_back(std::sin(i) * 3);
    Y.push_back(std::cos(3 * i));
  }
  const double t = 0.3;
  const std::string deep = repeat("(X+", 30) + "Y" + repeat(")", 30);
  for (const std::string& text : {std::string("X > Y ? sin(X*t) : X^3 - atan2(Y, X)"), std::string("2*t"),
                                  std::string("7"), std::string("min(X, Y, t)^2.5 || !Y"), deep}) {
    CAPTURE(text);
    const Expression e = Expression::compile(text, {}, mask_all);
    e.evaluate({X, Y, {}, {}, {}, {}, std::span<const double>(&t, 1)}, result);
    for (std::size_t i = 0; i < X.size(); ++i) {
      const std::array<double, variable_count> v = {X[i], Y[i], 0, 0, 0, 0, t};
      const double single = e(std::span<const double>(v));
      CHECK((result[i] == single || (std::isnan(result[i]) && std::isnan(single))));
    }
  }
}

TEST_CASE("errors say where and what would be right") {
  CHECK(refused("1 + snn(X)").position() == 4);
  CHECK(says(refused("1 + snn(X)"), "did you mean 'sin'"));
  CHECK(says(refused("amplitud*2", mask_all, {{"amplitude", 1}}), "did you mean 'amplitude'"));
  CHECK(says(refused("PI"), "did you mean 'pi'"));
  CHECK(says(refused("log(X)"), "ln"));
  CHECK(says(refused("x", mask_reference), "available: X Y Z"));
  CHECK(says(refused("t", mask_none), "available: none"));
  CHECK(says(refused("qwertyuiop"), "unknown name"));
  CHECK(says(refused(""), "empty"));
  CHECK(says(refused("   "), "empty"));
  CHECK(says(refused("2 X"), "a*b"));
  CHECK(says(refused("2(X)"), "a*b"));
  CHECK(says(refused("X(2)"), "not a function"));
  CHECK(says(refused("2**3"), "a^b"));
  CHECK(says(refused("sin X"), "'('"));
  CHECK(says(refused("sin(1, 2)"), "1 argument"));
  CHECK(says(refused("atan2(1)"), "2 arguments"));
  CHECK(says(refused("min(1)"), "at least 2"));
  CHECK(says(refused("0 < X < 1"), "&&"));
  CHECK(says(refused("X = 1"), "=="));
  CHECK(refused("(1 + 2").position() == 6);
  CHECK(refused("1 + ").position() == 4);
  CHECK(refused("1)").position() == 1);
  CHECK(refused("1 ? 2").position() == 5);
  CHECK(says(refused("sin()"), "a value"));
}

TEST_CASE("hostile text is refused and never overflows the stack") {
  CHECK(says(refused(repeat("(", 60000)), "too deep"));
  CHECK(says(refused(repeat("(", 100000)), "longer than"));
  CHECK(says(refused(repeat("-", 60000) + "1"), "too deep"));
  CHECK(says(refused(repeat("1?", 20000)), "too deep"));
  CHECK(says(refused(repeat("X?1:", 10000) + "1"), "too deep"));
  CHECK(says(refused(repeat("2^", 20000) + "1"), "too deep"));
  CHECK(says(refused(repeat("sin(", 10000)), "too deep"));
  CHECK(says(refused(repeat("X||X&&X==X<X+X*X^(", 190)), "too deep"));
  CHECK(says(refused(repeat("X||X&&X==X<X+X*(", 90) + "X" + repeat(")", 90)), "unfinished"));
  CHECK(says(refused("1e999"), "out of range"));
  CHECK(says(refused("1e-999"), "out of range"));
  CHECK(says(refused("\xcf\x80*X"), "'pi'"));
  CHECK(says(refused("X \xe2\x88\x92 1"), "'-'"));
  CHECK(says(refused("\xff\xfe"), "byte 0xff"));
  CHECK(says(refused("\xe2"), "byte 0xe2"));
  CHECK(says(refused(std::string("1\0+1", 4)), "byte 0x00"));
  CHECK(says(refused("X; quit"), "no meaning"));
  CHECK(says(refused(repeat("a", 60000)), "unknown name"));
  CHECK(refused("..").position() == 0);
}

TEST_CASE("long flat expressions are fine") {
  CHECK(value("X" + repeat("+X", 30000), 1) == 30001);
  CHECK(value("min(X" + repeat(",X", 30000) + ")", 4) == 4);
  CHECK(value(repeat("(", 150) + "X" + repeat(")", 150), 5) == 5);
  CHECK(value("X" + repeat("*(1+X", 90) + repeat(")", 90), 0) == 0);
}

TEST_CASE("what is typed twice is evaluated once, and the value stays the same") {
  const std::string R = "sqrt(X^2 + t^2)", h = "(1 - 32*(" + R + " - 1)^2 + 256*(" + R + " - 1)^4)";
  const double X = 0.8, t = 0.5, r = std::sqrt(X * X + t * t), s = r - 1;
  const double expected = 1 - 32 * s * s + 256 * s * s * s * s;
  CHECK(value(h + "*sin(" + h + ")", X, t) == doctest::Approx(expected * std::sin(expected)).epsilon(1e-14));
  // More repeated parts than there is room to keep.
  std::string sum = "0";
  double exact = 0;
  for (int k = 1; k <= 100; ++k) {
    const std::string part = "sin(X*" + std::to_string(k) + ")";
    sum += " + " + part + "*" + part;
    exact += std::sin(X * k) * std::sin(X * k);
  }
  CHECK(value(sum, X) == doctest::Approx(exact).epsilon(1e-13));
  CHECK(value("0*X + 1/(-0*X) < 0 ? 1 : 2", 1) == 1);  // -0 and 0 are not the same constant
}

TEST_CASE("repeating a text within itself costs neither time nor memory") {
  std::string text = "X";
  for (int i = 0; i < 14; ++i) text = "(" + text + "+" + text + ")";  // 2^14 variables
  CHECK(value(text, 1) == 16384);
}
