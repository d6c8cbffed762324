#include "core/assets.hpp"
#include "core/charts/image.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "core/scene/scene_io.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

TEST_CASE("shipped fonts are found, and their licence with them") {
  for (const char* name : {"NotoSans-Regular.ttf", "NotoSans-Bold.ttf", "NotoSansMath-Regular.ttf", "OFL.txt"}) {
    CAPTURE(name);
    CHECK(fs::file_size(pf::asset_path(std::string("fonts/") + name)) > 1000);
  }
}

TEST_CASE("PUSHFORWARD_ASSETS comes first, file by file") {
  const pf::test::TemporaryFolder scratch;
  const fs::path& folder = scratch.path();
  fs::create_directories(folder / "fonts");
  std::ofstream(folder / "fonts" / "OFL.txt") << "mine";
  setenv("PUSHFORWARD_ASSETS", folder.c_str(), 1);
  CHECK(pf::asset_path("fonts/OFL.txt") == folder / "fonts/OFL.txt");
  CHECK(pf::asset_path("fonts/NotoSans-Bold.ttf") != folder / "fonts/NotoSans-Bold.ttf");
  unsetenv("PUSHFORWARD_ASSETS");
  CHECK(pf::asset_path("fonts/OFL.txt") != folder / "fonts/OFL.txt");
}

TEST_CASE("a missing asset is named with every place that was tried") {
  try {
    pf::asset_path("scenes/no-such-scene.json");
    FAIL("found a file that does not exist");
  } catch (const pf::FileError& error) {
    const std::string message = error.what();
    CHECK(message.find("scenes/no-such-scene.json") != std::string::npos);
    for (const fs::path& root : pf::asset_roots()) CHECK(message.find(root.string()) != std::string::npos);
  }
}

TEST_CASE("every shipped scene has a small picture for the gallery") {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(pf::asset_path("scenes"))) {
    if (entry.path().extension() != ".json") continue;
    ++scenes;
    fs::path picture = entry.path();
    picture.replace_extension(".png");
    CAPTURE(picture.string());  // made by scripts/make-pictures.sh
    REQUIRE(fs::exists(picture));
    CHECK(fs::file_size(picture) < 100'000);
    const pf::Image image = pf::read_image(picture);
    CHECK(image.width >= 300);
    CHECK(image.height >= 180);
  }
  CHECK(scenes >= 8);
}
