// The outline and the tools that arrange and draw: what they do reaches the scene and the running simulation.
#include <imgui.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "app/outline/items.hpp"
#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "core/charts/image.hpp"
#include "core/runner.hpp"
#include "tests/app/hand.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

void show_outline(Stage& stage) {
  int index = 0;
  for (const Panel& panel : panels()) {
    if (panel.dock != Dock::left) continue;
    if (panel.draw == draw_outline_panel) memory(stage.context()).open_left = index;
    ++index;
  }
}

Scene two() {
  return parse_scene(R"({"name": "Two", "dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.1},
      "time": {"end": 1, "step": 0.005},
      "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
      "bodies": [{"name": "ball", "material": "rubber", "shape": {"type": "ball", "center": [0, 0.5], "radius": 0.4}},
                 {"name": "box", "material": "rubber", "shape": {"type": "box", "min": [1, 0.2], "max": [1.6, 0.8]}}],
      "boundaries": [{"shape": {"type": "half_space", "point": [0, 0], "normal": [0, 1]}}],
      "constraints": [{"region": {"type": "box", "min": [1.5, 0], "max": [1.8, 1]}, "fix": [true, true]}],
      "loads": [{"body": "ball", "region": {"type": "box", "min": [-1, 0.7], "max": [1, 1]}, "traction": [0, -10]}],
      "probes": [{"name": "top", "at": [0, 0.9]}]})",
                     "test");
}

}  // namespace

TEST_CASE("every kind of thing is added, doubled and deleted, and undo takes each back") {
  NEEDS_DISPLAY();
  Stage stage(two());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  for (const ItemGroup& group : item_groups()) {
    CAPTURE(std::string(group.title));
    const Scene before = context.scene;
    const std::size_t count = group.count(before);
    REQUIRE(edit_scene(context, added(context.scene, group.kind)));
    CHECK(group.count(context.scene) == count + 1);
    const SceneItem fresh{group.kind, count};
    REQUIRE(edit_scene(context, doubled(context.scene, fresh)));
    CHECK(group.count(context.scene) == count + 2);
    REQUIRE(edit_scene(context, deleted(context.scene, fresh)));
    CHECK(group.count(context.scene) == count + 1);
    REQUIRE(applied(stage));
    for (int k = 0; k < 3; ++k) stage->act(Action::undo);
    CHECK(context.scene == before);
    stage->act(Action::redo);
    CHECK(group.count(context.scene) == count + 1);
    stage->act(Action::undo);
    REQUIRE(applied(stage));
  }
  // What others refer to stays, and the user is told why.
  CHECK_FALSE(edit_scene(context, deleted(context.scene, {ItemKind::material, 0})));
  CHECK_FALSE(context.problems.empty());
}

TEST_CASE("a drawn body enters the running simulation, of the selected material, and replays") {
  NEEDS_DISPLAY();
  Stage stage(two());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  context.session.set_rate(0);
  REQUIRE(stage.steps(4));
  stage.frames(4);
  const std::size_t particles = context.snapshot->particles;
  Hand hand(stage);
  context.tool = "box";
  hand.drag(at(stage, {0.42, 0.98, 0}), at(stage, {0.78, 1.32, 0}));
  REQUIRE(applied(stage));
  REQUIRE(context.scene.bodies.size() == 3);
  const Shape& box = context.scene.bodies[2].shape;
  CHECK(box.min.isApprox(Vec3(0.4, 1, 0), 1e-9));  // snapped to half cells
  CHECK(box.max.isApprox(Vec3(0.8, 1.3, 0), 1e-9));
  CHECK(context.selected_item == SceneItem{ItemKind::body, 2});
  REQUIRE(stage.until([&] { return context.snapshot->particles > particles; }));
  CHECK(context.snapshot->particles == particles + 48);
  CHECK(context.status.step == 4);
  CHECK_FALSE(context.status.edit.needs_reset);

  context.tool = "ball";
  hand.drag(at(stage, {0, 1.1, 0}), at(stage, {0.1, 1.1, 0}));
  REQUIRE(applied(stage));
  REQUIRE(context.scene.bodies.size() == 4);
  CHECK(context.scene.bodies[3].shape.radius == doctest::Approx(0.1));
  context.tool = "polygon";
  for (const Vec3& corner : {Vec3(1.0, 0.95, 0), Vec3(1.4, 0.95, 0), Vec3(1.2, 1.2, 0), Vec3(1.0, 0.95, 0)})
    hand.click(at(stage, corner));
  REQUIRE(applied(stage));
  REQUIRE(context.scene.bodies.size() == 5);
  CHECK(context.scene.bodies[4].shape.points.size() == 3);
  REQUIRE(stage.steps(3));
  const Snapshot seen = *context.snapshot;

  // Back to before they came, and forward again: the same.
  context.session.go_to(2);
  REQUIRE(stage.until([&] { return context.session.status().target < 0 && context.snapshot->report.step == 2; }));
  CHECK(context.snapshot->particles == particles);
  context.session.go_to(7);
  REQUIRE(stage.until([&] { return context.session.status().target < 0 && context.snapshot->report.step == 7; }));
  CHECK(context.snapshot->x == seen.x);
  // And from the record.
  const auto replay = make_simulation(context.session.recorded());
  Runner(*replay).run({7});
  Snapshot replayed;
  replay->capture({}, replayed);
  CHECK(replayed.x == seen.x);
}

