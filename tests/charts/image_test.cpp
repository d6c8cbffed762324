#include "core/charts/image.hpp"
#include "core/files.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "core/scene/scene_io.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;
using pf::Image;

namespace {

Image ramp(int width, int height, bool transparent) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* p = image.at(x, y);
      p[0] = static_cast<std::uint8_t>(x);
      p[1] = static_cast<std::uint8_t>(y);
      p[2] = static_cast<std::uint8_t>(x * y);
      p[3] = transparent ? static_cast<std::uint8_t>(x + y) : 255;
    }
  }
  return image;
}

struct TemporaryFile {
  pf::test::TemporaryFolder folder;
  fs::path path;
  explicit TemporaryFile(const char* name) : path(folder / name) {}
};

}  // namespace

TEST_CASE("a picture survives writing and reading, with its text") {
  const TemporaryFile file("pushforward-image-test.png");
  for (const bool transparent : {false, true}) {
    CAPTURE(transparent);
    const Image image = ramp(61, 37, transparent);
    const pf::ImageText text = {{"Software", "pushforward 0.1.0"}, {"Scene", "Fédération, dx = 10⁻²"}, {"Hash", ""}};
    pf::write_png(image, file.path, text);
    const Image back = pf::read_image(file.path);
    CHECK(back.width == 61);
    CHECK(back.height == 37);
    CHECK(back.pixels == image.pixels);
    CHECK(pf::read_png_text(file.path) == text);
  }
}

TEST_CASE("an opaque picture is stored without alpha") {
  constexpr std::size_t colour_type = 25;
  CHECK(pf::encode_png(ramp(5, 4, false))[colour_type] == 2);
  CHECK(pf::encode_png(ramp(5, 4, true))[colour_type] == 6);
}

TEST_CASE("flip_rows turns bottom-up rows the right way up") {
  Image image = ramp(3, 5, false);
  image.flip_rows();
  for (int y = 0; y < 5; ++y) CHECK(image.at(2, y)[1] == 4 - y);
}

TEST_CASE("files that cannot be read or written are FileErrors, and leave nothing behind") {
  const Image image(2, 2, {1, 0, 0, 1});
  CHECK_THROWS_AS(pf::write_png(image, "/no/such/folder/picture.png"), pf::FileError);
  CHECK_THROWS_AS(pf::read_image("/no/such/picture.png"), pf::FileError);
  const TemporaryFile file("pushforward-not-a-picture.png");
  pf::write_atomically(file.path, "this is text, not a picture");
  CHECK_THROWS_AS(pf::read_image(file.path), pf::FileError);
  const pf::test::TemporaryFolder scratch;
  const fs::path folder = scratch / "folder.png";
  fs::create_directory(folder);
  CHECK_THROWS_AS(pf::write_png(image, folder), pf::FileError);
  CHECK_FALSE(fs::exists(folder.string() + ".part"));
}
