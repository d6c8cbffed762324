// Cameras: world <-> pixel, zoom about a point, fitting, picking.
#include <doctest/doctest.h>

#include "fake_snapshots.hpp"
#include "render/camera.hpp"

using namespace pf;

namespace {
constexpr ViewSize size{1280, 720};
}

TEST_CASE("2D: pixel and world are inverse, also 10 km away") {
  Camera2D camera{{1e4, -1e4}, 850};
  const Vec3 x(1e4 + 0.3, -1e4 - 0.2, 0);
  const Vec<2> pixel = camera.to_pixel(x, size);
  CHECK(pixel.x() == doctest::Approx(640 + 0.3 * 850));
  CHECK(pixel.y() == doctest::Approx(360 + 0.2 * 850));  // y downwards
  CHECK((camera.to_world(pixel, size) - x).norm() < 1e-10);
}

TEST_CASE("2D: zooming keeps the point under the mouse, a drag moves it with the mouse") {
  Camera2D camera{{0.4, 0.1}, 300};
  const Vec<2> mouse(200, 600);
  const Vec3 before = camera.to_world(mouse, size);
  camera.zoom(1.7, mouse, size);
  CHECK(camera.pixels_per_metre == doctest::Approx(510));
  CHECK((camera.to_world(mouse, size) - before).norm() < 1e-12);
  camera.pan({31, -12});
  CHECK((camera.to_pixel(before, size) - mouse - Vec<2>(31, -12)).norm() < 1e-9);
}

TEST_CASE("fitting shows all of the bounds inside the margins, and touches them") {
  const ViewMargins margins{30, 110, 60, 50};
  const ViewBounds bounds{{-2, 0.5, -1}, {1, 1.5, 3}};
  for (const int dimension : {2, 3}) {
    const Camera camera = fitted_camera(dimension, bounds, size, margins);
    double tightest = 1e9;
    for (int c = 0; c < 8; ++c) {
      const Vec3 corner(c & 1 ? 1 : -2, c & 2 ? 1.5 : 0.5, c & 4 ? 3 : -1);
      const auto pixel = to_pixel(camera, corner, size);
      REQUIRE(pixel);
      const double room = std::min({pixel->x() - 30, 1170 - pixel->x(), pixel->y() - 60, 670 - pixel->y()});
      // Perspective and an off-centre view: the shift is exact at the target's depth only.
      CHECK(room > (dimension == 2 ? -1e-6 : -40));
      tightest = std::min(tightest, room);
    }
    CHECK(tightest < (dimension == 2 ? 1e-6 : 60));
  }
}

TEST_CASE("3D: the ray through a point's pixel meets the point") {
  OrbitCamera camera;
  camera.target = {1, 2, 3};
  camera.yaw = 2.1;
  camera.pitch = -0.4;
  camera.distance = 7;
  const Vec3 x(1.5, 1.2, 2.6);
  const auto pixel = camera.to_pixel(x, size);
  REQUIRE(pixel);
  const Vec3 ray = camera.ray(*pixel, size), d = x - camera.eye();
  CHECK((d - ray * ray.dot(d)).norm() < 1e-12);
  CHECK((camera.to_world(*pixel, size, x) - x).norm() < 1e-12);
  CHECK_FALSE(camera.to_pixel(camera.eye() - camera.forward(), size));
  CHECK(camera.right().dot(camera.up()) == doctest::Approx(0));
  CHECK(camera.up().y() > 0);
}

TEST_CASE("picking finds the particle that is drawn there") {
  const Snapshot flat = fake::two_blocks();
  const Camera camera = fitted_camera(2, scene_bounds(flat), size);
  for (std::size_t p = 0; p < flat.particles; p += 211) {
    const auto pixel = to_pixel(camera, {flat.x[2 * p], flat.x[2 * p + 1], 0}, size);
    CHECK(pick_particle(flat, camera, size, *pixel) == p);
  }
  CHECK_FALSE(pick_particle(flat, camera, size, {3, 3}));

  const Snapshot bar = fake::twisted_bar();
  const Camera orbit = fitted_camera(3, scene_bounds(bar), size);
  const auto eye = std::get<OrbitCamera>(orbit).eye();
  for (std::size_t p = 0; p < bar.particles; p += 97) {
    const Vec3 x(bar.x[3 * p], bar.x[3 * p + 1], bar.x[3 * p + 2]);
    const auto picked = pick_particle(bar, orbit, size, *to_pixel(orbit, x, size));
    REQUIRE(picked);
    const Vec3 y(bar.x[3 * *picked], bar.x[3 * *picked + 1], bar.x[3 * *picked + 2]);
    CHECK((y - eye).norm() <= (x - eye).norm() + 1e-9);  // itself, or one in front of it
  }
}

TEST_CASE("the scene's bounds hold the way down to the floor") {
  const Snapshot s = fake::two_blocks();
  const ViewBounds body = particle_bounds(s), all = scene_bounds(s);
  CHECK(all.min.y() < 0.05);
  CHECK(all.min.y() > -0.5);
  CHECK(all.min.x() <= -1.0 + 1e-9);  // the ball
  CHECK(all.max.x() == doctest::Approx(body.max.x()));
  Snapshot empty;
  CHECK(particle_bounds(empty).size().x() == 1);
}
