#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/scene/scene_io.hpp"

using namespace pf;

TEST_CASE("every shipped scene reads, reads back equal, and says what it shows") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PUSHFORWARD_SOURCE "/assets/scenes")) {
    CAPTURE(entry.path().string());
    if (entry.path().extension() == ".png") continue;  // for the gallery
    REQUIRE(entry.path().extension() == ".json");
    const std::string stem = entry.path().stem().string();
    CHECK(std::all_of(stem.begin(), stem.end(),
                      [](char c) { return std::islower(static_cast<unsigned char>(c)) || c == '-'; }));
    const Scene scene = load_scene(entry.path());
    CHECK(parse_scene(scene_text(scene), "written") == scene);
    CHECK(parse_scene(to_json(scene).dump(), "json") == scene);
    CHECK(!scene.name.empty());
    CHECK(scene.about.size() > 40);
    CHECK(scene.about.size() < 200);
    CHECK(scene.about.back() == '.');
    ++count;
  }
  CHECK(count >= 8);
}
