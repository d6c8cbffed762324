#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "render/color_range.hpp"

using namespace pf;

namespace {
std::vector<float> ramp(float from, float to) {
  std::vector<float> v(1000);
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = from + (to - from) * static_cast<float>(k) / 999;
  return v;
}
}  // namespace

TEST_CASE("magnitudes begin at zero and end near the 98th percentile; outliers and NaN do not count") {
  auto values = ramp(0, 1);
  values.push_back(1e9f);
  values.push_back(std::numeric_limits<float>::quiet_NaN());
  const ValueRange r = percentile_range(values, field_info(Field::speed));
  CHECK(r.min == 0);
  CHECK(r.max >= 0.98);
  CHECK(r.max < 1.01);
}

TEST_CASE("diverging fields are symmetric about their centre") {
  const ValueRange J = percentile_range(ramp(0.9f, 1.3f), field_info(Field::J));
  CHECK(J.max - 1 == doctest::Approx(1 - J.min));
  CHECK(J.max >= 1.29);
  const ValueRange p = percentile_range(ramp(-50, 20), field_info(Field::pressure));
  CHECK(p.min == doctest::Approx(-p.max));
}

TEST_CASE("rounding noise is not stretched over the colour map") {
  const ValueRange J = percentile_range(ramp(1 - 1e-7f, 1 + 1e-7f), field_info(Field::J));
  CHECK(J.max - J.min >= 1e-4);
  const ValueRange still = percentile_range(ramp(0, 0), field_info(Field::speed));
  CHECK(still == ValueRange{0, 1});
  CHECK(percentile_range({}, field_info(Field::speed)) == ValueRange{0, 1});
}

TEST_CASE("the range stays while the data fill most of it, and follows when they do not") {
  AutoRange range;
  const FieldInfo& speed = field_info(Field::speed);
  const ValueRange first = range.update(ramp(0, 1), speed);
  CHECK(range.update(ramp(0, 0.8f), speed) == first);
  CHECK(range.update(ramp(0, 0.6f), speed) == first);
  const ValueRange smaller = range.update(ramp(0, 0.3f), speed);
  CHECK(smaller.max < 0.35);
  const ValueRange larger = range.update(ramp(0, 2), speed);
  CHECK(larger.max > 1.95);
  CHECK(range.update(ramp(0, 2.1f), speed) == larger);  // it grew with some room
}

TEST_CASE("a logarithmic range spans the magnitudes that are not zero, six decades of them at most") {
  const FieldInfo& stress = field_info(Field::stress_xx);
  std::vector<float> values;
  for (int k = 0; k <= 1000; ++k)
    values.push_back((k % 2 ? -1.f : 1.f) * std::pow(10.f, 3 * static_cast<float>(k) / 1000));
  values.push_back(0);
  const ValueRange three = percentile_range(values, stress, ColorScale::logarithmic);
  CHECK(three.min == doctest::Approx(1).epsilon(0.25));
  CHECK(three.max == doctest::Approx(1000).epsilon(0.25));
  CHECK(map_position(-std::sqrt(three.min * three.max), three, ColorScale::logarithmic) == doctest::Approx(0.5));
  for (int k = 0; k < 500; ++k) values.push_back(1e-20f);
  const ValueRange cut = percentile_range(values, stress, ColorScale::logarithmic);
  CHECK(cut.max / cut.min == doctest::Approx(1e6));
  CHECK(percentile_range(ramp(0, 0), stress, ColorScale::logarithmic).min > 0);
}

TEST_CASE("a signed field may be spread from its smallest to its largest value, a magnitude be symmetric") {
  const FieldInfo& pressure = field_info(Field::pressure);
  CHECK(color_scale(pressure, false, {}) == ColorScale::symmetric);
  CHECK(color_scale(pressure, false, false) == ColorScale::spread);
  CHECK(color_scale(pressure, true, {}) == ColorScale::logarithmic);
  CHECK(color_scale(field_info(Field::speed), false, {}) == ColorScale::from_zero);
  CHECK(color_scale(field_info(Field::speed), false, true) == ColorScale::symmetric);
  CHECK(color_scale(field_info(Field::material), true, true) == ColorScale::categorical);
  CHECK(map_of(ColorScale::spread) == FieldScale::sequential);
  const ValueRange r = percentile_range(ramp(-50, 20), pressure, ColorScale::spread);
  CHECK(r.min == doctest::Approx(-48.6).epsilon(0.02));
  CHECK(r.max == doctest::Approx(18.6).epsilon(0.05));
}

TEST_CASE("the histogram counts along the colour bar, what lies beyond in its end") {
  const auto counts = histogram(ramp(0, 2), {0, 1}, ColorScale::from_zero, 10);
  REQUIRE(counts.size() == 10);
  CHECK(counts[3] == doctest::Approx(50).epsilon(0.05));
  CHECK(counts[9] == doctest::Approx(550).epsilon(0.05));
  const auto log = histogram(std::vector<float>{-1, 11, 110, 0, 1100}, {1, 1e4}, ColorScale::logarithmic, 4);
  CHECK(log == std::vector<float>{2, 1, 1, 1});  // zero is below every decade
}