TEST_CASE("arrange selects in the view, drags, turns and scales; a run that has begun says that it needs a reset") {
  NEEDS_DISPLAY();
  Stage stage(two());
  REQUIRE(stage.ready());
  stage.frames(4);
  AppContext& context = stage.context();
  Hand hand(stage);
  context.tool = "arrange";
  hand.click(at(stage, {0, 0.5, 0}));
  CHECK(context.selected_item == SceneItem{ItemKind::body, 0});
  hand.click(at(stage, {1.7, 0.5, 0}));
  CHECK(context.selected_item == SceneItem{ItemKind::constraint, 0});
  hand.click(at(stage, {1.2, 0.5, 0}));
  CHECK(context.selected_item == SceneItem{ItemKind::body, 1});

  const auto centre_of_box = [&] {
    const Bounds b = make_solid(context.scene.bodies[1].shape, 2, {})->bounds();
    return Vec3((b.min + b.max) / 2);
  };
  hand.drag(at(stage, {1.2, 0.5, 0}), at(stage, {1.31, 0.93, 0}));
  REQUIRE(applied(stage));
  CHECK(centre_of_box().head<2>().isApprox(Vec<2>(1.4, 0.95), 1e-9));  // by 0.1, 0.45
  // Nothing was simulated yet: the particles follow at once.
  CHECK_FALSE(context.status.edit.needs_reset);
  stage.frames(6);

  const float em = ImGui::GetFontSize();
  const auto knob = [&](bool turn) {
    const Bounds b = make_solid(context.scene.bodies[1].shape, 2, {})->bounds();
    const Point2 c = at(stage, (b.min + b.max) / 2), edge = at(stage, {b.max.x(), b.max.y(), 0});
    const float r = std::hypot(edge.x - c.x, edge.y - c.y) + 0.8F * em, s = r / std::numbers::sqrt2_v<float>;
    return std::pair{c, turn ? Point2{c.x, c.y - r} : Point2{c.x + s, c.y + s}};
  };
  auto [middle, top] = knob(true);
  hand.drag(top, {middle.x - (middle.y - top.y), middle.y});  // a quarter turn to the left
  REQUIRE(applied(stage));
  CHECK(context.scene.bodies[1].shape.rotate_degrees == doctest::Approx(90));
  stage.frames(6);
  const auto [c, corner] = knob(false);
  hand.drag(corner, {c.x + 1.5F * (corner.x - c.x), c.y + 1.5F * (corner.y - c.y)});
  REQUIRE(applied(stage));
  CHECK(context.scene.bodies[1].shape.scale == doctest::Approx(1.5));
  for (int k = 0; k < 3; ++k) stage->act(Action::undo);
  CHECK(context.scene == two());

  stage->act(Action::reset);
  REQUIRE(applied(stage));
  REQUIRE(stage.steps(2));
  hand.drag(at(stage, {1.2, 0.5, 0}), at(stage, {1.2, 0.7, 0}));
  REQUIRE(applied(stage));
  CHECK(context.status.edit.needs_reset);
  CHECK(context.scene.bodies[1].shape.translate.y() == doctest::Approx(0.2));
  stage->act(Action::deselect);
  CHECK_FALSE(context.selected_item);
}

TEST_CASE("bodies are moved in 3D, in the plane that faces the viewer") {
  NEEDS_DISPLAY();
  Stage stage(shipped("torus-on-ball"));
  REQUIRE(stage.ready());
  stage.frames(6);
  AppContext& context = stage.context();
  context.tool = "arrange";
  Hand hand(stage);
  context.selected_item = SceneItem{ItemKind::body, 0};
  stage.frames(2);
  const Bounds before = make_solid(context.scene.bodies[0].shape, 3, context.scene.constants)->bounds();
  const Vec3 c = (before.min + before.max) / 2;
  const double dx = context.scene.grid.spacing;
  hand.drag(at(stage, c), at(stage, c + Vec3(0, 4 * dx, 0)));
  REQUIRE(applied(stage));
  const Vec3 moved = context.scene.bodies[0].shape.translate - shipped("torus-on-ball").bodies[0].shape.translate;
  CHECK(moved.y() > 2 * dx);
  CHECK(std::abs(moved.y() / (dx / 2) - std::round(moved.y() / (dx / 2))) < 1e-6);
}

TEST_CASE("a picture of each view with the outline, in both themes") {
  NEEDS_DISPLAY();
  const char* folder = std::getenv("PUSHFORWARD_SCREENSHOTS");
  for (const float scale : {1.0F, 2.0F})
    for (const Theme theme : {Theme::dark, Theme::light}) {
      Stage stage(two(), false, scale, true);
      REQUIRE(stage.ready());
      stage.context().view.theme = theme;
      show_outline(stage);
      memory(stage.context()).plot = "Energy balance";
      memory(stage.context()).show_plot = true;
      stage.context().tool = "arrange";
      stage.context().selected_item = SceneItem{ItemKind::body, 1};
      stage.frames(3);
      REQUIRE(stage.steps(60));
      stage.frames(8);
      CHECK(stage.context().current.reports.back().energy.known);
      if (!folder) continue;
      const std::string name =
          std::string("outline-") + (theme == Theme::dark ? "dark" : "light") + (scale > 1 ? "-200" : "");
      write_png(stage->screenshot(), fs::path(folder) / (name + ".png"), {});
    }
}
