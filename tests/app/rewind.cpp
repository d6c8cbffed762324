// The time line in the window: drag, keys, bad steps, another branch.
#include <cstdlib>

#include "core/charts/image.hpp"
#include "tests/app/hand.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

/// Falls, and is for a moment pulled by far more than steps of this length can follow.
Scene troubled() {
  return parse_scene(R"({"name": "Troubled", "dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.1},
      "time": {"end": 0.4, "step": 0.01}, "solver": {"max_newton": 6}, "body_force": ["0", "t > 0.2 && t < 0.215 ? -3e5 : 0"],
      "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
      "bodies": [{"name": "ball", "material": "rubber", "shape": {"type": "ball", "center": [0, 0.5], "radius": 0.4}}],
      "boundaries": [{"shape": {"type": "half_space", "point": [0, 0], "normal": [0, 1]}, "contact": "stick"}]})",
                     "test");
}

bool settled(Stage& stage) {
  stage.frames(1);
  return stage.until([&] {
    const SessionStatus& s = stage.context().status;
    return s.target < 0 && !s.step_in_flight && stage.context().snapshot->report.step == s.step;
  });
}

Point2 on_line(Stage& stage, double part) {
  const Rect& bar = stage->layout().transport;
  const float em = 15, left = bar.x + 0.9F * em, width = bar.width - 1.8F * em;
  return {left + static_cast<float>(part) * width, bar.y + 0.5F * stage->layout().time_line};
}

}  // namespace

TEST_CASE("a drag on the time line goes back to what was, and an edit there begins another branch") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  context.session.set_rate(0);
  REQUIRE(stage.steps(40));  // of 200
  const Snapshot newest = *context.snapshot;
  Hand hand(stage);
  hand.drag(on_line(stage, 0.2), on_line(stage, 0.1));
  REQUIRE(settled(stage));
  CHECK(context.status.step == 20);
  CHECK(context.status.reached == 40);
  CHECK(context.current.reports.size() == 41);
  CHECK(context.snapshot->report.time == doctest::Approx(0.1));
  CHECK(context.snapshot->report.dt == doctest::Approx(0.005));
  CHECK_FALSE(context.snapshot->report.newton.empty());  // the whole report, not only a state
  stage->act(Action::step_back);
  REQUIRE(settled(stage));
  CHECK(context.status.step == 19);
  // Beyond what was simulated there is nothing to go to.
  hand.click(on_line(stage, 0.9));
  REQUIRE(settled(stage));
  CHECK(context.status.step == 40);
  CHECK(context.snapshot->x == newest.x);
  CHECK(context.snapshot->F == newest.F);

  hand.click(on_line(stage, 0.05));
  REQUIRE(settled(stage));
  CHECK(context.status.step == 10);
  CHECK(stage->possible(Action::branch));
  CHECK(context.pinned.empty());
  REQUIRE(context.change({{"/materials/rubber/young", 2e4}}));
  REQUIRE(stage.until([&] { return context.status.branches == 1; }));
  stage.frames(2);
  CHECK(context.current.reports.size() == 11);
  CHECK_FALSE(stage->possible(Action::branch));
  REQUIRE(context.pinned.size() == 1);  // what would have come stays in sight
  CHECK(context.pinned[0].reports.size() == 41);
  REQUIRE(stage.steps(5));
  CHECK(context.current.reports.size() == 16);
  CHECK(context.current.reports.back().balance.total() != context.pinned[0].reports[15].balance.total());
}

TEST_CASE("a window on a past state at rest draws nothing") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  REQUIRE(stage.steps(12));
  stage.context().session.go_to(5);
  REQUIRE(settled(stage));
  for (int i = 0; i < 40; ++i) stage->frame(0.02);
  const long before = stage->frames_drawn();
  for (int i = 0; i < 20; ++i) stage->frame(0.02);
  CHECK(stage->frames_drawn() == before);
}

TEST_CASE("bad steps are marked, and one key goes from one to the next") {
  NEEDS_DISPLAY();
  Stage stage(troubled());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  CHECK_FALSE(stage->possible(Action::bad_step));
  context.session.set_rate(0);
  stage->act(Action::run_pause);
  REQUIRE(stage.until(
      [&] { return context.status.state == RunState::finished || context.status.state == RunState::failed; }));
  stage.frames(3);
  REQUIRE_FALSE(stage->time_line().bad_steps().empty());
  const long first = stage->time_line().bad_steps().front().step;
  CHECK(first >= 20);
  CHECK(first <= 30);
  stage->act(Action::bad_step);
  REQUIRE(settled(stage));
  CHECK(context.status.step == first);
  if (stage->time_line().bad_steps().size() > 1) {
    stage->act(Action::bad_step);
    REQUIRE(settled(stage));
    CHECK(context.status.step == stage->time_line().bad_steps()[1].step);
  }
  if (const char* folder = std::getenv("PUSHFORWARD_SCREENSHOTS")) {
    stage.frames(5);
    write_png(stage->screenshot(), fs::path(folder) / "time-line.png", {});
  }
}
