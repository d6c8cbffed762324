// The tools that work on the material, by the mouse: what they do reaches the running simulation.
#include <cmath>

#include "tests/app/hand.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

Vec3 mean(const Snapshot& s) {
  Vec3 sum = Vec3::Zero();
  const auto d = static_cast<std::size_t>(s.dimension);
  for (std::size_t p = 0; p < s.particles; ++p)
    for (std::size_t a = 0; a < d; ++a) sum[static_cast<int>(a)] += s.x[d * p + a];
  return sum / static_cast<double>(s.particles);
}

void open(Stage& stage, const Scene& scene) {
  stage->open_scene(scene, {}, false);
  REQUIRE(stage.ready());
  stage->act(Action::fit);
  stage.frames(4);
}

}  // namespace

TEST_CASE("a click pins the material, another one lets it go, undo does too") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  for (const char* name : {"", "twisted-bar"}) {
    CAPTURE(name);
    open(stage, *name ? shipped(name) : small());
    AppContext& context = stage.context();
    context.tool = "pin";
    stage.frames(2);
    const std::size_t had = context.scene.constraints.size();
    const Point2 where = at(stage, mean(*context.snapshot));
    Hand hand(stage);
    hand.click(where);
    REQUIRE(context.scene.constraints.size() == had + 1);
    REQUIRE(applied(stage));
    CHECK_FALSE(context.status.edit.needs_reset);
    CHECK(context.snapshot->scene->regions.size() == had + 1);
    stage->act(Action::undo);
    REQUIRE(applied(stage));
    CHECK(context.scene.constraints.size() == had);
    CHECK_FALSE(context.status.edit.needs_reset);
    hand.click(where);
    REQUIRE(context.scene.constraints.size() == had + 1);
    hand.click(where);
    CHECK(context.scene.constraints.size() == had);
    REQUIRE(applied(stage));
    CHECK(context.snapshot->scene->regions.size() == had);
  }
}

TEST_CASE("a drag with push moves the material by a ball that is in no scene") {
  NEEDS_DISPLAY();
  Scene scene = small();
  scene.gravity = Vec3::Zero();
  scene.boundaries.clear();
  Stage stage(scene);
  REQUIRE(stage.ready());
  open(stage, scene);
  AppContext& context = stage.context();
  context.session.set_rate(0.2);
  context.tool = "push";
  stage.frames(2);
  stage->act(Action::run_pause);
  Hand hand(stage);
  hand.move(at(stage, {-0.55, 0.5, 0}));
  hand.press();
  REQUIRE(stage.until([&] { return context.snapshot->boundary_displacement.size() == 1; }));
  CHECK(context.scene.boundaries.empty());
  hand.move(at(stage, {-0.2, 0.5, 0}));
  CHECK(stage.until([&] {
    return context.snapshot->boundary_displacement.size() == 1 &&
           context.snapshot->boundary_displacement[0].x() > 0.1 && context.snapshot->report.balance.momentum.x() > 1;
  }));
  hand.release();
  CHECK(stage.until([&] { return context.snapshot->boundary_displacement.empty(); }));
  stage->act(Action::run_pause);
  CHECK(stage.until([&] { return context.status.state != RunState::running; }));
  CHECK(context.scene == scene);
  CHECK_FALSE(context.unsaved);
  CHECK_FALSE(context.session.recorded().events.empty());
  CHECK(context.session.recording_warning().empty());
}
