#include "app/preferences.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

#include "tests/temporary_folder.hpp"

using namespace pf::app;
namespace fs = std::filesystem;

namespace {

struct Scratch {
  pf::test::TemporaryFolder scratch;
  const fs::path& folder = scratch.path();
  PreferenceFolders folders{folder / "config", folder / "state"};
};

}  // namespace

TEST_CASE("preferences come back as they were saved, and nothing else is left in the folders") {
  const Scratch scratch;
  CHECK(load_preferences(scratch.folders) == Preferences{});
  Preferences p;
  p.theme = Theme::light;
  p.ui_scale = 1.25f;
  p.window_width = 1600;
  p.window_height = 900;
  p.maximized = p.drawer_open = true;
  p.drawer_height = 20;
  p.rewind_megabytes = 2048;
  p.recent = {"/a/b.json", "/c/d e.json"};
  save_preferences(p, scratch.folders);
  CHECK(load_preferences(scratch.folders) == p);
  CHECK(std::distance(fs::directory_iterator(scratch.folders.config), {}) == 1);
  CHECK(std::distance(fs::directory_iterator(scratch.folders.state), {}) == 1);
}

TEST_CASE("a damaged or hostile file keeps the defaults") {
  const Scratch scratch;
  fs::create_directories(scratch.folders.config);
  fs::create_directories(scratch.folders.state);
  for (const char* text :
       {"", "{", "[]", "7", R"({"theme": 3, "ui_scale": 1e308, "window_width": -1, "maximized": "yes"})", "\xff\xfe"}) {
    std::ofstream(scratch.folders.config / "preferences.json") << text;
    std::ofstream(scratch.folders.state / "recent.json") << text;
    CHECK(load_preferences(scratch.folders) == Preferences{});
  }
}

TEST_CASE("recent files: newest first, each once, ten at most") {
  Preferences p;
  for (int i = 0; i < 15; ++i) note_recent(p, "/scenes/" + std::to_string(i) + ".json");
  note_recent(p, "/scenes/../scenes/9.json");
  REQUIRE(p.recent.size() == most_recent_files);
  CHECK(p.recent[0] == "/scenes/9.json");
  CHECK(p.recent[1] == "/scenes/14.json");
  CHECK(std::count(p.recent.begin(), p.recent.end(), fs::path("/scenes/9.json")) == 1);
}

TEST_CASE("folders follow the XDG variables when they are absolute") {
  setenv("XDG_CONFIG_HOME", "/tmp/xc", 1);
  setenv("XDG_STATE_HOME", "relative", 1);
  setenv("HOME", "/home/somebody", 1);
  CHECK(default_folders().config == "/tmp/xc/pushforward");
  CHECK(default_folders().state == "/home/somebody/.local/state/pushforward");
  unsetenv("XDG_CONFIG_HOME");
  CHECK(default_folders().config == "/home/somebody/.config/pushforward");
}
