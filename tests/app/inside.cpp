// Looking inside in the whole window: the inspectors, shape functions, one step taken apart, and where residuals are.
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/inside/overlay.hpp"
#include "app/inside/step_player.hpp"
#include "app/panels/memory.hpp"
#include "app/tools/tool.hpp"
#include "core/bases/basis.hpp"
#include "tests/app/stage.hpp"
#include "tests/charts/recording_painter.hpp"
#include "tests/panels/letters.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

/// A click of the tool in hand at a point of the plane, as the view hands it over.
void click(Stage& stage, const Vec3& at, bool ctrl = false) {
  ViewMouse mouse;
  mouse.origin = at;
  mouse.ctrl = ctrl;
  const GlView& view = stage->view();
  const auto pixel = view.to_window(at);
  REQUIRE(pixel);
  mouse.pixel = *pixel;
  const Vec<2> in_view(pixel->x - view.place().x, pixel->y - view.place().y);
  mouse.particle = pick_particle(*stage.context().snapshot, view.camera(), view.size(), in_view);
  tools().front().make()->click(mouse, stage.context());
  stage->act(Action::fit);  // something to draw
  stage.frames(2);
}

/// 400 pixels a metre, y upwards.
class FlatMap final : public ViewMap {
 public:
  std::optional<Point2> to_pixel(const Vec3& p) const override {
    return Point2{static_cast<float>(400 * p.x()), static_cast<float>(-400 * p.y())};
  }
  double metres_per_pixel(const Vec3&) const override { return 1.0 / 400; }
  float em() const override { return 15; }
};

bool cuts_nothing() {
  bool good = true;
  for (const ImGuiWindow* window : GImGui->Windows) {
    if (!window->Active || window->Hidden) continue;
    CAPTURE(std::string(window->Name));
    CHECK(window->ScrollMax.x <= 0);
    good &= window->ScrollMax.x <= 0;
  }
  return good;
}

}  // namespace

TEST_CASE("a click selects a particle, with Ctrl a node, and the inspectors have the simulation's own numbers") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  REQUIRE(stage.steps(3));
  AppContext& context = stage.context();
  click(stage, Vec3(0.11, 0.62, 0));
  REQUIRE(context.selected_particle);
  REQUIRE(stage.until([&] { return context.looked && context.looked->particle && context.inspected; }));
  const ParticleLook& p = *context.looked->particle;
  CHECK(p.state.id == *context.selected_particle);
  CHECK((p.state.x - Vec3(0.11, 0.62, 0)).norm() < 0.06);
  CHECK(p.weight_sum == doctest::Approx(1).epsilon(1e-12));
  CHECK(p.nodes.size() == 9);

  click(stage, Vec3(0.13, 0.57, 0), true);
  REQUIRE(context.selected_node);
  CHECK(*context.selected_node == NodeIndex{1, 6, 0});
  REQUIRE(stage.until([&] { return context.looked && context.looked->node; }));
  CHECK(context.looked->node->mass > 0);
  CHECK(context.looked->node->contributors >= 9);
  // From now on steps keep their residuals, and the node has its own.
  REQUIRE(stage.steps(2));
  REQUIRE(stage.until([&] { return context.looked && context.looked->step == 5 && context.looked->node->residual; }));
  CHECK(cuts_nothing());
  stage->act(Action::deselect);
  CHECK_FALSE(context.selected_node);
  stage->act(Action::deselect);
  CHECK_FALSE(context.selected_particle);
  stage.frames(3);
  CHECK(stage->layout().inspector.empty());
  REQUIRE(stage.steps(1));
  CHECK_FALSE(context.record);  // nobody asks any more: nothing is kept
}

