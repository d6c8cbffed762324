// Pictures of hand-made 3D snapshots.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "core/charts/colormap.hpp"
#include "core/charts/image.hpp"
#include "fake_snapshots.hpp"
#include "render/offscreen.hpp"
#include "render/picture.hpp"

using namespace pf;

namespace {

constexpr ViewSize size{1280, 720};

void keep(const Image& image, const char* name) {
  if (const char* folder = std::getenv("PUSHFORWARD_TEST_PICTURES"))
    write_png(image, std::filesystem::path(folder) / (std::string(name) + ".png"));
}

PictureOptions plain() {
  PictureOptions options;
  options.overlay = false;
  return options;
}

Image taken(const Snapshot& s, const PictureOptions& options, const Camera& camera, const char* name) {
  PictureMaker maker(options);
  maker.set_camera(camera);
  Image image = maker.draw(s);
  CHECK(take_gl_errors() == "");
  keep(image, name);
  return image;
}

Vec3 position(const Snapshot& s, std::size_t p) {
  return {s.x[3 * p], s.x[3 * p + 1], s.x[3 * p + 2]};
}

double difference(Color a, Color b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// Cosine of the angle between two colours seen from black: 1 where they differ in brightness only.
double likeness(Color a, Color b) {
  const Vec3 p(a.r, a.g, a.b), q(b.r, b.g, b.b);
  return p.dot(q) / (p.norm() * q.norm());
}

}  // namespace

TEST_CASE("finished pictures, dark and light, draw without errors of OpenGL") {
  PictureOptions options;
  options.title = "Twisted bar";
  keep(draw_picture(fake::twisted_bar(), options), "bar_dark");
  options.render.theme = RenderTheme::light();
  keep(draw_picture(fake::twisted_bar(), options), "bar_light");
  options.title = "Two blocks";
  keep(draw_picture(fake::two_blocks(), options), "blocks_light");
  options.render.theme = RenderTheme::dark();
  options.render.grid = options.render.bent_grid = true;
  options.render.bent_magnification = 2;
  options.render.field = Field::J;
  PictureMaker maker(options);
  keep(maker.draw(fake::two_blocks()), "blocks_dark");
  CHECK(take_gl_errors() == "");
}

TEST_CASE("3D: the pixel of a particle in front has its hue") {
  Snapshot s = fake::twisted_bar();
  for (std::size_t p = 0; p < s.particles; ++p) s.material[p] = static_cast<std::uint16_t>(p % 2 ? 0 : 3);
  PictureOptions options = plain();
  options.render.field = Field::material;
  options.render.boundaries = false;
  const Camera camera = picture_camera(s, size, false);
  const Image image = taken(s, options, camera, "bar_material");
  int seen = 0, alike = 0;
  for (std::size_t p = 0; p < s.particles; p += 7) {
    const auto pixel = to_pixel(camera, position(s, p), size);
    if (pick_particle(s, camera, size, *pixel, 0) != p) continue;
    ++seen;
    const Color color = image.color(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
    alike += likeness(color, categorical_color(s.material[p])) > 0.93;
  }
  CHECK(seen > 20);
  CHECK(alike > 0.9 * seen);  // some pixels are shared with a neighbour of the other colour
}

TEST_CASE("3D: a body 10 km away gives the same picture as at the origin") {
  // A whole number of pitches of the ground's lattice.
  const Vec3 far(1e4, 2e3, -1e4);
  const Snapshot near = fake::twisted_bar(), distant = fake::twisted_bar(10, 30, 10, far);
  OrbitCamera camera = std::get<OrbitCamera>(picture_camera(near, size, false));
  const Image a = taken(near, plain(), camera, "bar_near");
  camera.target += far;
  const Image b = taken(distant, plain(), camera, "bar_far");
  int differing = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) differing += difference(a.color(x, y), b.color(x, y)) > 0.08;
  CHECK(differing < 300);  // of 921600
}

TEST_CASE("3D: particles with J <= 0 are marked, through what is in front of them") {
  Snapshot s = fake::twisted_bar();
  const std::size_t p = 10 * 15 + 5;
  for (std::size_t q = 0; q < 3; ++q) s.F[9 * p + q] *= -1;
  const Camera camera = picture_camera(s, size, false);
  const PictureOptions options = plain();
  const Image image = taken(s, options, camera, "bar_inverted");
  const auto pixel = to_pixel(camera, position(s, p), size);
  const Color color = image.color(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
  CHECK(difference(color, options.render.theme.inverted) < 0.15);
}

TEST_SUITE("long") {
  TEST_CASE("100 thousand particles take a quarter of a second of processor time on software OpenGL") {
    const OffscreenContext context;
    Renderer renderer;
    OffscreenTarget target(size, 1);
    if (!renderer.software()) return;
    for (const int dimension : {2, 3}) {
      Snapshot s = dimension == 2 ? fake::two_blocks({0, 0}, 224) : fake::twisted_bar(34, 90, 33);
      REQUIRE(s.particles > 100000);
      const Camera camera = fitted_camera(dimension, scene_bounds(s), size);
      double best = 1e9;
      for (int k = 0; k < 12; ++k) {
        s.report.step = k;  // uploads every time
        const std::clock_t begin = std::clock();
        renderer.draw(s, {}, camera, {0, 0, size});
        (void)target.read();
        // All cores' time together: a loaded machine does not change it.
        best = std::min(best, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      }
      MESSAGE(dimension, "D: ", s.particles, " particles: ", best, " ms of CPU a frame");
      CHECK(best < 250);
    }
  }
}
