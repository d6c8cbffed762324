// Pictures of hand-made 3D snapshots.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include "core/charts/image.hpp"
#include "fake_snapshots.hpp"
#include "render/picture.hpp"

using namespace pf;

namespace {
void keep(const Image& image, const char* name) {
  if (const char* folder = std::getenv("PUSHFORWARD_TEST_PICTURES"))
    write_png(image, std::filesystem::path(folder) / (std::string(name) + ".png"));
}
}  // namespace

TEST_CASE("a 3D picture and its overlay draw without errors of OpenGL") {
  PictureOptions options;
  options.title = "Twisted bar";
  keep(draw_picture(fake::twisted_bar(), options), "bar_dark");
  CHECK(take_gl_errors() == "");
  options.render.theme = RenderTheme::light();
  keep(draw_picture(fake::twisted_bar(), options), "bar_light");
  keep(draw_picture(fake::two_blocks(), options), "blocks_light");
  options.render.theme = RenderTheme::dark();
  options.render.velocities = options.render.grid = true;
  options.render.field = Field::J;
  keep(draw_picture(fake::two_blocks(), options), "blocks_dark");
}
