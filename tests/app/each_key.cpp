// Each key, pressed, does what the sheet under F1 says of it.
#include <imgui.h>

#include <map>

#include "app/inside/step_player.hpp"
#include "app/keys.hpp"
#include "core/diagnostics/fields.hpp"
#include "tests/app/find_text.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

struct Keyed : Stage {
  using Stage::Stage;
  void press(Action action, int index = 0) {
    const KeyBinding& b = binding(action);
    REQUIRE(b.key != 0);
    bench->feed_key(b.key + index, b.mods);
    frames(3);
  }
  bool says(const char* words) {
    return until([&] { return find_text(words).has_value(); });
  }
  bool pictures(std::size_t count) {
    return until([&] {
      std::size_t found = 0;
      for (const auto& entry : fs::directory_iterator(folder / "pictures"))
        found += entry.path().extension() == ".png" ? 1 : 0;
      return found == count;
    });
  }
};

using Check = void (*)(Keyed&, Action);

template <bool ViewState::*shown>
void toggles(Keyed& stage, Action action) {
  ViewState& view = stage.context().view;
  const bool before = view.*shown;
  stage.press(action);
  CHECK(view.*shown != before);
  stage.press(action);
  CHECK(view.*shown == before);
}

/// One for every action that has a key; `nullptr` where pressing it here would disturb the person at the machine.
const std::map<Action, Check>& checks() {
  static const std::map<Action, Check> table{
      {Action::open,
       [](Keyed& s, Action a) {
         s.press(a);
         CHECK(s.says("Cancel"));
         s.press(Action::deselect);
       }},
      {Action::save,
       [](Keyed& s, Action a) {
         const fs::path file = s.folder / "saved.json";
         save_scene(s.context().scene, file);
         s.context().scene_file = file;
         REQUIRE(s.context().change({{"/gravity", {0, -5}}}));
         s.press(a);
         CHECK(load_scene(file).gravity.y() == -5);
         CHECK_FALSE(s.context().unsaved);
       }},
      {Action::save_as,
       [](Keyed& s, Action a) {
         s.press(a);
         CHECK(s.says("Cancel"));
         s.press(Action::deselect);
       }},
      {Action::picture,
       [](Keyed& s, Action a) {
         s.press(a);
         CHECK(s.pictures(1));
       }},
      {Action::picture_window,
       [](Keyed& s, Action a) {
         s.press(a);
         CHECK(s.pictures(1));
       }},
      {Action::record,
       [](Keyed& s, Action a) {
         s.press(a);
         CHECK(s.says("Record"));
         s.press(Action::deselect);
       }},
      {Action::undo,
       [](Keyed& s, Action a) {
         const Scene before = s.context().scene;
         REQUIRE(s.context().change({{"/gravity", {0, -3}}}));
         s.press(a);
         CHECK(s.context().scene == before);
       }},
      {Action::redo,
       [](Keyed& s, Action a) {
         REQUIRE(s.context().change({{"/gravity", {0, -3}}}));
         s.press(Action::undo);
         CHECK(s.context().scene.gravity.y() != -3);
         s.press(a);
         CHECK(s.context().scene.gravity.y() == -3);
       }},
      {Action::run_pause,
       [](Keyed& s, Action a) {
         s.press(a);
         CHECK(s.until([&] { return s.context().status.step > 2; }));
         s.press(a);
         CHECK(s.until([&] { return s.context().status.state == RunState::paused; }));
       }},
      {Action::step,
       [](Keyed& s, Action a) {
         const long step = s.context().status.step;
         s.press(a);
         CHECK(s.until([&] { return s.context().status.step == step + 1; }));
       }},
      {Action::slow_step,
       [](Keyed& s, Action a) {
         s.press(a);
         CHECK(s.until([&] { return s.context().slow != nullptr; }));
         s.press(Action::deselect);
         CHECK(s.until([&] { return s.context().slow == nullptr; }));
       }},
      {Action::step_back,
       [](Keyed& s, Action a) {
         REQUIRE(s.steps(2));
         const long step = s.context().status.step;
         s.press(a);
         CHECK(s.until([&] { return s.context().status.step == step - 1; }));
       }},
      {Action::bad_step,
       [](Keyed& s, Action a) {
         // No bad step here: the key leaves the run where it is.
         REQUIRE(s.steps(1));
         const long step = s.context().status.step;
         s.press(a);
         CHECK(s.context().status.step == step);
       }},
      {Action::reset,
       [](Keyed& s, Action a) {
         REQUIRE(s.steps(2));
         s.press(a);
         CHECK(s.until([&] { return s.context().status.step == 0 && s.context().status.state == RunState::paused; }));
       }},
      {Action::fit,
       [](Keyed& s, Action a) {
         s.press(a);
         const auto home = s->view().to_window(Vec3(0, 0.5, 0));
         Hand hand(s);
         hand.move(*home);
         hand.wheel(5);
         s.frames(30);
         const auto nearer = s->view().to_window(Vec3(0.3, 0.5, 0));
         s.press(a);
         s.frames(30);
         const auto again = s->view().to_window(Vec3(0.3, 0.5, 0));
         REQUIRE(home);
         REQUIRE(again);
         CHECK((!nearer || std::abs(nearer->x - again->x) > 2));
       }},
      {Action::grid, toggles<&ViewState::show_grid>},
      {Action::vectors, toggles<&ViewState::show_velocities>},
      {Action::crosses, toggles<&ViewState::show_crosses>},
      {Action::shapes, toggles<&ViewState::show_shapes>},
      {Action::hide_panels, toggles<&ViewState::hide_panels>},
      {Action::field,
       [](Keyed& s, Action a) {
         for (const int index : {1, 3}) {
           s.press(a, index);
           CHECK(s.context().view.field == fields()[static_cast<std::size_t>(index)].field);
         }
       }},
      {Action::full_screen, nullptr},
      {Action::help,
       [](Keyed& s, Action a) {
         s.press(a);
         CHECK(s.says("Keys and mouse"));
         s.press(Action::deselect);
       }},
      {Action::deselect,
       [](Keyed& s, Action a) {
         s.context().selected_particle = 0;
         s.press(a);
         CHECK_FALSE(s.context().selected_particle.has_value());
       }},
  };
  return table;
}

}  // namespace

TEST_CASE("each key does what the sheet says") {
  NEEDS_DISPLAY();
  for (const KeyBinding& b : key_bindings()) {
    if (b.key == 0) continue;
    CAPTURE(b.label);
    const auto check = checks().find(b.action);
    REQUIRE_MESSAGE(check != checks().end(), "a key without a test");
    if (check->second == nullptr) continue;
    Keyed stage(small());
    REQUIRE(stage.ready());
    check->second(stage, b.action);
  }
}
