#include "core/charts/colormap.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using pf::Color;
using pf::ColormapKind;
using pf::sample;

TEST_CASE("the sequential map's lightness rises, evenly") {
  double smallest = 1e9, largest = 0;
  for (int k = 0; k < 32; ++k) {
    const double step = pf::lightness(sample(ColormapKind::sequential, (k + 1) / 32.0)) -
                        pf::lightness(sample(ColormapKind::sequential, k / 32.0));
    smallest = std::min(smallest, step);
    largest = std::max(largest, step);
  }
  CHECK(smallest > 0);
  CHECK(largest < 2 * smallest);
}

TEST_CASE("the diverging map is neutral in the middle and as light on both sides") {
  const Color middle = sample(ColormapKind::diverging, 0.5);
  CHECK(middle.r == doctest::Approx(middle.g).epsilon(0.01));
  CHECK(middle.b == doctest::Approx(middle.g).epsilon(0.01));
  for (const double w : {0.1, 0.25, 0.4, 0.5}) {
    const Color blue = sample(ColormapKind::diverging, 0.5 - w), red = sample(ColormapKind::diverging, 0.5 + w);
    CHECK(std::abs(pf::lightness(blue) - pf::lightness(red)) < 5);
    CHECK(blue.b > blue.r);
    CHECK(red.r > red.b);
  }
}

TEST_CASE("every colour shows on a dark and on a light background") {
  const Color dark{0.09f, 0.09f, 0.1f}, light{1, 1, 1};
  for (const auto kind : {ColormapKind::sequential, ColormapKind::diverging, ColormapKind::categorical}) {
    for (int k = 0; k <= 100; ++k) {
      const Color c = sample(kind, k / 100.0);
      CAPTURE(k);
      CHECK(pf::contrast_ratio(c, dark) > 1.7);
      CHECK(pf::contrast_ratio(c, light) > 1.2);
    }
  }
}

TEST_CASE("texels are the samples; values beyond the range keep its end; NaN is grey") {
  const auto texels = pf::colormap_texels(ColormapKind::sequential);
  for (const std::size_t k : {0u, 17u, 128u, 255u}) {
    const Color c = sample(ColormapKind::sequential, static_cast<double>(k) / 255);
    CHECK(texels[4 * k] == std::lround(255 * c.r));
    CHECK(texels[4 * k + 2] == std::lround(255 * c.b));
    CHECK(texels[4 * k + 3] == 255);
  }
  CHECK(sample(ColormapKind::diverging, -3) == sample(ColormapKind::diverging, 0));
  CHECK(sample(ColormapKind::diverging, std::numeric_limits<double>::infinity()) == sample(ColormapKind::diverging, 1));
  CHECK(sample(ColormapKind::sequential, std::nan("")) == Color{0.5f, 0.5f, 0.5f});
}

TEST_CASE("known contrast and lightness") {
  CHECK(pf::contrast_ratio({0, 0, 0}, {1, 1, 1}) == doctest::Approx(21));
  CHECK(pf::lightness({1, 1, 1}) == doctest::Approx(100));
  CHECK(pf::lightness({0.4663266f, 0.4663266f, 0.4663266f}) == doctest::Approx(50).epsilon(0.001));
}
