#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "shapes_for_tests.hpp"

using namespace pf;
using namespace pf::test;

namespace {

/// A star with `n` arms: far from convex.
std::vector<Vec3> star(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i < 2 * n; ++i) {
    const double angle = std::numbers::pi * i / n, radius = i % 2 == 0 ? 1 : 0.6;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return points;
}

/// By looking at every edge.
double plain_distance(const std::vector<Vec3>& points, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 a = points[i], b = points[(i + 1) % points.size()], e = b - a;
    const double s = std::clamp((p - a).dot(e) / e.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - s * e).norm());
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / e.y() * e.x()) inside = !inside;
  }
  return inside ? -least : least;
}

}  // namespace

TEST_CASE("a polygon of many corners has the distances that its edges have one by one") {
  for (const int arms : {2, 5, 33, 400}) {
    const std::vector<Vec3> points = star(arms);
    const auto solid = make_solid(polygon(points), 2, {});
    for (double x = -1.21; x < 1.3; x += 0.083)
      for (double y = -1.2; y < 1.3; y += 0.061) {
        const Vec3 p(x, y, 0);
        CHECK(solid->distance(p) == doctest::Approx(plain_distance(points, p)).epsilon(1e-12));
      }
  }
}

TEST_CASE("a ray through corners and along edges does not lose the inside") {
  // Corners and horizontal edges at y = 0 and y = 1 exactly where points are asked for.
  const std::vector<Vec3> stairs = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0},
                                    {2, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}};
  const auto solid = make_solid(polygon(stairs), 2, {});
  CHECK(solid->distance({0.5, 1, 0}) < 0);
  CHECK(solid->distance({2.5, 1, 0}) < 0);
  CHECK(solid->distance({1.5, 0.5, 0}) > 0);
  CHECK(solid->distance({-1, 1, 0}) > 0);
  CHECK(solid->distance({-1, 0, 0}) == doctest::Approx(1));
  CHECK(solid->distance({4, 2, 0}) == doctest::Approx(1));
  CHECK(solid->distance({1.5, 1, 0}) == 0);
}

TEST_CASE("degenerate polygons do no harm") {
  for (const std::vector<Vec3>& points : {std::vector<Vec3>{{1, 1, 0}},
                                          {{1, 1, 0}, {1, 1, 0}},
                                          {{0, 0, 0}, {1, 1, 0}},
                                          {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}},
                                          {{0, 0, 0}, {1e-320, 0, 0}, {0, 1e-320, 0}}}) {
    const auto solid = make_solid(polygon(points), 2, {});
    CHECK(solid->measure(0.1) >= 0);
    CHECK(solid->contains(points[0], 1e-9));
    CHECK_FALSE(solid->contains({5, 5, 0}, 1e-9));
    CHECK(solid->normal({0.2, 0.9, 0}).allFinite());
    std::vector<Vec3> normals;
    solid->contact_normals({5, 5, 0}, true, 1e-9, normals);
    for (const Vec3& n : normals) CHECK(n.allFinite());
    for (const SurfacePoint& s : solid->surface(0.3)) CHECK(s.position.allFinite());
  }
}
