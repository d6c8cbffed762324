// Comparing runs in the window: lanes by one click, all driven by the same keys, the picture theirs.
#include <imgui.h>

#include <cmath>

#include "app/compare/desk.hpp"
#include "app/compare/followed.hpp"
#include "app/compare/lane_views.hpp"
#include "tests/app/hand.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

bool stands(Stage& stage, long frame) {
  return stage.until([&] {
    const CompareDesk& desk = *stage.context().compare;
    return desk.frame && desk.status.frame == frame && desk.status.state != CompareState::running &&
           desk.frame->lanes.front().snapshot == stage.context().snapshot &&
           std::abs(desk.frame->time - desk.status.time) < 1e-12;
  });
}

/// A lane with another step, at t = 0.
CompareDesk& started(Stage& stage) {
  CompareDesk& desk = compare_of(stage.context());
  REQUIRE(desk.add(stage.context(), "/time/step", 0.0025));
  desk.comparison.pause();
  desk.comparison.reset();
  REQUIRE(stands(stage, 0));
  return desk;
}

}  // namespace

TEST_CASE("a lane comes by one click, goes by another, and the run is there again") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  REQUIRE(stage.steps(4));
  AppContext& context = stage.context();
  stage->act(Action::fit);
  stage.frames(3);
  const auto before = context.snapshot;
  CompareDesk& desk = started(stage);
  CHECK(desk.lanes.size() == 2);
  CHECK(desk.lanes[1].name.find("2.5 ms") != std::string::npos);
  CHECK(desk.frame->lanes.size() == 2);
  REQUIRE(desk.add(context, "/transfer/type", "pic"));
  CHECK(stage.until([&] { return desk.frame && desk.frame->lanes.size() == 3; }));
  // The same again, an unfit value, and more than four are refused with a reason.
  CHECK_FALSE(desk.add(context, "/transfer/type", "pic"));
  CHECK_FALSE(desk.refusal.empty());
  CHECK_FALSE(desk.add(context, "/time/step", -1));
  REQUIRE(desk.add(context, "/grid/basis", "linear"));
  CHECK_FALSE(desk.add(context, "/grid/basis", "cubic"));
  CHECK(desk.lanes.size() == 4);
  desk.remove(context, 3);
  desk.remove(context, 2);
  CHECK(comparing(context));
  desk.remove(context, 1);
  CHECK_FALSE(comparing(context));
  stage.frames(2);
  CHECK(context.snapshot->report.step == 4);
  CHECK(context.snapshot == before);
  CHECK(context.status.state == RunState::paused);
}

TEST_CASE("a particle that is clicked in one lane is followed in all of them") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  stage->act(Action::fit);
  CompareDesk& desk = started(stage);
  AppContext& context = stage.context();
  for (long k = 1; k <= 6; ++k) {
    stage->act(Action::step);
    REQUIRE(stands(stage, k));
  }
  stage.frames(3);
  // The second lane's, which is not where the first one has it.
  const Snapshot& second = *desk.frame->lanes[1].snapshot;
  const std::size_t p = second.particles / 2;
  const Vec3 where(second.x[2 * p], second.x[2 * p + 1], 0);
  const Rect cell = stage->lane_views()->cells()[1];
  Hand hand(stage);
  hand.move({cell.x + cell.width / 2, cell.y + cell.height / 2});
  hand.click(at(stage, where));
  REQUIRE(context.selected_particle);
  CHECK(*context.selected_particle == second.id[p]);
  const auto lanes = followed(*desk.frame, *context.selected_particle, Field::speed);
  REQUIRE(lanes.size() == 2);
  REQUIRE((lanes[0] && lanes[1]));
  CHECK(lanes[1]->x.head<2>() == where.head<2>());
  CHECK_FALSE(lanes[0]->apart);
  CHECK(*lanes[1]->apart == doctest::Approx((lanes[1]->x - lanes[0]->x).norm()));
  CHECK(*lanes[1]->apart > 0);
  CHECK(lanes[1]->J == doctest::Approx(1).epsilon(0.2));
  CHECK(lanes[1]->value);
  hand.click({cell.x + 4, cell.bottom() - 4});  // beside the material: none
  CHECK_FALSE(context.selected_particle);
}

