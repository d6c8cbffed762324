#include "core/math/logarithm.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

using namespace pf;

TEST_CASE("the logarithm agrees with the library's to 2 units in the last place over the whole range") {
  double x = 1e-305;
  for (int n = 0; n < 200000 && x < 1e305; ++n, x *= 1.00731) {
    const double expected = std::log(x);
    CHECK(std::abs(log_of(x) - expected) <= 4.5e-16 * std::abs(expected));
  }
  for (double h = 1e-17; h < 0.4; h *= 1.7) {
    for (const double near : {1 + h, 1 - h}) {
      const double expected = std::log(near);
      CHECK(std::abs(log_of(near) - expected) <= 4.5e-16 * std::abs(expected));
    }
  }
}

TEST_CASE("every lane of a pack gets the same logarithm as a single number") {
  const Pack x = {1e-300, 0.3, 0.70710678118654757, 1.0, 1.41421356, 2.0, 12345.678, 1e300};
  const Pack y = log_of(x);
  for (int lane = 0; lane < 8; ++lane) CHECK(std::abs(y[lane] - log_of(x[lane])) <= 3e-16 * std::abs(y[lane]));
}

TEST_CASE("f - ln(1 + f) keeps its digits however small f is") {
  for (double f = 1e-150; f < 0.4; f *= 1.9) {
    for (const double signed_f : {f, -0.7 * f}) {
      long double expected = 0;
      if (f < 1e-3) {  // the series, where the difference would cancel
        for (int k = 12; k >= 2; --k) {
          const long double power = std::pow(static_cast<long double>(signed_f), k);
          expected += (k % 2 == 0 ? 1 : -1) * power / k;
        }
      } else {
        expected = signed_f - std::log1p(static_cast<long double>(signed_f));
      }
      const double value = log_excess(signed_f);
      CAPTURE(signed_f);
      CHECK(std::abs(value / static_cast<double>(expected) - 1) < 2e-15);
    }
  }
}

TEST_CASE("NaN passes through the logarithm") {
  CHECK(std::isnan(log_of(std::numeric_limits<double>::quiet_NaN())));
}

TEST_CASE("atanh(z)/z is smooth through zero") {
  CHECK(atanh_over(0.0) == 1.0);
  for (double z = 1e-12; z < 0.999; z *= 1.05) {
    const double expected = std::atanh(z) / z;
    CHECK(std::abs(atanh_over(z) - expected) <= 4e-15 * expected);
    CHECK(std::abs(atanh_over(-z) - expected) <= 4e-15 * expected);
  }
}
