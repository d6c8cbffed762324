// Studies in the whole window: they hold the live view while they are timed, open settings in one undo step, and
// survive the window.
#include "app/studies/desk.hpp"

#include <imgui.h>

#include <cstdlib>
#include <fstream>

#include "app/panels/memory.hpp"
#include "core/charts/theme.hpp"
#include "core/files.hpp"
#include "tests/app/stage.hpp"
#include "tests/studies/small_study.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

/// A bar whose exact motion is known, small enough to be run many times.
Scene bar() {
  return parse_scene(test::bar_scene, "test", std::vector<Edit>{{"/name", "Bar"}, {"/time/end", 5}});
}

struct Studied : Stage {
  using Stage::Stage;
  StudyDesk& desk() { return studies_of(context()); }
  void show_drawer() {
    memory(context()).plot = "Studies";
    memory(context()).show_plot = true;
    frames(4);
  }
  /// A study of the scene as it stands.
  void start(const std::string& cost, std::vector<DraftAxis> axes) {
    desk().propose(context(), StudyKind::work_precision);
    desk().draft.cost = cost;
    desk().draft.repeat = 2;
    desk().draft.end = 0.08;
    desk().draft.axes = std::move(axes);
    desk().start_draft(context().scene);
  }
  bool comes_to(StudyStage stage) {
    return until([&] { return desk().status.stage == stage; });
  }
};

const std::vector<DraftAxis> six{{"/integrator/type", {"backward_euler", "symplectic_euler"}},
                                 {"/time/step", {0.004, 0.002, 0.001}}};

}  // namespace

TEST_CASE("a timed study holds the live view and says so; it goes on by itself afterwards") {
  NEEDS_DISPLAY();
  Studied stage(bar());
  REQUIRE(stage.ready());
  stage.show_drawer();
  stage->act(Action::run_pause);
  REQUIRE(stage.until([&] { return stage.context().status.step > 2; }));
  stage.start("wall", {{"/time/step", {0.004, 0.002, 0.0001, 0.00005}}});
  REQUIRE(stage.until([&] { return stage.desk().holds_view() && stage.context().status.suspended; }));
  stage.frames(2);
  const long step = stage.context().status.step;
  stage->act(Action::run_pause);  // what the user presses meanwhile waits, too
  stage->act(Action::run_pause);
  stage->act(Action::step);
  REQUIRE(stage.until([&] { return stage.desk().status.finished >= 2; }));
  if (stage.desk().holds_view()) CHECK(stage.context().status.step == step);
  REQUIRE(stage.comes_to(StudyStage::finished));
  stage->act(Action::run_pause);
  if (stage.context().status.state != RunState::running) stage->act(Action::run_pause);
  CHECK(stage.until([&] { return stage.context().status.step > step + 2; }));
  CHECK_FALSE(stage.context().status.suspended);
}

TEST_CASE("an untimed study runs beside the live view, its dots in the chart as they come") {
  NEEDS_DISPLAY();
  Studied stage(bar());
  REQUIRE(stage.ready());
  stage.show_drawer();
  stage->act(Action::run_pause);
  stage.start("work", {{"/time/step", {0.004, 0.002, 0.00002, 0.00001}}});
  REQUIRE(stage.until([&] { return stage.desk().status.finished >= 2; }));
  const long step = stage.context().status.step;
  CHECK_FALSE(stage.context().status.suspended);
  CHECK(stage.until([&] { return stage.context().status.step > step + 1; }));
  REQUIRE(stage.desk().shown_figure());
  CHECK(stage.desk().shown_figure()->chart.series.size() == 1);
  CHECK(stage.comes_to(StudyStage::finished));
  CHECK(stage.desk().shown_figure()->chart.series[0].x.size() == 4);
}

TEST_CASE("the dots of a study are seen in the drawer") {
  NEEDS_DISPLAY();
  Studied stage(shipped("vibrating-bar"), false, 1, true);
  REQUIRE(stage.ready());
  stage.show_drawer();
  REQUIRE(stage.steps(90));
  stage.start("work", {{"/integrator/type", {"backward_euler", "symplectic_euler"}},
                       {"/time/step", {0.004, 0.002, 0.001, 0.0005, 0.00025}}});
  REQUIRE(stage.comes_to(StudyStage::finished));
  stage.frames(6);
  REQUIRE(stage.desk().place);
  const Image window = stage->screenshot();
  const Rect drawer = stage->layout().drawer;
  int seen[2] = {};
  for (int y = static_cast<int>(drawer.y); y < window.height; ++y)
    for (int x = static_cast<int>(drawer.x + drawer.width / 3); x < window.width; ++x)
      for (std::size_t k = 0; k < 2; ++k) {
        const Color c = window.color(x, y), s = dark_theme().series[k];
        seen[k] += std::abs(c.r - s.r) + std::abs(c.g - s.g) + std::abs(c.b - s.b) < 0.02F ? 1 : 0;
      }
  CHECK(seen[0] > 200);
  CHECK(seen[1] > 200);
  const char* update = std::getenv("PUSHFORWARD_UPDATE_DOCS");
  if (update != nullptr && *update == '1') write_png(window, fs::path(PUSHFORWARD_SOURCE) / "docs/images/studies.png");
}

