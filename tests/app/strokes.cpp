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

TEST_CASE("a drag with cut takes the material under it out of the running simulation, undo puts it back") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  for (const char* name : {"", "twisted-bar"}) {
    CAPTURE(name);
    open(stage, *name ? shipped(name) : small());
    AppContext& context = stage.context();
    context.tool = "cut";
    stage.frames(2);
    const Scene before = context.scene;
    const std::size_t all = context.snapshot->particles;
    const Vec3 middle = mean(*context.snapshot);
    const double dx = context.snapshot->spacing;
    Hand hand(stage);
    hand.drag(at(stage, middle), at(stage, middle + Vec3(0, 2 * dx, 0)));
    REQUIRE(stage.until([&] { return context.snapshot->report.strokes.cut > 0; }));
    CHECK(stage.until([&] { return context.snapshot->particles == all - context.snapshot->report.strokes.cut; }));
    CHECK(context.snapshot->report.strokes.mass > 0);
    CHECK(context.scene == before);  // what is edited is the scene at its start
    const Vec3 gone = middle + Vec3(0, dx, 0);
    bool empty = true;
    const auto d = static_cast<std::size_t>(context.scene.dimension);
    for (std::size_t p = 0; p < context.snapshot->particles; ++p) {
      double apart = 0;
      for (std::size_t a = 0; a < d; ++a)
        apart += std::pow(context.snapshot->x[d * p + a] - gone[static_cast<int>(a)], 2);
      empty = empty && apart > 0.25 * dx * dx;
    }
    CHECK(empty);
    const std::vector<double> left = context.snapshot->x;
    REQUIRE(stage->possible(Action::undo));
    CHECK_FALSE(stage->possible(Action::redo));
    stage->act(Action::undo);
    CHECK(stage.until([&] { return context.snapshot->particles == all; }));
    CHECK(context.snapshot->report.strokes.count == 0);
    stage.frames(1);
    REQUIRE(stage->possible(Action::redo));
    stage->act(Action::redo);
    CHECK(stage.until([&] { return context.snapshot->x == left; }));
    CHECK(context.status.stroke_is_newest);
  }
}

TEST_CASE("a drag with paint gives the material under it the chosen one, shown in its colour") {
  NEEDS_DISPLAY();
  Scene scene = small();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name = "lead";
  scene.materials[1].density = 4000;
  Stage stage(scene);
  REQUIRE(stage.ready());
  open(stage, scene);
  AppContext& context = stage.context();
  context.tool = "paint";
  context.view.field = Field::speed;
  stage.frames(2);
  Hand hand(stage);
  hand.drag(at(stage, {-0.1, 0.5, 0}), at(stage, {0.1, 0.5, 0}));
  REQUIRE(stage.until([&] { return context.snapshot->report.strokes.painted > 10; }));
  CHECK(context.view.field == Field::material);
  CHECK(context.snapshot->report.strokes.mass < 0);
  std::size_t lead = 0;
  for (const std::uint16_t m : context.snapshot->material) lead += m == 1 ? 1 : 0;
  CHECK(lead == context.snapshot->report.strokes.painted);
  REQUIRE(stage.steps(3));
  CHECK(context.current.reports.back().strokes.painted == lead);
}

TEST_CASE("a click with the probe tool places one, its curve grows, delete takes it away, the scene has it") {
  NEEDS_DISPLAY();
  Stage stage(small(), false, 1, true);
  REQUIRE(stage.ready());
  for (const char* name : {"", "twisted-bar"}) {
    CAPTURE(name);
    open(stage, *name ? shipped(name) : small());
    AppContext& context = stage.context();
    const std::size_t had = context.scene.probes.size();
    REQUIRE(stage.steps(2));
    context.tool = "probe";
    REQUIRE(stage.until([&] { return !context.snapshot->X.empty(); }));
    const Vec3 middle = mean(*context.snapshot);
    Hand hand(stage);
    hand.click(at(stage, middle));
    REQUIRE(context.scene.probes.size() == had + 1);
    REQUIRE(stage.until([&] { return context.snapshot->probes.size() == had + 1; }));
    CHECK_FALSE(context.status.edit.needs_reset);
    CHECK((context.snapshot->probes.back().X - context.scene.probes.back().at).norm() == 0);
    CHECK(context.status.step == 2);  // nothing was reset
    REQUIRE(stage.steps(3));
    REQUIRE(context.current.probes.size() == context.current.reports.size());
    CHECK(context.current.probes.back().size() == had + 1);
    CHECK(context.current.probes[2].size() == had + 1);  // of the state that it was placed at, too
    const SceneItem placed{ItemKind::probe, had};
    CHECK(context.selected_item == placed);
    hand.click(at(stage, context.snapshot->probes.back().x));  // selects, adds none
    CHECK(context.scene.probes.size() == had + 1);
    stage->act(Action::undo);
    CHECK(context.scene.probes.size() == had);
    CHECK(stage.until([&] { return context.snapshot->probes.size() == had; }));
  }
}
