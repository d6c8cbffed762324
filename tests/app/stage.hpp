// The whole window on a scratch folder, driven turn by turn.
#pragma once

#include <doctest/doctest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/workbench.hpp"
#include "core/assets.hpp"
#include "core/charts/image.hpp"
#include "core/scene/scene_io.hpp"
#include "tests/app/display.hpp"
#include "tests/temporary_folder.hpp"

namespace pf::app::staged {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;

/// A window on a scratch folder. Not shown, so that a person at the machine is not disturbed.
struct Stage {
  test::TemporaryFolder scratch;
  const fs::path& folder = scratch.path();
  std::unique_ptr<Workbench> bench;

  explicit Stage(const Scene& scene, bool visible = false, float ui_scale = 1, bool drawer_open = false) {
    fs::create_directories(folder / "pictures");
    Workbench::Setup setup;
    setup.visible = visible;
    setup.run = false;
    setup.folders = {folder / "config", folder / "state"};
    setup.pictures = folder / "pictures";
    setup.studies = folder / "studies";
    if (ui_scale != 1 || drawer_open) {
      Preferences p;
      p.ui_scale = ui_scale;
      p.drawer_open = drawer_open;
      save_preferences(p, setup.folders);
    }
    bench = std::make_unique<Workbench>(scene, fs::path(), setup);
  }
  ~Stage() { bench.reset(); }
  Workbench* operator->() { return bench.get(); }
  AppContext& context() { return bench->context(); }

  void frames(int count) {
    for (int i = 0; i < count; ++i) bench->frame(0.002);
  }
  /// Turns the loop until `done`, at most a minute (sanitizers, loaded machines).
  bool until(const std::function<bool()>& done) {
    const auto deadline = Clock::now() + std::chrono::minutes(1);
    while (!done()) {
      if (Clock::now() > deadline) return false;
      bench->frame(0.005);
    }
    return true;
  }
  bool ready() {
    frames(1);  // what was asked for last is known from then on
    return until([this] { return context().snapshot && context().status.state != RunState::loading; });
  }
  bool steps(long count) {
    for (long i = 0; i < count; ++i) {
      const long step = context().status.step;
      bench->act(Action::step);
      if (!until([&] { return context().status.step > step && !context().status.step_in_flight; })) return false;
    }
    return until([this] { return context().snapshot->report.step == context().status.step; });
  }
  Image picture() {
    bench->act(Action::picture);
    fs::path file;
    until([&] {
      for (const auto& entry : fs::directory_iterator(folder / "pictures")) file = entry.path();
      return !file.empty();
    });
    Image image = read_image(file);
    fs::remove(file);
    return image;
  }
};

inline Scene shipped(const std::string& name) {
  return load_scene(asset_path("scenes") / (name + ".json"));
}

inline Scene small() {
  return parse_scene(R"({"name": "Small ball", "dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.1},
      "time": {"end": 1, "step": 0.005},
      "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
      "bodies": [{"name": "ball", "material": "rubber", "shape": {"type": "ball", "center": [0, 0.5], "radius": 0.4}}],
      "boundaries": [{"shape": {"type": "half_space", "point": [0, 0], "normal": [0, 1]}, "contact": "stick"}]})",
                     "test");
}

}  // namespace pf::app::staged

#define NEEDS_DISPLAY()                                                      \
  if (const std::string why = pf::test::display_or_reason(); !why.empty()) { \
    MESSAGE("skipped: ", why);                                               \
    return;                                                                  \
  }