TEST_CASE("a setting is opened in one step and taken back in one, the run begun anew where it must be") {
  NEEDS_DISPLAY();
  Studied stage(bar());
  REQUIRE(stage.ready());
  stage.show_drawer();
  stage.start("work", {{"/grid/spacing", {0.125, 0.0625}}, {"/time/step", {0.004, 0.002}}});
  REQUIRE(stage.comes_to(StudyStage::finished));
  const std::size_t particles = stage.context().snapshot->particles;
  load_setting(stage.context(), 3);
  CHECK(stage.context().scene.grid.spacing == 0.0625);
  CHECK(stage.context().scene.time.step == 0.002);
  CHECK(stage.context().scene.time.end == 5);
  REQUIRE(stage.until([&] { return stage.context().snapshot->particles > particles; }));
  stage.desk().follow(stage.context());
  REQUIRE(stage.desk().place);
  CHECK(stage.desk().place->setting(*stage.desk().results->study) == 3u);
  load_setting(stage.context(), 2);  // at once: still a step of its own
  stage->act(Action::undo);
  CHECK(stage.context().scene.time.step == 0.002);
  stage->act(Action::undo);
  CHECK(stage.context().scene == bar());
  CHECK_FALSE(stage->possible(Action::undo));
  stage->act(Action::redo);
  CHECK(stage.context().scene.grid.spacing == 0.0625);
}

TEST_CASE("a study of another scene opens that scene; undo brings the first one back, its file too") {
  NEEDS_DISPLAY();
  Studied stage(small());
  REQUIRE(stage.ready());
  const fs::path file = stage.folder / "ball.json", study = stage.folder / "study.json";
  save_scene(small(), file);
  stage.context().open_file(file);
  REQUIRE(stage.ready());
  StudyDraft draft = propose_study(bar(), StudyKind::work_precision, 1e-3);
  draft.cost = "work";
  draft.end = 0.08;
  draft.axes = six;
  pf::write_atomically(study, study_text(draft, bar()));
  stage.context().open_file(study);  // as if it was dropped on the window
  stage.frames(4);
  REQUIRE(stage.comes_to(StudyStage::ready));
  CHECK(stage.context().scene == load_scene(file));
  stage.desk().runner.begin();
  REQUIRE(stage.comes_to(StudyStage::finished));
  CHECK_FALSE(stage.desk().place);
  load_setting(stage.context(), 1);
  CHECK(stage.context().scene.name == "Bar");
  CHECK(stage.context().scene.time.step == 0.002);
  CHECK(stage.context().scene_file.empty());
  REQUIRE(stage.until([&] { return stage.context().snapshot->particles == 32; }));
  stage->act(Action::undo);
  CHECK(stage.context().scene == load_scene(file));
  CHECK(stage.context().scene_file == file);
}

TEST_CASE("a window closed while a study runs loses no finished run") {
  NEEDS_DISPLAY();
  std::size_t finished = 0;
  const test::TemporaryFolder kept;
  {
    Studied stage(bar());
    REQUIRE(stage.ready());
    stage.show_drawer();
    stage.start("work", {{"/time/step", {0.004, 0.002, 0.001, 0.00002, 0.00001, 0.000005}}});
    REQUIRE(stage.until([&] { return stage.desk().status.finished >= 2; }));
    stage->open_scene(small(), {}, true);  // the study has its own scene: it goes on
    REQUIRE(stage.until([&] { return stage.desk().status.finished >= 3; }));
    finished = stage.desk().status.finished;
    const auto begin = Clock::now();
    stage->act(Action::quit);
    stage.bench.reset();
    CHECK(Clock::now() - begin < std::chrono::seconds(5));
    fs::copy(stage.folder / "studies", kept.path() / "studies", fs::copy_options::recursive);
  }
  const std::vector<LibraryEntry> earlier = earlier_studies(kept.path() / "studies");
  REQUIRE(earlier.size() == 1);
  CHECK(earlier[0].finished >= finished);
  CHECK(earlier[0].runs == 6);
}
