// Habits: find a scene by letters, the window within the screen, settings that can be forgotten.
#include <imgui.h>

#include <cstdlib>

#include "tests/app/hand.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

TEST_CASE("a few letters find a scene, recent files first") {
  const std::vector<SceneChoice> all{{"/a/my-bar.json", "my-bar", "/a"},
                                     {"/s/drooping-cantilever.json", "Drooping cantilever", ""},
                                     {"/s/vibrating-bar.json", "Vibrating bar", ""},
                                     {"/s/twisted-bar.json", "Twisted bar", ""}};
  CHECK(matching(all, "").size() == 4);
  CHECK(matching(all, "").front().name == "my-bar");
  REQUIRE(matching(all, "twb").size() == 1);
  CHECK(matching(all, "twb")[0].name == "Twisted bar");
  CHECK(matching(all, "DC")[0].name == "Drooping cantilever");
  CHECK(matching(all, "bar").size() == 3);
  CHECK(matching(all, "xyz").empty());
}

TEST_CASE("Ctrl+O offers the scenes; unsaved changes are asked about first") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  stage->act(Action::open);
  stage.frames(4);
  CHECK(stage->scene_picker().is_open());
  CHECK(stage->scene_picker().offered().size() >= 8);
  if (const char* folder = std::getenv("PUSHFORWARD_SCREENSHOTS"))
    write_png(stage->screenshot(), fs::path(folder) / "picker.png", {});
  Hand hand(stage);
  // The second row of its list, at the width's middle.
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  hand.click({display.x / 2, 0.12F * display.y + 5.2F * ImGui::GetFontSize()});
  REQUIRE(stage.until([&] { return !stage->scene_picker().is_open(); }));
  REQUIRE(stage.until([&] { return stage.context().scene.name != "Small ball"; }));
  REQUIRE(stage.ready());

  REQUIRE(stage.context().change({{"/time/end", 7}}));
  stage->act(Action::open);
  stage.frames(4);
  CHECK_FALSE(stage->scene_picker().is_open());
}

TEST_CASE("a window that was larger than the screen is clamped to it") {
  NEEDS_DISPLAY();
  const test::TemporaryFolder folder;
  Preferences wide;
  wide.window_width = 30000;
  wide.window_height = 20000;
  Workbench::Setup setup;
  setup.visible = false;
  setup.run = false;
  setup.folders = {folder.path() / "config", folder.path() / "state"};
  save_preferences(wide, setup.folders);
  Workbench bench(small(), {}, setup);
  bench.frame(0.01);
  CHECK(bench.screenshot().width <= 7680);
  CHECK(bench.screenshot().height <= 4320);
}

TEST_CASE("forgotten settings are the defaults") {
  const test::TemporaryFolder folder;
  const PreferenceFolders folders{folder.path() / "config", folder.path() / "state"};
  Preferences p;
  p.theme = Theme::light;
  p.recent = {"/a/b.json"};
  save_preferences(p, folders);
  forget_preferences(folders);
  CHECK(load_preferences(folders) == Preferences{});
  forget_preferences(folders);  // once more does no harm
}
