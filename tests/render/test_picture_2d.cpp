// Pictures of hand-made 2D snapshots: the pixels are where and what the snapshot says.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include "core/charts/colormap.hpp"
#include "core/charts/image.hpp"
#include "fake_snapshots.hpp"
#include "render/offscreen.hpp"
#include "render/renderer.hpp"

using namespace pf;

namespace {

constexpr ViewSize size{1280, 720};

/// Set PUSHFORWARD_TEST_PICTURES to a folder to look at what the tests draw.
Image drawn(const Snapshot& s, const RenderOptions& options, const Camera& camera, const char* name) {
  static OffscreenContext context;
  context.make_current();
  Renderer renderer;
  OffscreenTarget target(size);
  renderer.draw(s, options, camera, {0, 0, size});
  CHECK(take_gl_errors() == "");
  Image image = target.read();
  if (const char* folder = std::getenv("PUSHFORWARD_TEST_PICTURES"))
    write_png(image, std::filesystem::path(folder) / (std::string(name) + ".png"));
  return image;
}

Camera fitted(const Snapshot& s) {
  return fitted_camera(2, scene_bounds(s), size, {60, 60, 60, 60});
}

double difference(Color a, Color b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

Color at_particle(const Image& image, const Snapshot& s, const Camera& camera, std::size_t p) {
  const auto pixel = to_pixel(camera, {s.x[2 * p], s.x[2 * p + 1], 0}, size);
  return image.color(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
}

}  // namespace

TEST_CASE("a particle's pixel has the colour of its field's value") {
  const Snapshot s = fake::two_blocks();
  RenderOptions options;
  options.field = Field::speed;
  options.range = ValueRange{0, 2};
  options.regions = false;
  const Camera camera = fitted(s);
  const Image image = drawn(s, options, camera, "speed");
  for (std::size_t p = 0; p < s.particles; p += 37) {
    const double t = s.field[0][p] / 2;
    CHECK(difference(at_particle(image, s, camera, p), sample(ColormapKind::sequential, t)) < 0.03);
  }
}

TEST_CASE("categories have their own colours") {
  const Snapshot s = fake::two_blocks();
  RenderOptions options;
  options.field = Field::material;
  options.regions = false;
  const Camera camera = fitted(s);
  const Image image = drawn(s, options, camera, "material");
  for (std::size_t p = 0; p < s.particles; p += 97)
    CHECK(difference(at_particle(image, s, camera, p), categorical_color(s.material[p])) < 0.02);
}

TEST_CASE("a solid shows no gap between its particles, at any zoom") {
  Snapshot s = fake::two_blocks();
  RenderOptions options;
  options.field = Field::material;
  options.regions = false;
  options.theme.outline = 0;
  const Color expected = categorical_color(0);
  for (const double zoom : {0.25, 0.5, 1.0, 1.37, 3.0}) {
    Camera2D camera = std::get<Camera2D>(fitted(s));
    camera.pixels_per_metre *= zoom;
    camera.centre = Vec<2>(0.2, 0.75);
    const Image image = drawn(s, options, camera, "solid");
    double worst = 0;
    const int reach = static_cast<int>(0.25 * camera.pixels_per_metre);
    for (int y = std::max(0, 360 - reach); y < std::min(720, 360 + reach); ++y)
      for (int x = std::max(0, 640 - reach); x < std::min(1280, 640 + reach); ++x)
        worst = std::max(worst, difference(image.color(x, y), expected));
    CHECK(worst < 0.03);
  }
}

TEST_CASE("a body 10 km away gives the same picture as at the origin") {
  const Vec<2> far(1e4, -1e4);
  const Snapshot near = fake::two_blocks(), distant = fake::two_blocks(far);
  RenderOptions options;
  options.grid = true;
  options.range = ValueRange{0, 2};
  options.regions = false;
  options.theme.solid_hatch = options.theme.solid;  // its phase belongs to the place in the world
  Camera2D camera = std::get<Camera2D>(fitted(near));
  const Image a = drawn(near, options, camera, "near");
  camera.centre += far;
  const Image b = drawn(distant, options, camera, "far");
  int differing = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) differing += difference(a.color(x, y), b.color(x, y)) > 0.06;
  CHECK(differing < 200);  // of 921600: rounding at edges
}

TEST_CASE("particles with J <= 0 are marked") {
  Snapshot s = fake::two_blocks();
  const std::size_t p = 40 * 20 + 20;
  s.F[4 * p] = -s.F[4 * p], s.F[4 * p + 1] = -s.F[4 * p + 1];
  RenderOptions options;
  const Camera camera = fitted(s);
  const Image image = drawn(s, options, camera, "inverted");
  CHECK(difference(at_particle(image, s, camera, p), options.theme.inverted) < 0.1);
}

TEST_CASE("every option draws without errors of OpenGL, and a second frame is the same") {
  Snapshot s = fake::two_blocks();
  s.grabbed = true;
  s.grab_at = {0.3, 0.8, 0};
  s.grab_target = {0.6, 1.1, 0};
  s.grab_radius = 0.1;
  OffscreenContext context;
  Renderer renderer;
  OffscreenTarget target(size);
  const Camera camera = fitted(s);
  RenderOptions options;
  options.field = Field::J;
  options.grid = options.velocities = options.bent_grid = true;
  options.selected = 821;
  for (const bool deformed : {true, false}) {
    options.deformed = deformed;
    renderer.draw(s, options, camera, {0, 0, size});
    const Image first = target.read();
    renderer.draw(s, options, camera, {0, 0, size});
    CHECK(target.read().pixels == first.pixels);
    CHECK(take_gl_errors() == "");
    if (const char* folder = std::getenv("PUSHFORWARD_TEST_PICTURES"))
      write_png(first, std::filesystem::path(folder) / (deformed ? "all.png" : "all_round.png"));
  }
}

TEST_CASE("a snapshot without grid, F, fields or scene is drawn as far as it goes") {
  Snapshot s = fake::two_blocks();
  s.F.clear();
  s.volume0.clear();
  s.field = {};
  s.scene = nullptr;
  s.nodes = 0;
  s.node_index.clear();
  RenderOptions options;
  options.grid = options.velocities = options.bent_grid = true;
  (void)drawn(s, options, fitted(fake::two_blocks()), "bare");
  (void)drawn(Snapshot{}, options, fitted(fake::two_blocks()), "empty");
}
