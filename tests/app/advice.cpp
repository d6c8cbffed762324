// Advice in the window: measured beside the run, followed by one click, taken back by another.
#include "app/advice/desk.hpp"

#include <imgui.h>

#include "app/advice/words.hpp"
#include "tests/app/find_text.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

/// A ball in steps far shorter than its grid is exact.
Scene cautious() {
  return edited(small(), std::vector<Edit>{{"/time/step", 2e-5}});
}

struct Advised : Stage {
  Advised() : Stage(cautious(), false, 1, true) {
    REQUIRE(ready());
    REQUIRE(steps(2));
    context().show_plot("Advice");
    frames(4);
  }
  AdviceDesk& desk() { return advice_of(context()); }
  void measure() {
    press(desk().report() ? "Measure again" : "Measure");
    REQUIRE(desk().busy());
    REQUIRE(until([&] { return !desk().busy(); }));
    CHECK(desk().failure().empty());
    REQUIRE(desk().report());
    REQUIRE(until([] { return find_text("Measure again").has_value(); }));
  }
  /// A button, once it is to be seen.
  void press(const char* words) {
    bench->act(Action::fit);
    REQUIRE(until([&] { return find_text(words).has_value(); }));
    click_text(*this, words);
  }
};

}  // namespace

TEST_CASE("advice: one click measures, one follows it, one takes it back") {
  NEEDS_DISPLAY();
  Advised stage;
  AppContext& context = stage.context();
  const Scene before = context.scene;
  const auto state = context.snapshot;
  stage.measure();
  CHECK(context.snapshot == state);  // the run was not touched
  CHECK(context.scene == before);
  const AdviceReport& report = *stage.desk().report();
  REQUIRE_FALSE(report.advice.empty());
  const Trial& best = report.trials[report.advice.front()];
  CHECK(stage.desk().use_of(context, best) == AdviceDesk::Use::offered);
  CHECK(stage.until([] { return find_text("Worth doing").has_value(); }));
  stage.press("Apply");
  REQUIRE(applied(stage));
  CHECK(context.scene == edited(before, best.edits));
  CHECK(stage.desk().use_of(context, best) == AdviceDesk::Use::taken);
  REQUIRE(stage.steps(1));
  CHECK_FALSE(stage.context().status.state == RunState::failed);
  stage.press("Take back");
  REQUIRE(applied(stage));
  CHECK(context.scene == before);
  // Undo and redo know each click as one.
  stage.press("Apply");
  REQUIRE(applied(stage));
  key(stage, Action::undo);
  CHECK(context.scene == before);
  // Another edit makes it stale; what it was measured for brings it back.
  REQUIRE(context.change({{"/gravity", {0, -1}}}));
  CHECK(stage.desk().use_of(context, best) == AdviceDesk::Use::stale);
  REQUIRE(context.change({{"/view/color_by", "J"}}));
  key(stage, Action::undo);
  key(stage, Action::undo);
  CHECK(stage.desk().use_of(context, best) == AdviceDesk::Use::offered);
}

TEST_CASE("advice: goes on beside a running simulation, and is given up by its button or with the window") {
  NEEDS_DISPLAY();
  Advised stage;
  stage->act(Action::run_pause);
  stage.press("Measure");
  const long step = stage.context().status.step;
  CHECK(stage.until([&] { return stage.context().status.step > step + 3; }));
  stage.frames(2);
  if (stage.desk().busy()) {
    stage.desk().cancel();
    CHECK_FALSE(stage.desk().busy());
    CHECK(stage.desk().report() == nullptr);
  }
  stage.frames(2);
  stage.measure();
  CHECK(stage.desk().report()->time >= stage.context().scene.time.step * static_cast<double>(step));
  stage.desk().ask(stage.context());
  stage.frames(3);  // closing the window in the midst of it must neither hang nor crash
}
