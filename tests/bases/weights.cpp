// Shape functions: THEORY T2 and the first property of T6.
#include <doctest/doctest.h>

#include <cmath>

#include "core/bases/basis.hpp"
#include "tests/numerics.hpp"

using namespace pf;

namespace {

struct Weights {
  long long base = 0;
  double N[max_nodes_per_axis] = {}, dN[max_nodes_per_axis] = {};
  Weights(const BasisInfo& basis, double s) { basis.weights(s, base, N, dN); }
  /// Of the node `index`; 0 outside the support.
  double value(long long index) const {
    return index >= base && index < base + max_nodes_per_axis ? N[index - base] : 0;
  }
  double slope(long long index) const {
    return index >= base && index < base + max_nodes_per_axis ? dN[index - base] : 0;
  }
};

/// Inside cells, on nodes, on midpoints, on both sides of zero, just beside faces, and far away.
std::vector<double> places() {
  std::vector<double> s{0, -0.0, 0.5, -0.5, 1, -1, -1.5, 7, -7, 2.25, -2.25, 1e6 + 0.3, -1e6 - 0.3};
  for (const double face : {-3.0, -0.5, 0.0, 0.5, 4.0}) {
    s.push_back(std::nextafter(face, -1e9));
    s.push_back(std::nextafter(face, 1e9));
  }
  test::Random random(1);
  for (int k = 0; k < 200; ++k) s.push_back(random(-20, 20));
  return s;
}

}  // namespace

TEST_CASE("the weights are the B-splines of the theory") {
  for (const BasisInfo& basis : bases())
    for (const double s : places()) {
      CAPTURE(basis.name);
      CAPTURE(s);
      const Weights w(basis, s);
      for (long long i = w.base - 2; i < w.base + basis.nodes_per_axis + 2; ++i)
        CHECK(std::abs(w.value(i) - test::spline(basis.name, s - static_cast<double>(i))) <
              1e-14 + 4e-16 * std::abs(s));
    }
}

TEST_CASE("shape functions are a partition of unity and reproduce linear fields") {
  for (const BasisInfo& basis : bases())
    for (const double s : places()) {
      CAPTURE(basis.name);
      CAPTURE(s);
      const Weights w(basis, s);
      double sum = 0, slopes = 0, position = 0, stretch = 0;
      for (int r = 0; r < basis.nodes_per_axis; ++r) {
        const double node = static_cast<double>(w.base + r) - s;
        CHECK(w.N[r] >= 0);
        sum += w.N[r];
        slopes += w.dN[r];
        position += w.N[r] * node;
        stretch += w.dN[r] * node;
      }
      CHECK(std::abs(sum - 1) < 1e-15 * 4);
      CHECK(std::abs(slopes) < 1e-15 * 4);
      CHECK(std::abs(position) < 1e-15 * 8 * std::max(1.0, std::abs(s)));
      CHECK(std::abs(stretch - 1) < 1e-15 * 8 * std::max(1.0, std::abs(s)));
    }
}

TEST_CASE("slopes are the derivative of the weights") {
  for (const BasisInfo& basis : bases()) {
    test::Random random(2);
    for (int k = 0; k < 200; ++k) {
      // Away from faces, where the next derivative jumps.
      const double s = std::floor(random(-9, 9)) + (k % 2 == 0 ? 0.05 : 0.55) + 0.4 * random(0, 1);
      CAPTURE(basis.name);
      CAPTURE(s);
      const Weights w(basis, s);
      constexpr double h = 1e-5;
      const Weights above(basis, s + h), below(basis, s - h);
      for (int r = 0; r < basis.nodes_per_axis; ++r) {
        const long long i = w.base + r;
        CHECK(w.dN[r] == doctest::Approx((above.value(i) - below.value(i)) / (2 * h)).epsilon(1e-8).scale(1));
      }
    }
  }
}

TEST_CASE("a spline of degree k has k - 1 continuous derivatives, and no more") {
  constexpr double h = 1e-7;
  for (const BasisInfo& basis : test::sampled_bases()) {
    const int degree = basis.nodes_per_axis - 1;
    // Knots lie at nodes for odd degree, halfway for even; coordinates of both signs.
    for (const double knot : {-2.0 + (degree % 2 == 0 ? 0.5 : 0.0), 3.0 + (degree % 2 == 0 ? 0.5 : 0.0)}) {
      CAPTURE(basis.name);
      CAPTURE(knot);
      const Weights left(basis, knot - h), right(basis, knot + h), lefter(basis, knot - 2 * h),
          righter(basis, knot + 2 * h);
      double value_jump = 0, slope_jump = 0, curvature_jump = 0;
      for (auto i = static_cast<long long>(knot) - 4; i < static_cast<long long>(knot) + 5; ++i) {
        value_jump = std::max(value_jump, std::abs(right.value(i) - left.value(i)));
        slope_jump = std::max(slope_jump, std::abs(right.slope(i) - left.slope(i)));
        const double before = (left.slope(i) - lefter.slope(i)) / h, after = (righter.slope(i) - right.slope(i)) / h;
        curvature_jump = std::max(curvature_jump, std::abs(after - before));
      }
      CHECK(value_jump < 10 * h);
      CHECK((slope_jump < 10 * h) == (degree >= 2));
      if (degree >= 2) CHECK((curvature_jump < 1e-2) == (degree >= 3));
    }
  }
}
