#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "core/scene/shapes/shape_types.hpp"
#include "shapes_for_tests.hpp"

using namespace pf;
using namespace pf::test;

namespace {

std::unique_ptr<Solid> solid(const Shape& shape, int dimension) {
  return make_solid(shape, dimension, {});
}

/// Points in and around the solid, the same every time.
std::vector<Vec3> probes(const Solid& s, int dimension, int n) {
  std::mt19937_64 random(7);
  const Bounds b = s.bounds();
  const Vec3 margin = 0.3 * (b.max - b.min);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    Vec3 p = Vec3::Zero();
    for (int a = 0; a < dimension; ++a)
      p[a] =
          b.min[a] - margin[a] + (b.max[a] - b.min[a] + 2 * margin[a]) * static_cast<double>(random() >> 11) * 0x1p-53;
    points.push_back(p);
  }
  return points;
}

}  // namespace

TEST_CASE("the measure of every shape is its area or volume") {
  for (const Case& c : cases()) {
    CAPTURE(c.name);
    CAPTURE(c.dimension);
    CHECK(solid(c.shape, c.dimension)->measure(0.1) == doctest::Approx(c.measure).epsilon(c.tolerance));
  }
}

TEST_CASE("surface points carry the whole surface, face outward and enclose the volume") {
  for (const Case& c : cases()) {
    CAPTURE(c.name);
    CAPTURE(c.dimension);
    const auto s = solid(c.shape, c.dimension);
    double area = 0, volume = 0;
    Vec3 closed = Vec3::Zero();
    for (const SurfacePoint& q : s->surface(0.02)) {
      area += q.area;
      closed += q.area * q.normal;
      volume += q.area * q.normal.dot(q.position) / c.dimension;
      CHECK(q.normal.norm() == doctest::Approx(1));
      CHECK(std::abs(s->distance(q.position)) < 2e-3);
      CHECK(s->distance(q.position + 0.005 * q.normal) > 0);
      CHECK(s->distance(q.position - 0.005 * q.normal) < 0);
    }
    CHECK(area == doctest::Approx(c.surface).epsilon(c.surface_tolerance));
    CHECK(closed.norm() < 1.5 * std::max(1e-9, c.surface_tolerance) * area);
    CHECK(volume == doctest::Approx(c.measure).epsilon(2e-2));
  }
}

TEST_CASE("surface points are spaced by at most h") {
  for (const Case& c : cases()) {
    if (c.tolerance > 1e-12) continue;  // primitives
    CAPTURE(c.name);
    const double h = 0.1;
    const auto points = solid(c.shape, c.dimension)->surface(h);
    for (const SurfacePoint& q : points) {
      CHECK(q.area <= std::pow(h, c.dimension - 1) * (1 + 1e-9));
      double nearest = std::numeric_limits<double>::infinity();
      for (const SurfacePoint& other : points)
        if (&other != &q) nearest = std::min(nearest, (other.position - q.position).norm());
      CHECK(nearest <= h * (1 + 1e-9));
    }
  }
}

TEST_CASE("distance is negative exactly where a shape contains, and its gradient is the normal") {
  for (const Case& c : cases()) {
    if (c.name == "disc by comparison") continue;  // no slope
    CAPTURE(c.name);
    CAPTURE(c.dimension);
    const auto s = solid(c.shape, c.dimension);
    int away_from_kinks = 0;
    const auto points = probes(*s, c.dimension, 400);
    for (const Vec3& p : points) {
      const double d = s->distance(p);
      if (std::abs(d) > 1e-9) CHECK(s->contains(p, 0) == (d < 0));
      CHECK(s->contains(p, std::abs(d) * 1.0001 + 1e-12));
      const Vec3 n = s->normal(p);
      CHECK(n.norm() == doctest::Approx(1));
      Vec3 slope = Vec3::Zero();
      for (int a = 0; a < c.dimension; ++a) {
        const Vec3 step = 1e-6 * Vec3::Unit(a);
        slope[a] = (s->distance(p + step) - s->distance(p - step)) / 2e-6;
      }
      if (s->distance_is_bound()) {
        CHECK(slope.norm() < 1 + 1e-6);
        away_from_kinks += (slope - n).norm() < 1e-4;
      } else {
        away_from_kinks += (slope.normalized() - n).norm() < 0.5;  // first order in the distance
      }
    }
    CHECK(away_from_kinks > 0.95 * static_cast<double>(points.size()));
  }
}