TEST_CASE("keys drive all lanes in step, and what has no meaning for several is not offered") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  CompareDesk& desk = started(stage);
  for (long k = 1; k <= 3; ++k) {
    stage->act(Action::step);
    REQUIRE(stands(stage, k));
  }
  for (const LaneFrame& lane : desk.frame->lanes) CHECK(lane.snapshot->report.time == doctest::Approx(0.015));
  CHECK(desk.frame->lanes[1].steps == 6);
  REQUIRE(desk.frame->lanes[1].distance);
  CHECK(desk.frame->lanes[1].distance->rms > 0);
  CHECK(desk.curves[0].time.size() == 1 + 3);
  CHECK(desk.curves[1].step_time.size() == 6);
  CHECK(desk.curves[1].rms.size() == 1 + 3);
  for (const Action action : {Action::step_back, Action::bad_step, Action::branch, Action::slow_step})
    CHECK_FALSE(stage->possible(action));
  stage->act(Action::run_pause);
  CHECK(stage.until([&] { return desk.status.state == CompareState::running && desk.status.frame > 6; }));
  stage->act(Action::run_pause);
  CHECK(stage.until([&] { return desk.status.state == CompareState::paused; }));
  stage->act(Action::reset);
  CHECK(stands(stage, 0));
  CHECK(desk.curves[0].step_time.empty());
}

TEST_CASE("an edit while comparing reaches all lanes, undo too, and the scene saved is the shared one") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  CompareDesk& desk = started(stage);
  AppContext& context = stage.context();
  stage->act(Action::step);
  REQUIRE(stands(stage, 1));
  REQUIRE(context.change({{"/gravity/1", 5.0}}));
  CHECK(context.scene.time.step == 0.005);
  const Scene own = CompareDesk::scene_of(context, desk.lanes[1]);
  CHECK(own.time.step == 0.0025);
  CHECK(own.gravity.y() == 5);
  const auto height = [&](std::size_t lane) {
    double sum = 0;
    const Snapshot& s = *desk.frame->lanes[lane].snapshot;
    for (std::size_t p = 0; p < s.particles; ++p) sum += s.x[2 * p + 1];
    return sum / static_cast<double>(s.particles);
  };
  for (long k = 2; k <= 10; ++k) {
    stage->act(Action::step);
    REQUIRE(stands(stage, k));
  }
  CHECK(height(0) > 0.5);  // it falls upwards
  CHECK(height(1) > 0.5);
  stage->act(Action::undo);
  CHECK(context.scene.gravity.y() == doctest::Approx(-9.81));
  // The lane's own setting, changed for all: the lane keeps its own.
  REQUIRE(context.change({{"/time/step", 0.01}}));
  stage->act(Action::reset);
  REQUIRE(stands(stage, 0));
  CHECK(stage.until([&] { return std::abs(desk.status.interval - 0.01) < 1e-12; }));
  stage->act(Action::step);
  REQUIRE(stands(stage, 1));
  CHECK(desk.frame->lanes[0].steps == 1);
  CHECK(desk.frame->lanes[1].steps == 4);
}

TEST_CASE("lanes lie side by side through one camera, and the mouse moves it for all") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  CompareDesk& desk = started(stage);
  stage.frames(4);
  const Rect view = stage->layout().view;
  for (std::size_t n = 2; n <= most_lanes; ++n)
    for (const float aspect : {0.2F, 1.0F, 5.0F}) {
      const auto cells = lane_cells(view, n, aspect);
      REQUIRE(cells.size() == n);
      for (std::size_t a = 0; a < n; ++a) {
        CHECK(cells[a].x >= view.x);
        CHECK(cells[a].right() <= view.right() + 0.5F);
        CHECK(cells[a].bottom() <= view.bottom() + 0.5F);
        for (std::size_t b = 0; b < a; ++b) CHECK((cells[a].x >= cells[b].right() || cells[a].y >= cells[b].bottom()));
      }
    }
  const Camera before = stage->view().camera();
  const auto cells = lane_cells(view, 2, 1);
  Hand hand(stage);
  const Point2 middle{cells[1].x + cells[1].width / 2, cells[1].y + cells[1].height / 2};
  hand.drag(middle, {middle.x + 40, middle.y + 20});
  CHECK_FALSE(stage->view().camera() == before);
  CHECK(desk.active());
  CHECK_FALSE(stage.context().session.status().step_in_flight);
  const Image picture = stage.picture();
  CHECK(picture.width >= 1500);
  // Both lanes are in it.
  for (const double half : {0.25, 0.75}) {
    bool drawn = false;
    const int x = static_cast<int>(half * picture.width);
    for (int y = 0; y < picture.height; ++y) drawn |= picture.at(x, y)[0] > 120 || picture.at(x, y)[2] > 120;
    CHECK(drawn);
  }
}

TEST_CASE("opening another scene ends the comparison") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  started(stage);
  Scene other = small();
  other.name = "Another";
  stage->open_scene(other, {}, false);
  REQUIRE(stage.ready());
  CHECK_FALSE(comparing(stage.context()));
  REQUIRE(stage.steps(2));
  CHECK(stage.context().snapshot->report.step == 2);
}
