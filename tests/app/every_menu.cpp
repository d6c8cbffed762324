// The menus, dialogs and messages of the window, to be looked at one by one as those of every_view.cpp:
//   PUSHFORWARD_SCREENS=DIR ./test.sh -R 'pictures of'
#include <imgui.h>

#include <fstream>

#include "tests/app/shot.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

void menu(Shot& s, const char* title, const char* below = nullptr) {
  s.show("drooping-cantilever", 12);
  click_menu(s, title);
  s.frames(3);
  if (below == nullptr) return;
  const auto where = find_whole_text(below);
  REQUIRE(where);
  s.hand.click(*where);
  s.frames(3);
}

/// A file of the scratch folder that is no good scene.
fs::path bad_scene(Shot& s) {
  const fs::path file = s.folder / "bad-scene.json";
  std::ofstream(file)
      << R"({"name": "Bad", "dimension": 2, "gravity": [0, -9.81, 1], "grid": {"spacing": -0.1, "spacin": 1},
      "time": {"end": 1, "step": "fast"}, "materials": {"rubber": {"model": "neo_hookaen", "density": 1000}},
      "bodies": [{"material": "steel", "shape": {"type": "ball", "center": [0, 0.5], "radius": 0.4}}]})";
  return file;
}

const std::vector<WindowView>& views() {
  static const std::vector<WindowView> table{
      {"menu-file", [](Shot& s) { menu(s, "File"); }},
      {"menu-recent",
       [](Shot& s) {
         for (const char* name : {"first try.json", "a beam that is held at both of its ends.json"}) {
           save_scene(small(), s.folder / name);
           s.bench->open_scene(small(), s.folder / name, false);
           s.ready();
         }
         menu(s, "File", "Open recent");
       }},
      {"menu-edit", [](Shot& s) { menu(s, "Edit"); }},
      {"menu-run", [](Shot& s) { menu(s, "Run"); }},
      {"menu-memory", [](Shot& s) { menu(s, "Run", "Memory for going back"); }},
      {"menu-view", [](Shot& s) { menu(s, "View"); }},
      {"menu-theme", [](Shot& s) { menu(s, "View", "Theme"); }},
      {"menu-size", [](Shot& s) { menu(s, "View", "Size of text and controls"); }},
      {"menu-lessons", [](Shot& s) { menu(s, "Help", "Lessons"); }},
      {"menu-speed",
       [](Shot& s) {
         s.show("drooping-cantilever", 12);
         s.tap("Real time");
       }},
      {"menu-color-bar",
       [](Shot& s) {
         s.show("drooping-cantilever", 12);
         const auto ends = s.bench->view().color_bar().ends();
         REQUIRE(ends);
         s.hand.click({(ends->first.x + ends->second.x) / 2, (ends->first.y + ends->second.y) / 2}, 1);
         s.frames(3);
       }},
      {"tool-help",
       [](Shot& s) {
         s.show("drooping-cantilever", 12);
         const auto where = find_whole_text("Grab");
         REQUIRE(where);
         s.hand.move(*where);
         s.frames(30);
       }},
      {"time-line-help",
       [](Shot& s) {
         s.show("drooping-cantilever", 40);
         const Rect& bar = s.bench->layout().transport;
         s.hand.move({bar.x + 0.1F * bar.width, bar.y + 0.5F * s.bench->layout().time_line});
         s.frames(10);
       }},
      {"help",
       [](Shot& s) {
         s.show("welcome", 2);
         s.bench->act(Action::help);
       }},
      {"about",
       [](Shot& s) {
         menu(s, "Help", "About Pushforward");
         s.rest();
       }},
      {"picker",
       [](Shot& s) {
         s.show("welcome", 2);
         s.bench->act(Action::open);
       }},
      {"picker-letters",
       [](Shot& s) {
         s.show("welcome", 2);
         s.bench->act(Action::open);
         s.frames(4);
         for (const char c : {'b', 'a', 'r'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
         s.frames(3);
       }},
      {"file-open",
       [](Shot& s) {
         s.show("welcome", 2);
         FileDialog::Request request;
         request.title = "Open scene";
         request.start = asset_path("scenes");
         request.places = {asset_path("scenes"), s.folder};
         request.done = [](const fs::path&) {};
         s.context().ask_file(request);
       }},
      {"file-save",
       [](Shot& s) {
         s.show("welcome", 2);
         s.bench->act(Action::save_as);
       }},
      {"unsaved",
       [](Shot& s) {
         s.show("welcome", 2);
         s.context().change({{"/gravity", {0, -5}}});
         s.context().settle_changes([] {});
       }},
      {"bad-scene", [](Shot& s) { s.context().open_file(bad_scene(s)); }, true, true},
      {"bad-file", [](Shot& s) { s.context().open_file(s.folder / "is-not-there.json"); }, true, true},
      {"notice",
       [](Shot& s) {
         s.show("welcome", 10);
         s.context().notify("Saved " + (s.folder / "pictures/welcome.png").string());
         s.context().notify("Coloured by material, so that what is painted shows.");
       }},
  };
  return table;
}

}  // namespace

TEST_CASE("pictures of every menu and dialog") {
  NEEDS_DISPLAY();
  take_pictures(views(), "menu-edit");
}