TEST_CASE("distances of primitives are exact") {
  CHECK(solid(box({0, 0, 0}, {1, 1, 1}), 3)->distance({2, 3, 3}) == doctest::Approx(3));
  CHECK(solid(box({0, 0, 0}, {1, 1, 1}), 2)->distance({4, 5, 99}) == doctest::Approx(5));
  CHECK(solid(box({0, 0, 0}, {1, 1, 1}), 3)->distance({0.5, 0.9, 0.5}) == doctest::Approx(-0.1));
  CHECK(solid(cylinder({0, 0, 0}, {0, 0, 2}, 1), 3)->distance({4, 0, 6}) == doctest::Approx(5));
  CHECK(solid(cylinder({0, 0, 0}, {0, 0, 2}, 1), 3)->distance({0.2, 0, 1}) == doctest::Approx(-0.8));
  CHECK(solid(polygon(l_shape()), 2)->distance({2, 2, 0}) == doctest::Approx(1));
  CHECK(solid(polygon(l_shape()), 2)->distance({0.9, 0.9, 0}) == doctest::Approx(-std::sqrt(0.02)));
  CHECK(solid(polygon(l_shape()), 2)->distance({-3, -4, 0}) == doctest::Approx(5));
}

TEST_CASE("a polygon may run either way and repeat its first corner") {
  std::vector<Vec3> points = l_shape();
  std::reverse(points.begin(), points.end());
  points.push_back(points.front());
  const auto s = solid(polygon(points), 2);
  CHECK(s->measure(1) == doctest::Approx(4));
  CHECK(s->distance({0.5, 0.5, 0}) == doctest::Approx(-0.5));
  CHECK(s->normal({2, 1.5, 0}).isApprox(Vec3(0, 1, 0)));
}

TEST_CASE("sets are closed: the boundary belongs to them, within the tolerance") {
  const double tolerance = 1e-9;
  for (const double x : {0.2, 0.6, 0.2 - 5e-10, 0.6 + 5e-10})
    CHECK(solid(box({0.2, 0, 0}, {0.6, 1, 0}), 2)->contains({x, 0.3, 0}, tolerance));
  for (const double x : {0.2 - 2e-9, 0.6 + 2e-9})
    CHECK_FALSE(solid(box({0.2, 0, 0}, {0.6, 1, 0}), 2)->contains({x, 0.3, 0}, tolerance));
  const auto open_disc = solid(boolean("difference", {box({0, 0, 0}, {1, 1, 0}), ball({0, 0, 0}, 0.5)}), 2);
  CHECK(open_disc->contains({0.5, 0, 0}, tolerance));
  CHECK(solid(where("0.25 - X^2 - Y^2", {-1, -1, 0}, {1, 1, 0}), 2)->contains({0.5, 0, 0}, tolerance));
  CHECK_FALSE(solid(where("X^2 < 0.25", {-1, -1, 0}, {1, 1, 0}), 2)->contains({0.6, 0, 0}, tolerance));
}

TEST_CASE("regions of zero thickness hold the points on them") {
  const auto face = solid(box({0.6, 0.5, 0}, {0.6, 0.9, 0}), 2);
  CHECK(face->contains({0.6, 0.7, 0}, 1e-9));
  CHECK_FALSE(face->contains({0.6 + 1e-8, 0.7, 0}, 1e-9));
  CHECK(face->measure(0.1) == 0);
  const auto line = solid(polygon({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}), 2);
  CHECK(line->contains({0.5, 0.5, 0}, 1e-9));
  CHECK_FALSE(line->contains({0.5, 0.6, 0}, 1e-9));
  const auto point = solid(ball({1, 1, 1}, 0), 3);
  CHECK(point->contains({1, 1, 1}, 0));
  CHECK_FALSE(point->contains({1, 1, 1.1}, 0));
}

