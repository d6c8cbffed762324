// What the user does while a scene is open reaches the simulation; what goes wrong is said and survived.
#include <imgui.h>

#include <algorithm>

#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "tests/app/stage.hpp"
#include "tests/panels/letters.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

/// Has something of every kind of setting.
Scene rich() {
  return parse_scene(R"({"name": "Rich", "dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.1},
      "body_force": ["0", "0"], "time": {"end": 5, "step": 0.005}, "transfer": {"type": "flip", "flip_ratio": 0.9},
      "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3},
                    "foam": {"model": "neo_hookean", "density": 100, "young": 1e4, "poisson": 0.2}},
      "bodies": [{"name": "ball", "material": "rubber", "shape": {"type": "ball", "center": [0, 0.5], "radius": 0.4}},
                 {"name": "box", "material": "foam", "shape": {"type": "box", "min": [1, 0.2], "max": [1.6, 0.8]}}],
      "boundaries": [{"shape": {"type": "half_space", "point": [0, 0], "normal": [0, 1]}, "friction": 0.2}],
      "constraints": [{"region": {"type": "box", "min": [1.5, 0], "max": [1.7, 1]}, "fix": [true, true]}]})",
                     "test");
}

double mean_height(const Snapshot& s, std::size_t body_particles) {
  double sum = 0;
  for (std::size_t p = 0; p < body_particles; ++p) sum += s.x[2 * p + 1];
  return sum / static_cast<double>(body_particles);
}

}  // namespace

TEST_CASE("an edit of each kind of setting is acknowledged in the next frame and reaches the running simulation") {
  NEEDS_DISPLAY();
  Stage stage(rich());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  stage->act(Action::run_pause);
  REQUIRE(stage.until([&] { return context.status.step > 1; }));
  const std::vector<Edit> edits{{"/materials/rubber/young", 2e5},
                                {"/solver/max_newton", 40},
                                {"/transfer/type", "apic"},
                                {"/gravity", {0, -1.5}},
                                {"/body_force", {"0", "0.1*sin(t)"}},
                                {"/constraints/0/fix", {true, false}},
                                {"/constraints/0/velocity", {"0.01*t", 0}},
                                {"/boundaries/0/contact", "slip"}};
  for (const Edit& edit : edits) {
    CAPTURE(edit.pointer);
    const std::uint64_t before = context.status.edit.edit;
    REQUIRE(context.change({edit}));
    stage.frames(1);
    CHECK(context.status.edit.edit == before + 1);
    REQUIRE(stage.until([&] { return context.status.edit.applies_at_step < 0; }));
    CHECK_FALSE(context.status.edit.needs_reset);
    const Scene recorded = context.session.recorded();
    const bool applied = std::any_of(recorded.events.begin(), recorded.events.end(), [&](const Event& e) {
      return std::any_of(e.set.begin(), e.set.end(),
                         [&](const Edit& s) { return s.pointer.starts_with(edit.pointer); });
    });
    CHECK(applied);
  }
  const long step = context.status.step;
  CHECK(stage.until([&] { return context.status.step > step + 2; }));  // it runs on with all of them
  CHECK(context.status.state == RunState::running);
}

TEST_CASE("what the mouse pulls follows it, and the force is told") {
  NEEDS_DISPLAY();
  Stage stage(rich());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  REQUIRE(context.change({{"/gravity", {0, 0}}}));
  std::size_t ball = 0;
  while (ball < context.snapshot->particles && context.snapshot->x[2 * ball] < 0.7) ++ball;
  REQUIRE(ball > 20);
  const double before = mean_height(*context.snapshot, ball);
  context.session.set_grab(Grab{{0, 0.5, 0}, {0, 1.5, 0}, 0.3});
  REQUIRE(stage.steps(20));
  CHECK(context.snapshot->grabbed);
  CHECK(context.snapshot->report.grab_force > 0);
  CHECK(context.snapshot->grab_at.y() > 0.5);
  CHECK(mean_height(*context.snapshot, ball) > before + 1e-3);
  context.session.set_grab(std::nullopt);
  REQUIRE(stage.steps(1));
  CHECK_FALSE(context.snapshot->grabbed);
  CHECK_FALSE(context.session.recording_warning().empty());
}

TEST_CASE("no text of the whole window lies over other text or is cut, at every scale, whatever is open") {
  NEEDS_DISPLAY();
  for (const float scale : {1.0f, 2.0f}) {
    Stage stage(rich(), false, scale);
    REQUIRE(stage.ready());
    REQUIRE(stage.steps(2));
    stage.frames(6);
    const Layout& layout = stage->layout();
    const Rect left = layout.left;
    int index = 0;
    for (const Panel& panel : panels()) {
      if (panel.dock != Dock::left) continue;
      CAPTURE(scale);
      CAPTURE(std::string(panel.title));
      memory(stage.context()).open_left = index++;
      for (int k = 0; k < 4; ++k) stage->act(Action::deselect), stage.frames(1);
      std::vector<Letter> found = letters(*ImGui::GetDrawData()), shown;
      CHECK(found.size() > 100);
      // Panels scroll, and what is scrolled out of sight is cut; texts over the view have a rim of their own colour.
      for (const Letter& l : found)
        if (!(l.cut && left.contains(l.min.x, l.min.y)) && !layout.view.contains(l.min.x, l.min.y)) shown.push_back(l);
      CHECK(overlaps(shown) == "");
      CHECK(cut_off(shown) == "");
    }
  }
}

TEST_CASE("a panel that throws does not end the program: the window says what went wrong and goes on") {
  NEEDS_DISPLAY();
  Stage stage(rich());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  const Scene good = context.scene;
  memory(context).open_left = 2;  // Time asks the law how fast waves are
  context.scene.materials[0].model = "no such law";
  stage->act(Action::deselect);
  CHECK(stage->frame(0));
  REQUIRE_FALSE(context.problems.empty());
  CHECK(context.problems[0].found.find("wrong") != std::string::npos);
  context.scene = good;
  const long drawn = stage->frames_drawn();
  stage.frames(5);
  CHECK(stage->frames_drawn() > drawn);
  REQUIRE(stage.steps(1));
}
