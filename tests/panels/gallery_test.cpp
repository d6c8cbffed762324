#include "app/panels/gallery.hpp"

#include <doctest/doctest.h>

using namespace pf::app;

TEST_CASE("scenes are found by a few of their letters") {
  CHECK(fuzzy_score("", "Welcome") >= 0);
  CHECK(fuzzy_score("cant", "Drooping cantilever") > 0);
  CHECK(fuzzy_score("DC", "Drooping cantilever") > 0);
  CHECK(fuzzy_score("xyz", "Drooping cantilever") < 0);
  CHECK(fuzzy_score("revelitnac", "Drooping cantilever") < 0);
  // Beginnings of words beat letters that happen to be there.
  CHECK(fuzzy_score("sd", "Spinning disc") > fuzzy_score("sd", "Colliding discs"));
  CHECK(fuzzy_score("disc", "Spinning disc") > fuzzy_score("dsc", "Spinning disc"));
}

TEST_CASE("the gallery lists the shipped scenes, welcome first") {
  const auto entries = list_scenes(PUSHFORWARD_SOURCE "/assets/scenes");
  REQUIRE(entries.size() >= 8);
  CHECK(entries.front().file.stem() == "welcome");
  for (const GalleryEntry& e : entries) {
    CAPTURE(e.file);
    CHECK_FALSE(e.name.empty());
    CHECK_FALSE(e.about.empty());
    CHECK((e.dimension == 2 || e.dimension == 3));
  }
  CHECK(list_scenes(PUSHFORWARD_SOURCE "/no such folder").empty());
}