TEST_CASE("scale, rotation and translation apply in this order about the centre") {
  const auto s = solid(moved(box({1, 1, 0}, {3, 2, 0}), 2, 90, {10, 0, 0}), 2);  // centre (2, 1.5)
  const Bounds b = s->bounds();
  CHECK(b.min.isApprox(Vec3(11, -0.5, 0)));
  CHECK(b.max.isApprox(Vec3(13, 3.5, 0)));
  CHECK(s->contains({11, 3.5, 0}, 0));
  const auto floor = solid(moved(half_space({0, 1, 0}, {0, 1, 0}), 1, 90, {0, 0, 0}), 2);
  CHECK(floor->normal({0, 0, 0}).isApprox(Vec3(-1, 0, 0)));
  CHECK(floor->bounds().min.x() == 0);
  CHECK(std::isinf(floor->bounds().max.x()));
}

TEST_CASE("a quarter turn leaves faces exactly parallel to the axes") {
  const auto s = solid(moved(box({0, 0, 0}, {2, 1, 1}), 1, 90, {0, 0, 0}, {0, 0, 1}), 3);
  for (const SurfacePoint& q : s->surface(1)) CHECK(q.normal.cwiseAbs().maxCoeff() == 1);
}

TEST_CASE("touching members have no surface between them; common faces count once") {
  const auto surface =
      solid(boolean("union", {box({0, 0, 0}, {1, 1, 0}), box({0.5, 0, 0}, {2, 1, 0})}), 2)->surface(0.1);
  double area = 0;
  for (const SurfacePoint& q : surface) area += q.area;
  CHECK(area == doctest::Approx(6));
}

TEST_CASE("unbounded shapes say so") {
  const auto s = solid(half_space({0, 0.1, 0}, {0, 2, 0}), 2);
  CHECK(s->bounds().max.y() == 0.1);
  CHECK(std::isinf(s->bounds().min.y()));
  CHECK(std::isinf(s->measure(0.1)));
  CHECK(s->surface(0.1).empty());
  CHECK(std::isinf(solid(boolean("union", {half_space({0, 0, 0}, {1, 1, 0}), ball({0, 0, 0}, 1)}), 2)->measure(0.1)));
}

TEST_CASE("shapes of the wrong dimension and unknown ones are refused") {
  for (const ShapeType& type : shape_types()) {
    if (type.dimension == 0) continue;
    Shape other;
    other.type = type.name;
    CHECK_THROWS_AS((void)solid(other, 5 - type.dimension), std::invalid_argument);
  }
  Shape s;
  s.type = "boxx";
  CHECK_THROWS_AS((void)solid(s, 2), std::invalid_argument);
  CHECK_THROWS_AS((void)solid(cylinder({0, 0, 0}, {0, 0, 1}, 1), 2), std::invalid_argument);
  CHECK_THROWS_AS((void)solid(boolean("union", {}), 2), std::invalid_argument);
  Shape nested = box({0, 0, 0}, {1, 1, 0});
  for (int i = 0; i < 100; ++i) nested = boolean("union", {nested});
  CHECK_THROWS_AS((void)solid(nested, 2), std::invalid_argument);
}

TEST_CASE("NaN and far away coordinates are outside and do no harm") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Case& c : cases()) {
    CAPTURE(c.name);
    const auto s = solid(c.shape, c.dimension);
    std::vector<Vec3> normals;
    for (const Vec3& p : {Vec3(nan, 0, 0), Vec3(0, nan, 0), Vec3(1e308, -1e308, 0), Vec3(0, -1e200, 0)}) {
      CHECK_FALSE(s->contains(p, 1e-9));
      CHECK_FALSE(s->distance(p) < 0);
      s->contact_normals(p, false, 1e-9, normals);
      (void)s->normal(p);
    }
    CHECK(normals.empty());
  }
}
