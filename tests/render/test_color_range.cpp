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
