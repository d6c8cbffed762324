// The pictures of docs/guide.md, and those that one looks at before a change of the window is landed:
//   PUSHFORWARD_UPDATE_DOCS=1 ./test.sh -R 'pictures of the guide'          docs/images/guide-*.png
//   PUSHFORWARD_SCREENS=DIR ./test.sh -R 'pictures of the guide'            both themes, three sizes
// PUSHFORWARD_SCREEN=NAME makes one of them alone. The views that the guide does not show are in every_view.cpp.
#include <imgui.h>

#include "app/advice/desk.hpp"
#include "tests/app/shot.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

const std::vector<WindowView>& views() {
  static const std::vector<WindowView> table{
      {"window", [](Shot& s) { s.show("welcome", 45); }},
      {"inspector",
       [](Shot& s) {
         s.show("drooping-cantilever", 25);
         s.context().selected_particle = s.context().snapshot->id[300];
         s.until([&] { return s.context().looked.has_value(); });
       }},
      {"node",
       [](Shot& s) {
         s.show("stretched-strip", 40);
         s.context().selected_node = NodeIndex{0, 6, 0};
         s.bench->act(Action::fit);
         s.frames(3);  // from now on steps keep their residuals
         s.steps(1);
         s.until([&] { return s.context().looked && s.context().looked->node && s.context().looked->node->residual; });
       }},
      {"slow-give",
       [](Shot& s) {
         s.show("drooping-cantilever", 12);
         s.slow_at(PhaseKind::give, 0.5);
       }},
      {"slow-newton",
       [](Shot& s) {
         s.show("drooping-cantilever", 12);
         s.slow_at(PhaseKind::iterate, 0.3);
       }},
      {"slow-ride",
       [](Shot& s) {
         s.show("spinning-disc", 5);
         s.slow_at(PhaseKind::ride, 0.5);
       }},
      {"slow-3d",
       [](Shot& s) {
         s.show("twisted-bar", 30);
         s.slow_at(PhaseKind::ride, 0.5);
       }},
      {"convergence",
       [](Shot& s) {
         s.show("drooping-cantilever", 8);
         s.context().show_plot("Convergence");
         s.frames(3);
         s.steps(3);
       }},
      {"compare",
       [](Shot& s) {
         s.show("welcome", 1);
         s.context().show_plot("Compare");
         s.frames(3);
         CompareDesk& desk = compare_of(s.context());
         desk.add(s.context(), "/integrator/type", "implicit_midpoint");
         desk.add(s.context(), "/grid/basis", "linear");
         s.act_until(0.6);
         desk.metric = 7;
       }},
      {"advice",
       [](Shot& s) {
         s.show("welcome", 30);
         s.context().show_plot("Advice");
         s.frames(3);
         advice_of(s.context()).ask(s.context());
         s.until([&] { return !advice_of(s.context()).busy(); });
       }},
      {"compare-difference",
       [](Shot& s) {
         s.show("drooping-cantilever", 1);
         s.context().show_plot("Compare");
         s.frames(3);
         CompareDesk& desk = compare_of(s.context());
         desk.add(s.context(), "/time/step", 0.005);
         desk.difference = true;
         s.act_until(0.4);
         s.context().selected_particle = static_cast<std::uint32_t>(desk.frame->lanes[1].snapshot->id.size() - 20);
       }},
      {"compare-3d",
       [](Shot& s) {
         s.show("twisted-bar", 1);
         s.context().show_plot("Compare");
         s.frames(3);
         CompareDesk& desk = compare_of(s.context());
         desk.add(s.context(), "/transfer/type", "pic");
         desk.add(s.context(), "/time/step", 0.005);
         desk.add(s.context(), "/grid/basis", "cubic");
         s.act_until(0.15);
       }},
      {"fields",
       [](Shot& s) {
         s.show("drooping-cantilever", 30);
         s.context().view.color_by(Field::stress_xx);
         s.bench->act(Action::crosses);
       }},
      {"fields-menu",
       [](Shot& s) {
         s.show("drooping-cantilever", 30);
         click_menu(s, "View");
         s.frames(3);
         click_text(s, "Colour by");
         s.frames(3);
         click_text(s, "Stress");
       }},
      {"crosses-3d",
       [](Shot& s) {
         s.show("twisted-bar", 60);
         s.context().view.color_by(Field::material);
         s.bench->act(Action::crosses);
       }},
      {"node-field",
       [](Shot& s) {
         s.show("stretched-strip", 40);
         s.context().view.color_by(Field::node_force);
         s.context().view.log_colors = true;
       }},
      {"log-range",
       [](Shot& s) {
         s.show("welcome", 60);
         s.context().view.log_colors = true;
       }},
      {"record",
       [](Shot& s) {
         s.show("welcome", 45);
         s.bench->act(Action::record);
         s.bench->recorder().choice().what = RecordChoice::What::film;
         s.bench->recorder().choice().file = "welcome.mp4";
       }},
      {"recording",
       [](Shot& s) {
         s.show("drooping-cantilever", 1);
         RecordChoice& choice = s.bench->recorder().choice();
         choice.folder = (s.folder / "frames").string();
         s.bench->recorder().begin(s.context(), true);
         s.until([&] { return s.bench->recorder().frames() >= 12; });
         s.context().session.pause();
         s.until([&] { return s.context().status.state == RunState::paused; });
       }},
      {"pin",
       [](Shot& s) {
         s.show("welcome", 40);
         s.context().tool = "pin";
         s.frames(2);
         s.hand.click(s.pixel(s.middle() + Vec3(0, s.context().snapshot->spacing, 0)));
         s.steps(25);
       }},
      {"push",
       [](Shot& s) {
         s.show("welcome", 60);
         s.context().tool = "push";
         s.frames(2);
         const Vec3 at = s.middle();
         s.hand.move(s.pixel(at + Vec3(0, 6 * s.context().snapshot->spacing, 0)));
         s.hand.press();
         s.steps(2);
         for (int k = 1; k <= 20; ++k) {
           s.hand.move(s.pixel(at + Vec3(0, (6 - 0.2 * k) * s.context().snapshot->spacing, 0)));
           s.steps(1);
         }
       }},
      {"cut",
       [](Shot& s) {
         s.show("drooping-cantilever", 20);
         s.context().show_plot("Energy balance");
         s.frames(3);
         s.steps(2);
         s.context().tool = "cut";
         s.frames(2);
         const Vec3 at = s.middle();
         const double dx = s.context().snapshot->spacing;
         s.hand.drag(s.pixel(at - Vec3(0, 5 * dx, 0)), s.pixel(at + Vec3(0, 5 * dx, 0)));
         s.frames(4);
         s.steps(14);
       }},
      {"cut-3d",
       [](Shot& s) {
         s.show("twisted-bar", 10);
         s.context().tool = "cut";
         s.frames(2);
         const Vec3 at = s.middle();
         s.hand.drag(s.pixel(at), s.pixel(at + Vec3(0, 2 * s.context().snapshot->spacing, 0)));
         s.frames(4);
         s.steps(6);
       }},
      {"paint",
       [](Shot& s) {
         Scene scene = shipped("drooping-cantilever");
         scene.materials.push_back(scene.materials[0]);
         scene.materials[1].name = "stiffer";
         for (auto& [name, value] : scene.materials[1].parameters)
           if (name == "young") value *= 20;
         s.bench->open_scene(scene, {}, false);
         s.until([&] { return s.context().scene == scene && s.context().status.state == RunState::paused; });
         s.ready();
         s.steps(4);
         s.context().tool = "paint";
         s.frames(2);
         const Vec3 at = s.middle();
         const double dx = s.context().snapshot->spacing;
         s.hand.drag(s.pixel(at - Vec3(8 * dx, 0, 0)), s.pixel(at + Vec3(6 * dx, 0, 0)));
         s.frames(4);
         s.steps(12);
       }},
      {"probes",
       [](Shot& s) {
         s.show("drooping-cantilever", 6);
         s.context().tool = "probe";
         s.until([&] { return !s.context().snapshot->X.empty(); });
         const Snapshot snapshot = *s.context().snapshot;
         for (const double share : {0.15, 0.6, 0.95}) {
           const auto far = [&](std::size_t p) {
             return std::abs(snapshot.X[2 * p] - share * 0.98 * snapshot.X[2 * snapshot.particles - 2]) +
                    std::abs(snapshot.X[2 * p + 1] - s.middle().y());
           };
           std::size_t best = 0;
           for (std::size_t p = 0; p < snapshot.particles; ++p)
             if (far(p) < far(best)) best = p;
           s.hand.click(s.pixel({snapshot.x[2 * best], snapshot.x[2 * best + 1], 0}));
           s.frames(3);
         }
         s.steps(30);
       }},
      {"lesson", [](Shot& s) { s.lesson_at(5, 3, true); }},
      {"lesson-newton", [](Shot& s) { s.lesson_at(4, 1, true); }},
  };
  return table;
}

}  // namespace

TEST_CASE("pictures of the guide") {
  NEEDS_DISPLAY();
  const char* update = std::getenv("PUSHFORWARD_UPDATE_DOCS");
  std::function<fs::path(const std::string&)> keep;
  if (update != nullptr && *update == '1')
    keep = [](const std::string& name) {
      return fs::path(PUSHFORWARD_SOURCE) / ("docs/images/guide-" + name + ".png");
    };
  take_pictures(views(), "inspector", keep);
}
