// The whole window, driven turn by turn: what the user does must reach the simulation and the picture.
#include "app/workbench.hpp"

#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "app/panels/memory.hpp"
#include "app/theme.hpp"
#include "core/assets.hpp"
#include "core/charts/image.hpp"
#include "core/scene/scene_io.hpp"
#include "render/overlay.hpp"
#include "tests/app/stage.hpp"
#include "tests/temporary_folder.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;
namespace fs = std::filesystem;

namespace {

Vec3 particle_place(const Snapshot& s, std::size_t p) {
  Vec3 x = Vec3::Zero();
  for (int a = 0; a < s.dimension; ++a)
    x[a] = s.x[p * static_cast<std::size_t>(s.dimension) + static_cast<std::size_t>(a)];
  return x;
}

}  // namespace

TEST_CASE("every shipped scene opens, steps, and shows its material where the snapshot says") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  for (const auto& entry : fs::directory_iterator(asset_path("scenes"))) {
    if (entry.path().extension() != ".json") continue;
    CAPTURE(entry.path().string());
    const std::uint64_t run = stage.context().status.run;
    stage->open_scene(load_scene(entry.path()), entry.path(), false);
    REQUIRE(stage.until([&] { return stage.context().status.run > run; }));
    REQUIRE(stage.ready());
    REQUIRE(stage.steps(1));
    stage.frames(4);
    const Snapshot& s = *stage.context().snapshot;
    CHECK(s.dimension == stage.context().scene.dimension);
    // Particles' pixels against the same picture without them.
    const Image with = stage.picture();
    stage.context().view.show_particles = false;
    stage.frames(3);
    const Image without = stage.picture();
    stage.context().view.show_particles = true;
    REQUIRE(with.width == without.width);
    const ViewSize size{with.width, with.height};
    const double scale = static_cast<double>(with.width) / static_cast<double>(stage->view().place().width);
    const Camera camera = stage->view().picture_camera(
        size, overlay_margins(s.dimension, size.width / scale, size.height / scale), scale);
    int inside = 0, shown = 0;
    for (std::size_t p = 0; p < s.particles; p += 1 + s.particles / 200) {
      const auto at = to_pixel(camera, particle_place(s, p), size);
      if (!at || at->x() < 0 || at->y() < 0 || at->x() >= size.width || at->y() >= size.height) continue;
      ++inside;
      const int x = static_cast<int>(at->x());
      const int y = static_cast<int>(at->y());
      shown += with.color(x, y) == without.color(x, y) ? 0 : 1;
    }
    CHECK(inside > 20);  // fitted: the body is in view
    CHECK(shown >= 0.9 * inside);
  }
}

TEST_CASE("the window shows panels around the view, and the view its material") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  REQUIRE(stage.steps(1));
  stage.frames(6);
  const Image window = stage->screenshot();
  CHECK(window.width == 1280);
  CHECK(window.height == 800);
  const auto color = [&](float x, float y) { return window.color(static_cast<int>(x), static_cast<int>(y)); };
  const auto near = [](Color a, Color b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) < 0.02f;
  };
  const Palette& p = palette(Theme::dark);
  CHECK(near(color(2, stage->layout().left.bottom() - 2), p.window));
  CHECK(near(color(stage->layout().transport.x + 2, stage->layout().transport.y + 2), p.bar));
  const auto centre = stage->view().to_window(Vec3(0, 0.5, 0));
  const auto beside = stage->view().to_window(Vec3(0.6, 0.9, 0));
  REQUIRE(centre);
  REQUIRE(beside);
  CHECK_FALSE(near(color(centre->x, centre->y), color(beside->x, beside->y)));
  CHECK_FALSE(near(color(centre->x, centre->y), {0, 0, 0, 1}));
}

TEST_CASE("edits reach the simulation, refused ones say where, undo takes them back") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  REQUIRE(stage.steps(1));
  const auto applied = [&] { return context.status.edit.applies_at_step < 0; };

  CHECK(context.change({{"/gravity", {0, 5}}}));
  CHECK(context.unsaved);
  REQUIRE(stage.until(applied));
  const double before = context.snapshot->report.balance.momentum.y();
  REQUIRE(stage.steps(1));
  CHECK(context.snapshot->report.balance.momentum.y() > before);  // it falls upwards now

  CHECK_FALSE(context.change({{"/materials/rubber/poisson", 0.7}}));
  REQUIRE_FALSE(context.problems.empty());
  CHECK(context.problems[0].pointer == "/materials/rubber/poisson");
  CHECK(context.scene.materials[0].parameters == small().materials[0].parameters);

  CHECK(context.change({{"/grid/spacing", 0.05}}));
  REQUIRE(stage.until([&] { return context.status.edit.needs_reset; }));
  CHECK(context.snapshot->spacing == doctest::Approx(0.1));
  stage->act(Action::reset);
  REQUIRE(stage.until([&] { return context.snapshot->spacing < 0.06; }));
  CHECK_FALSE(context.status.edit.needs_reset);

  stage->act(Action::undo);
  stage->act(Action::undo);
  CHECK(context.scene == small());
  CHECK_FALSE(stage->possible(Action::undo));
  stage->act(Action::redo);
  CHECK(context.scene.gravity.y() == 5);
}

