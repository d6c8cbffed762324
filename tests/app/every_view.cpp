// The views of the window that docs/guide.md has no picture of, to be looked at one by one before a change of the
// window is landed; in both themes, at 1280x800, 1920x1080 and 200 %:
//   PUSHFORWARD_SCREENS=DIR ./test.sh -R 'pictures of'                          these and the guide's
//   PUSHFORWARD_SCREENS=DIR PUSHFORWARD_SCREEN=NAME ./test.sh -R 'pictures of'  one of them
// Menus and dialogs are in every_menu.cpp.
#include <imgui.h>

#include "app/panels/panels.hpp"
#include "app/studies/desk.hpp"
#include "tests/app/shot.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

/// Opens that panel at the left.
void open_panel(Shot& s, void (*draw)(AppContext&)) {
  int index = 0;
  for (const Panel& panel : panels()) {
    if (panel.dock != Dock::left) continue;
    if (panel.draw == draw) memory(s.context()).open_left = index;
    ++index;
  }
  s.frames(4);
}

void panel(Shot& s, const char* scene, void (*draw)(AppContext&), const char* unfold = nullptr) {
  s.show(scene, 12);
  open_panel(s, draw);
  if (unfold != nullptr) {
    const Rect& left = s.bench->layout().left;
    s.tap(unfold, left);
    s.hand.move({left.x + 0.5F * left.width, left.y + 0.5F * left.height});
    for (int k = 0; k < 12; ++k) s.hand.wheel(-1);
  }
  s.rest();
}

/// A tab of the drawer after some steps of the welcome scene.
void plot(Shot& s, const char* title, const char* scene = "welcome") {
  s.show(scene, 1);
  s.context().show_plot(title);
  s.frames(3);
  s.steps(40);
  s.rest();
}

void take_item(Shot& s, const SceneItem& item) {
  s.context().selected_item = item;
  s.frames(3);
}

void study(Shot& s, StudyKind kind, std::vector<DraftAxis> axes, StudyStage until) {
  StudyDesk& desk = studies_of(s.context());
  desk.propose(s.context(), kind);
  desk.draft.cost = "work";
  desk.draft.end = 0.1;
  desk.draft.axes = std::move(axes);
  desk.start_draft(s.context().scene);
  s.until([&] { return desk.status.stage == until && (until == StudyStage::finished || desk.status.finished > 1); });
  s.frames(4);
}

/// Bad steps, an edit and a state of the past.
void trouble_behind(Shot& s) {
  s.bench->open_scene(edited(small(), std::vector<Edit>{{"/time/step", 0.01},
                                                        {"/solver/max_newton", 4},
                                                        {"/body_force", {"0", "t > 0.4 && t < 0.415 ? -4e4 : 0"}}}),
                      {}, false);
  s.ready();
  s.steps(30);
  s.context().change({{"/materials/rubber/young", 2e5}});
  s.steps(30);
}