TEST_CASE("a step taken apart is a real step, goes through its phases, and leaves the run where it is") {
  NEEDS_DISPLAY();
  for (const char* name : {"small", "twisted-bar"}) {
    CAPTURE(name);
    Stage stage(std::string(name) == "small" ? small() : shipped(name));
    REQUIRE(stage.ready());
    REQUIRE(stage.steps(2));
    AppContext& context = stage.context();
    stage->act(Action::slow_step);
    REQUIRE(stage.until([&] { return context.slow != nullptr; }));
    StepPlayer& player = *context.slow;
    player.playing = false;
    CHECK(context.status.step == 3);
    CHECK(player.record().step == 3);
    CHECK(player.phases().front().kind == PhaseKind::give);
    CHECK(player.phases().back().kind == PhaseKind::snap);
    REQUIRE(context.selected_particle);
    REQUIRE(context.selected_node);
    const int d = player.record().dimension;
    const auto p = player.find_particle(*context.selected_particle);
    REQUIRE(p);
    // Unmagnified, the picture begins where the particles were and ends where they are.
    player.set_magnification(1);
    player.seek(0);
    stage.frames(1);
    CHECK((entry(context.snapshot->x, *p, d) - entry(player.record().before.x, *p, d)).norm() < 1e-14);
    for (std::size_t k = 0; k < player.phases().size(); ++k) {
      CAPTURE(player.phases()[k].title);
      for (const double f : {0.02, 0.5, 0.98}) {
        player.seek(static_cast<double>(k) + f);
        stage->act(Action::fit);
        stage.frames(2);
        CHECK(player.phase_index() == k);
        CHECK(cuts_nothing());
        CHECK(reading(letters(*ImGui::GetDrawData())).find('\\') == std::string::npos);  // every formula was set
      }
    }
    player.seek(static_cast<double>(player.phases().size()));
    stage.frames(1);
    CHECK((entry(context.snapshot->x, *p, d) - entry(player.record().after.x, *p, d)).norm() < 1e-14);
    CHECK(context.snapshot->nodes > 0);
    CHECK(context.snapshot->nodes <= player.record().nodes());
    for (const double u : context.snapshot->node_displacement) CHECK(u == 0);
    // The bent grid at the end of the last iteration is the one that particles ride on.
    const auto node = player.find_node(*context.selected_node);
    REQUIRE(node);
    for (std::size_t k = 0; k < player.phases().size(); ++k)
      if (player.phases()[k].kind == PhaseKind::ride) player.seek(static_cast<double>(k) + 0.5);
    CHECK((player.node_displacement(*node) - entry(player.record().node_displacement, *node, d)).norm() < 1e-15);
    stage->act(Action::step);  // the right arrow goes on to the next phase
    CHECK(player.phase().kind == PhaseKind::snap);
    CHECK(context.status.step == 3);

    stage->act(Action::deselect);
    CHECK_FALSE(context.slow);
    REQUIRE(stage.until([&] { return context.snapshot->report.step == 3; }));
    REQUIRE(stage.steps(1));
    CHECK(context.status.step == 4);
  }
}

TEST_CASE("a step that is played runs by itself and stops at its end; a run or a reset ends it") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  stage->act(Action::slow_step);
  REQUIRE(stage.until([&] { return context.slow != nullptr; }));
  context.slow->speed = 50;
  REQUIRE(stage.until([&] { return !context.slow->playing; }));
  CHECK(context.slow->at_end());
  stage->act(Action::slow_step);  // the next one
  REQUIRE(stage.until([&] { return context.slow && context.slow->record().step == 2; }));
  CHECK(context.slow->speed == 50);
  stage->act(Action::reset);
  CHECK_FALSE(context.slow);
  REQUIRE(stage.until([&] { return context.status.step == 0 && context.status.state != RunState::loading; }));
  stage->act(Action::slow_step);
  REQUIRE(stage.until([&] { return context.slow != nullptr; }));
  context.session.run();
  REQUIRE(stage.until([&] { return !context.slow; }));
}

TEST_CASE("the convergence plot says where the residual is, and costs nothing while it is not shown") {
  NEEDS_DISPLAY();
  Stage stage(small(), false, 1, true);
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  REQUIRE(stage.steps(2));
  CHECK_FALSE(context.record);
  context.show_plot("Convergence");
  stage.frames(4);
  CHECK(context.wants_record);
  REQUIRE(stage.steps(2));
  REQUIRE(stage.until([&] { return context.record && context.record->step == context.status.step; }));
  REQUIRE_FALSE(context.record->iterates.empty());
  CHECK(context.record->iterates.front().worst >= 0);
  CHECK(context.record->before.x.empty());
  context.show_plot("Energy");
  stage.frames(4);
  REQUIRE(stage.steps(1));
  CHECK_FALSE(context.record);
}

TEST_CASE("shape functions follow the mouse: discs at all nodes of a point, curves of both directions") {
  NEEDS_DISPLAY();
  for (const char* basis : {"linear", "quadratic", "cubic"}) {
    CAPTURE(basis);
    Scene scene = edited(small(), std::vector<Edit>{{"/grid/basis", basis}});
    Stage stage(scene);
    REQUIRE(stage.ready());
    const auto drawn = [&] {
      test::RecordingPainter painter;
      ViewMouse mouse;
      mouse.origin = Vec3(0.03, 0.42, 0);
      draw_inside(painter, FlatMap(), &mouse, stage.context());
      CHECK(painter.all_finite);
      return painter;
    };
    CHECK(drawn().lines.empty());
    stage->act(Action::shapes);
    CHECK(stage.context().view.show_shapes);
    const test::RecordingPainter painter = drawn();
    const auto K = static_cast<std::size_t>(find_basis(basis)->nodes_per_axis);
    const auto curves =
        std::count_if(painter.lines.begin(), painter.lines.end(), [](const auto& l) { return l.size() > 40; });
    CHECK(static_cast<std::size_t>(curves) == 2 * K);
    CHECK(painter.shapes >= 2 * K * K);
  }
}
