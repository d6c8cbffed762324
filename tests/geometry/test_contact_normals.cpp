#include <doctest/doctest.h>

#include "shapes_for_tests.hpp"

using namespace pf;
using namespace pf::test;

namespace {

std::vector<Vec3> normals(const Shape& shape, int dimension, const Vec3& p, bool inverted) {
  std::vector<Vec3> list;
  make_solid(shape, dimension, {})->contact_normals(p, inverted, 1e-9, list);
  return list;
}

bool has(const std::vector<Vec3>& list, const Vec3& n) {
  for (const Vec3& m : list)
    if ((m - n).norm() < 1e-9) return true;
  return false;
}

}  // namespace

TEST_CASE("a convex body pushes out through its nearest face") {
  const Shape b = box({0, 0, 0}, {2, 1, 0});
  CHECK(normals(b, 2, {1, 0.9, 0}, false) == std::vector<Vec3>{Vec3(0, 1, 0)});
  CHECK(normals(b, 2, {0.1, 0.5, 0}, false) == std::vector<Vec3>{Vec3(-1, 0, 0)});
  CHECK(normals(b, 2, {1, 1.1, 0}, false).empty());
  const auto disc = normals(ball({0, 0, 0}, 1), 2, {0.3, 0.4, 0}, false);
  REQUIRE(disc.size() == 1);
  CHECK(has(disc, {0.6, 0.8, 0}));
}

TEST_CASE("a container gives one constraint a face, so a corner gives two or three") {
  const Shape b = box({0, 0, 0}, {1, 1, 1});
  CHECK(normals(b, 3, {0.5, 0.5, 0.5}, true).empty());
  CHECK(normals(b, 3, {-0.1, 0.5, 0.5}, true) == std::vector<Vec3>{Vec3(1, 0, 0)});
  const auto corner = normals(b, 3, {-0.1, 1.2, 0}, true);
  CHECK(corner.size() == 3);
  CHECK((has(corner, {1, 0, 0}) && has(corner, {0, -1, 0}) && has(corner, {0, 0, 1})));
  CHECK(normals(ball({0, 0, 0}, 1), 2, {2, 0, 0}, true) == std::vector<Vec3>{Vec3(-1, 0, 0)});
  const auto rim = normals(cylinder({0, 0, 0}, {0, 0, 1}, 1), 3, {2, 0, 2}, true);
  CHECK(rim.size() == 2);
  CHECK((has(rim, {-1, 0, 0}) && has(rim, {0, 0, -1})));
}

TEST_CASE("polygons: all faces of a convex container, the nearest of another") {
  const Shape wedge = polygon({{0, 0, 0}, {4, 0, 0}, {0, 1, 0}});
  CHECK(normals(wedge, 2, {5, -0.1, 0}, true).size() == 2);
  const Shape l = polygon(l_shape());
  const auto corner = normals(l, 2, {3.5, -0.5, 0}, true);
  CHECK(corner.size() == 2);
  CHECK((has(corner, {-1, 0, 0}) && has(corner, {0, 1, 0})));
  CHECK(normals(l, 2, {2, 1.2, 0}, true) == std::vector<Vec3>{Vec3(0, -1, 0)});
  CHECK(normals(l, 2, {2, 0.9, 0}, false) == std::vector<Vec3>{Vec3(0, 1, 0)});
}

TEST_CASE("a union offers the normals of every member that holds the point, equal ones once") {
  const Shape corner = boolean("union", {half_space({0, 0, 0}, {0, 1, 0}), half_space({0, 0, 0}, {1, 0, 0})});
  CHECK(normals(corner, 2, {-0.1, -0.1, 0}, false).size() == 2);
  CHECK(normals(corner, 2, {0.5, -0.1, 0}, false) == std::vector<Vec3>{Vec3(0, 1, 0)});
  CHECK(normals(corner, 2, {0.5, 0.1, 0}, false).empty());
  const Shape floors = boolean("union", {box({0, -9, 0}, {9, 0, 0}), box({5, -9, 0}, {14, 0, 0})});
  CHECK(normals(floors, 2, {7, -0.1, 0}, false) == std::vector<Vec3>{Vec3(0, 1, 0)});
}

TEST_CASE("the wall of a hole pushes into the hole") {
  const Shape tunnel = boolean("difference", {box({-5, -5, 0}, {5, 5, 0}), ball({0, 0, 0}, 1)});
  CHECK(normals(tunnel, 2, {0, 0.5, 0}, false).empty());
  CHECK(normals(tunnel, 2, {0, 1.1, 0}, false) == std::vector<Vec3>{Vec3(0, -1, 0)});
  CHECK(normals(tunnel, 2, {0, 4.9, 0}, false) == std::vector<Vec3>{Vec3(0, 1, 0)});
  // Inverted, the ball is the solid again.
  CHECK(normals(tunnel, 2, {0, 0.5, 0}, true) == std::vector<Vec3>{Vec3(0, 1, 0)});
}

TEST_CASE("an intersection pushes out through the nearest member, its outside through all that are passed") {
  const Shape wedge = boolean("intersection", {half_space({0, 0, 0}, {0, 1, 0}), half_space({0, 0, 0}, {1, 0, 0})});
  CHECK(normals(wedge, 2, {-3, -0.1, 0}, false) == std::vector<Vec3>{Vec3(0, 1, 0)});
  CHECK(normals(wedge, 2, {0.1, 0.2, 0}, true).size() == 2);
}

TEST_CASE("an expression's normal follows its slope, or the nearest change where it has none") {
  const Shape smooth = where("1 - X^2 - Y^2", {-2, -2, 0}, {2, 2, 0});
  const auto n = normals(smooth, 2, {0.3, 0.4, 0}, false);
  REQUIRE(n.size() == 1);
  CHECK(has(n, {0.6, 0.8, 0}));
  CHECK(has(normals(smooth, 2, {0, 1.5, 0}, true), {0, -1, 0}));
  const auto step = normals(where("X^2 + Y^2 < 1", {-2, -2, 0}, {2, 2, 0}), 2, {0.6, 0.7, 0}, false);
  REQUIRE(step.size() == 1);
  CHECK(step[0].dot(Vec3(0.6, 0.7, 0).normalized()) > 0.9);
}

TEST_CASE("normals turn with the shape") {
  const auto n = normals(moved(box({0, 0, 0}, {2, 1, 0}), 1, 90, {0, 0, 0}), 2, {0.6, 0.5, 0}, false);
  REQUIRE(n.size() == 1);
  CHECK(has(n, {-1, 0, 0}) != has(n, {1, 0, 0}));
}
