// Principal stress crosses: where, how long and which colour.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include "core/charts/image.hpp"
#include "fake_snapshots.hpp"
#include "render/cross_layer.hpp"
#include "render/offscreen.hpp"

using namespace pf;

namespace {

constexpr ViewSize size{1280, 720};

struct Drawn {
  Image image;
  double pixels_per_pascal = 0;
};

Drawn drawn(const Snapshot& s, const Camera& camera, const char* name) {
  static OffscreenContext context;
  context.make_current();
  Renderer renderer;
  OffscreenTarget target(size);
  RenderOptions options;
  options.stress_crosses = true;
  options.regions = options.boundaries = false;
  options.range = ValueRange{0, 1e9};  // dark everywhere
  renderer.draw(s, options, camera, {0, 0, size});
  CHECK(take_gl_errors() == "");
  Drawn out{target.read(), renderer.cross_pixels_per_pascal()};
  if (const char* folder = std::getenv("PUSHFORWARD_TEST_PICTURES"))
    write_png(out.image, std::filesystem::path(folder) / (std::string(name) + ".png"));
  return out;
}

/// xx yy zz xy yz xz everywhere.
void stress_everywhere(Snapshot& s, const std::array<float, 6>& sigma) {
  for (std::size_t p = 0; p < s.particles; ++p) s.stress.insert(s.stress.end(), sigma.begin(), sigma.end());
}

std::size_t near(const Image& image, Color color) {
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Color c = image.color(x, y);
      count += std::abs(c.r - color.r) + std::abs(c.g - color.g) + std::abs(c.b - color.b) < 0.25f;
    }
  return count;
}

/// Largest runs of the colour along x and along y [px].
std::pair<int, int> longest_runs(const Image& image, Color color) {
  const auto is = [&](int x, int y) {
    const Color c = image.color(x, y);
    return std::abs(c.r - color.r) + std::abs(c.g - color.g) + std::abs(c.b - color.b) < 0.25f;
  };
  int across = 0, up = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0, run = 0; x < image.width; ++x) across = std::max(across, run = is(x, y) ? run + 1 : 0);
  for (int x = 0; x < image.width; ++x)
    for (int y = 0, run = 0; y < image.height; ++y) up = std::max(up, run = is(x, y) ? run + 1 : 0);
  return {across, up};
}

}  // namespace

TEST_CASE("tension along x and half of it in compression along y: red lines across, blue ones up, half as long") {
  const RenderTheme theme = RenderTheme::dark();
  Snapshot s = fake::two_blocks();
  stress_everywhere(s, {2e4f, -1e4f, 0, 0, 0, 0});
  const Drawn d = drawn(s, fitted_camera(2, scene_bounds(s), size, {60, 60, 60, 60}), "crosses");
  CHECK(d.pixels_per_pascal * 2e4 == doctest::Approx(0.95 * 30));
  const auto [red_across, red_up] = longest_runs(d.image, tension_color(theme));
  const auto [blue_across, blue_up] = longest_runs(d.image, compression_color(theme));
  CHECK(red_across >= 22);
  CHECK(red_across <= 34);
  CHECK(red_up <= 4);
  CHECK(blue_up >= 5);  // what the red line does not cover, on one side at least
  CHECK(blue_up <= 18);
  CHECK(blue_across <= 4);
}

TEST_CASE("shear has its crosses along the diagonals; nothing is drawn without stress") {
  Snapshot s = fake::two_blocks();
  const Camera camera = fitted_camera(2, scene_bounds(s), size, {60, 60, 60, 60});
  const Drawn none = drawn(s, camera, "no-crosses");
  CHECK(none.pixels_per_pascal == 0);
  CHECK(near(none.image, tension_color(RenderTheme::dark())) == 0);
  stress_everywhere(s, {0, 0, 0, 1e4f, 0, 0});
  const Drawn d = drawn(s, camera, "shear-crosses");
  CHECK(near(d.image, tension_color(RenderTheme::dark())) > 200);
  const auto [across, up] = longest_runs(d.image, tension_color(RenderTheme::dark()));
  CHECK(across <= 6);
  CHECK(up <= 6);
}

TEST_CASE("ten times as many particles have no more crosses: they stay legible; 3D shows the foremost") {
  const auto reds = [](int n) {
    Snapshot s = fake::two_blocks(Vec<2>::Zero(), n);
    stress_everywhere(s, {1e4f, 1e3f, 0, 0, 0, 0});
    const Camera camera = fitted_camera(2, scene_bounds(fake::two_blocks()), size, {60, 60, 60, 60});
    return near(drawn(s, camera, "many-crosses").image, tension_color(RenderTheme::dark()));
  };
  const std::size_t few = reds(40), many = reds(130);
  CHECK(many < 1.5 * static_cast<double>(few));
  CHECK(many > 0.6 * static_cast<double>(few));
  Snapshot bar = fake::twisted_bar();
  stress_everywhere(bar, {0, 1e4f, 0, 0, 0, 0});
  const Drawn d = drawn(bar, fitted_camera(3, particle_bounds(bar), size, {60, 60, 60, 60}), "crosses-3d");
  const auto [across, up] = longest_runs(d.image, tension_color(RenderTheme::dark()));
  CHECK(up >= 18);
  CHECK(across <= 6);
}