const std::vector<WindowView>& views() {
  static const std::vector<WindowView> table{
      {"panel-scene", [](Shot& s) { panel(s, "colliding-discs", draw_scene_panel, "Grid, bodies and walls"); }},
      {"panel-material", [](Shot& s) { panel(s, "drooping-cantilever", draw_material_panel); }},
      {"panel-material-3d", [](Shot& s) { panel(s, "torus-on-ball", draw_material_panel); }},
      {"panel-time", [](Shot& s) { panel(s, "drooping-cantilever", draw_time_panel, "Advanced"); }},
      {"panel-transfer", [](Shot& s) { panel(s, "spinning-disc", draw_transfer_panel); }},
      {"panel-solver", [](Shot& s) { panel(s, "welcome", draw_solver_panel, "Advanced"); }},
      {"panel-view",
       [](Shot& s) {
         s.context().view.show_bent_grid = true;
         panel(s, "drooping-cantilever", draw_view_panel);
         s.context().view.lock_range = true;
         s.context().view.range_max = 1e5;
       }},
      {"panel-needs-reset",
       [](Shot& s) {
         panel(s, "drooping-cantilever", draw_material_panel);
         s.context().change({{"/grid/spacing", 0.02}});
         open_panel(s, draw_scene_panel);
       }},
      {"setting-help",
       [](Shot& s) {
         panel(s, "drooping-cantilever", draw_time_panel);
         const auto where = find_whole_text("Time step");
         REQUIRE(where);
         s.hand.move(*where);
         s.frames(30);
       }},
      {"outline",
       [](Shot& s) {
         s.show("welcome", 12);
         open_panel(s, draw_outline_panel);
         take_item(s, {ItemKind::body, 1});
         s.rest();
       }},
      {"outline-wall",
       [](Shot& s) {
         s.show("torus-on-ball", 2);
         open_panel(s, draw_outline_panel);
         take_item(s, {ItemKind::boundary, 0});
         s.rest();
       }},
      {"arrange",
       [](Shot& s) {
         s.show("welcome", 0);
         s.context().tool = "arrange";
         take_item(s, {ItemKind::body, 1});
       }},
      {"arrange-3d",
       [](Shot& s) {
         s.show("torus-on-ball", 0);
         s.context().tool = "arrange";
         take_item(s, {ItemKind::body, 0});
       }},
      {"draw-box",
       [](Shot& s) {
         s.show("drooping-cantilever", 20);
         s.context().tool = "box";
         s.frames(2);
         const double dx = s.context().snapshot->spacing;
         s.hand.move(s.pixel(s.middle() + Vec3(-4 * dx, 8 * dx, 0)));
         s.hand.press();
         s.hand.move(s.pixel(s.middle() + Vec3(2 * dx, 4 * dx, 0)));
       },
       false},
      {"draw-polygon",
       [](Shot& s) {
         s.show("drooping-cantilever", 20);
         s.context().tool = "polygon";
         s.frames(2);
         const double dx = s.context().snapshot->spacing;
         for (const Vec3& to : {Vec3(-4, 4, 0), Vec3(2, 4, 0), Vec3(0, 8, 0)})
           s.hand.click(s.pixel(s.middle() + dx * to));
         s.hand.move(s.pixel(s.middle() + dx * Vec3(-3, 7, 0)));
       },
       false},
      {"plot-energy", [](Shot& s) { plot(s, "Energy"); }},
      {"plot-balance", [](Shot& s) { plot(s, "Energy balance"); }},
      {"plot-momentum", [](Shot& s) { plot(s, "Momentum", "colliding-discs"); }},
      {"plot-phases", [](Shot& s) { plot(s, "Time by phase"); }},
      {"plot-pinned",
       [](Shot& s) {
         plot(s, "Energy");
         s.context().pin();
         s.bench->act(Action::reset);
         s.until([&] { return s.context().status.step == 0 && s.context().status.state == RunState::paused; });
         s.context().change({{"/integrator/type", "implicit_midpoint"}});
         s.steps(25);
       }},
      {"advice-asked", [](Shot& s) { plot(s, "Advice"); }},
      {"compare-begin", [](Shot& s) { plot(s, "Compare", "drooping-cantilever"); }},
      {"study-set-up", [](Shot& s) { plot(s, "Studies", "vibrating-bar"); }},
      {"study-running",
       [](Shot& s) {
         plot(s, "Studies", "vibrating-bar");
         study(
             s, StudyKind::work_precision,
             {{"/integrator/type", {"backward_euler", "implicit_midpoint"}}, {"/time/step", {2e-3, 1e-3, 2e-5, 1e-5}}},
             StudyStage::running);
       }},
      {"study-results",
       [](Shot& s) {
         plot(s, "Studies", "vibrating-bar");
         study(s, StudyKind::work_precision,
               {{"/integrator/type", {"backward_euler", "implicit_midpoint", "symplectic_euler"}},
                {"/time/step", {4e-3, 2e-3, 1e-3, 5e-4}}},
               StudyStage::finished);
       }},
      {"study-map",
       [](Shot& s) {
         plot(s, "Studies", "vibrating-bar");
         study(s, StudyKind::stability_map,
               {{"/time/step", {4e-3, 2e-3, 1e-3, 5e-4}}, {"/grid/spacing", {0.05, 0.025, 0.0125}}},
               StudyStage::finished);
       }},
      {"study-open",
       [](Shot& s) {
         plot(s, "Studies", "vibrating-bar");
         s.tap("Open?", s.bench->layout().drawer);
       }},
      {"rewind",
       [](Shot& s) {
         trouble_behind(s);
         s.context().session.go_to(48);
         s.until([&] { return s.context().status.target < 0 && s.context().snapshot->report.step == 48; });
       }},
      {"branch",
       [](Shot& s) {
         plot(s, "Energy", "drooping-cantilever");
         s.context().session.go_to(20);
         s.until([&] { return s.context().status.target < 0 && s.context().snapshot->report.step == 20; });
         s.context().change({{"/gravity", {0, 4}}});
         s.until([&] { return s.context().status.branches == 1; });
         s.steps(15);
       }},
      {"failed",
       [](Shot& s) {
         s.show("drooping-cantilever", 10);
         s.context().change({{"/body_force", {"sqrt(0.25 - t)", "0"}}});
         s.context().session.run();
         s.until([&] { return s.context().status.state == RunState::failed; });
       }},
      {"shapes",
       [](Shot& s) {
         s.show("drooping-cantilever", 20);
         s.bench->act(Action::shapes);
         s.hand.move(s.pixel(s.middle()));
       },
       false},
      {"arrows",
       [](Shot& s) {
         s.show("spinning-disc", 5);
         s.bench->act(Action::grid);
         s.bench->act(Action::vectors);
       }},
      {"hidden",
       [](Shot& s) {
         s.show("torus-on-ball", 20);
         s.bench->act(Action::hide_panels);
       }},
      {"inspector-3d",
       [](Shot& s) {
         s.show("twisted-bar", 20);
         s.context().selected_particle = s.context().snapshot->id[900];
         s.until([&] { return s.context().looked.has_value(); });
       }},
      {"lesson-asked", [](Shot& s) { s.lesson_at(4, 0, false); }},
      {"lesson-wrong",
       [](Shot& s) {
         s.lesson_at(4, 0, true);
         s.context().lesson->answer_ = 0;
       }},
      {"lesson-large",
       [](Shot& s) {
         s.lesson_at(5, 0, false);
         s.tap("Large text");
         s.rest();
       }},
  };
  return table;
}

}  // namespace

TEST_CASE("pictures of every view") {
  NEEDS_DISPLAY();
  take_pictures(views(), "panel-time");
}