TEST_CASE("a paused window that nobody touches draws nothing") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  for (int i = 0; i < 40; ++i) stage->frame(0.02);
  const long before = stage->frames_drawn();
  for (int i = 0; i < 20; ++i) stage->frame(0.02);
  CHECK(stage->frames_drawn() == before);
}

TEST_CASE("a new field is drawn although the run is paused") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  REQUIRE(stage.steps(1));
  stage->act(Action::field, 1);
  const auto field = static_cast<std::size_t>(stage.context().view.field);
  CHECK(stage.until([&] { return !stage.context().snapshot->field[field].empty(); }));
  stage->act(Action::grid);
  CHECK(stage.until([&] { return stage.context().snapshot->nodes > 0; }));
}

TEST_CASE("save, open, recent files and preferences survive the window") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  AppContext& context = stage.context();
  const fs::path file = stage.folder / "ball.json";
  save_scene(small(), file);
  context.open_file(file);
  REQUIRE(stage.ready());
  CHECK(context.scene_file == file);
  CHECK(context.change({{"/time/end", 2.5}}));
  CHECK(context.unsaved);
  context.view.color_by(Field::J);
  context.view.lock_range = true;
  context.view.range_min = 0.5;
  context.view.range_max = 2;
  stage->act(Action::save);
  CHECK_FALSE(context.unsaved);
  CHECK(load_scene(file).time.end == 2.5);
  // The scene is saved as it is seen, and comes back so.
  context.view.color_by(Field::speed);
  context.open_file(file);
  REQUIRE(stage.ready());
  CHECK(context.view.field == Field::J);
  CHECK(context.view.lock_range);
  CHECK(context.view.range_min == 0.5);
  CHECK(context.view.range_max == 2);

  context.view.theme = Theme::light;
  const fs::path broken = stage.folder / "broken.json";
  std::ofstream(broken) << R"({"dimension": 4})";
  context.open_file(broken);
  CHECK(context.scene_file == file);  // the old scene stays
  CHECK_FALSE(context.problems.empty());
  stage.frames(3);
  const PreferenceFolders folders{stage.folder / "config", stage.folder / "state"};
  stage.bench.reset();
  const Preferences kept = load_preferences(folders);
  CHECK(kept.theme == Theme::light);
  REQUIRE_FALSE(kept.recent.empty());
  CHECK(kept.recent[0] == file);
}

TEST_CASE("pinned curves stay while the next run is drawn") {
  NEEDS_DISPLAY();
  Stage stage(small());
  REQUIRE(stage.ready());
  REQUIRE(stage.steps(3));
  AppContext& context = stage.context();
  CHECK(context.current.reports.size() == 4);
  context.pin();
  stage->act(Action::reset);
  REQUIRE(stage.until([&] { return context.current.reports.size() == 1; }));
  REQUIRE(context.pinned.size() == 1);
  CHECK(context.pinned[0].pinned);
  CHECK(context.pinned[0].reports.size() == 4);
  REQUIRE(stage.steps(2));
  context.pin();
  stage.frames(3);
  REQUIRE(context.pinned.size() == 2);
  const auto& kept = memory(context).plots.pinned;
  REQUIRE(kept.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {  // each run's curves are its own, the newest first
    CAPTURE(i);
    CHECK(context.pinned[i].reports.size() == 4 - (1 - i));
    CHECK(kept[i].curves.size() == context.pinned[i].reports.size());
  }
}

TEST_CASE("nothing is cut sideways at any scale, in both themes") {
  NEEDS_DISPLAY();
  for (const float scale : {1.0f, 2.0f}) {
    Stage stage(small(), false, scale);
    REQUIRE(stage.ready());
    REQUIRE(stage.steps(1));
    stage.context().selected_particle = 3;
    for (const Theme theme : {Theme::dark, Theme::light}) {
      stage.context().view.theme = theme;
      stage->act(Action::grid);
      stage.frames(12);
      CHECK(ImGui::GetFontSize() == doctest::Approx(15 * scale).epsilon(0.05));
      for (const ImGuiWindow* window : GImGui->Windows) {
        if (!window->Active || window->Hidden) continue;
        CAPTURE(std::string(window->Name));
        CHECK(window->ScrollMax.x <= 0);
        CHECK(window->ContentSize.x <= window->ContentRegionRect.GetWidth() + 1);
      }
    }
  }
}

TEST_CASE("a frame costs the window's thread less than 16 ms while the worker is busy") {
  NEEDS_DISPLAY();
  Stage stage(shipped("welcome"));
  REQUIRE(stage.ready());
  stage.frames(10);
  // Whether a scene is shown or switched must not depend on what a step costs: only that nothing waits is checked.
  stage->act(Action::run_pause);
  REQUIRE(stage.until([&] { return stage.context().status.step_in_flight; }));
  const auto begin = Clock::now();
  stage->act(Action::run_pause);
  stage.frames(1);
  CHECK(stage.context().status.state == RunState::paused);
  CHECK(Clock::now() - begin < std::chrono::milliseconds(500));  // of a loaded machine that draws in software
}
