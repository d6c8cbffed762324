// Rigid solids: the 2D map of distances and the 3D mesh lie on the surface.
#include <doctest/doctest.h>

#include <cmath>

#include "fake_snapshots.hpp"
#include "render/distance_map.hpp"
#include "render/surface_mesh.hpp"

using namespace pf;

TEST_CASE("the map of distances is exact near surfaces and calls the shape rarely elsewhere") {
  Snapshot s;
  auto scene = std::make_shared<SceneView>();
  long calls = 0;
  const auto box = [&calls](const Vec3& p) {
    ++calls;
    const Vec<2> q = p.head<2>().cwiseAbs() - Vec<2>(1, 0.5);
    return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
  };
  scene->boundaries.push_back({box, {-1, -0.5, 0}, {1, 0.5, 0}, "slip"});
  s.scene = scene;
  s.boundary_displacement = {Vec3(0.25, 0, 0)};
  const ViewSize size{800, 600};
  const Camera2D camera{{0, 0}, 200};
  const DistanceMap map = DistanceMap::sample(s, camera, size);
  CHECK(map.solids);
  CHECK_FALSE(map.regions);
  CHECK(calls < map.columns * map.rows / 3);
  for (int j = 0; j < map.rows; j += 3) {
    for (int i = 0; i < map.columns; i += 3) {
      const Vec3 p = camera.to_world({i * map.pitch, size.height - j * map.pitch}, size);
      const double exact = 200 * box(p - Vec3(0.25, 0, 0));
      const double sampled = map.values[3 * (static_cast<std::size_t>(j) * map.columns + i)];
      if (std::abs(exact) < 6) CHECK(sampled == doctest::Approx(exact).epsilon(1e-4));
      CHECK((sampled > 0) == (exact > 0));
    }
  }
}

TEST_CASE("the mesh of a ball lies on the ball and has its area") {
  const auto ball = [](const Vec3& p) { return p.norm() - 0.5; };
  const auto mesh = surface_mesh(ball, {Vec3::Constant(-0.6), Vec3::Constant(0.6)}, 40);
  REQUIRE(mesh.size() > 300);
  REQUIRE(mesh.size() % 3 == 0);
  double area = 0;
  for (std::size_t t = 0; t < mesh.size(); t += 3) {
    const Vec3 a = mesh[t + 1].position - mesh[t].position, b = mesh[t + 2].position - mesh[t].position;
    area += 0.5 * std::sqrt(std::max(0.0, a.squaredNorm() * b.squaredNorm() - a.dot(b) * a.dot(b)));
  }
  for (const SurfaceVertex& v : mesh) {
    CHECK(std::abs(ball(v.position)) < 1e-4);
    CHECK((v.normal - v.position.normalized()).norm() < 1e-2);
  }
  CHECK(area == doctest::Approx(4 * 3.14159265 * 0.25).epsilon(0.02));
}

TEST_CASE("half-spaces are recognised as planes, other unbounded solids are not") {
  const Vec3 infinite = Vec3::Constant(INFINITY);
  const Vec3 n = Vec3(0.2, 1, -0.1).normalized();
  const ViewBounds near{{-1, 3, -1}, {1, 4, 1}};
  const BoundaryView half{[n](const Vec3& p) { return n.dot(p) - 0.3; }, -infinite, infinite, "slip"};
  const auto plane = as_plane(half, near);
  REQUIRE(plane);
  CHECK((plane->normal - n).norm() < 1e-9);
  CHECK(n.dot(plane->point) == doctest::Approx(0.3));
  const BoundaryView wedge{[](const Vec3& p) { return std::min(p.y(), p.x() + 2); }, -infinite, infinite, "slip"};
  CHECK_FALSE(as_plane(wedge, near));
}
