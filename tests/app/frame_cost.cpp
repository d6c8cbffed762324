// What frames cost, and how soon the window answers: the table of docs/performance.md, and what must hold of it. CPU
// time, apart for the window's thread and for the threads of a software renderer; the clock says more about what else
// the machine does.
#include <doctest/doctest.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/workbench.hpp"
#include "core/assets.hpp"
#include "core/scene/scene_io.hpp"
#include "tests/app/display.hpp"

using namespace pf;
using namespace pf::app;

namespace {

using Clock = std::chrono::steady_clock;

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// CPU seconds of all threads of this process whose name begins so; 0 where the system does not tell.
double named_seconds(const std::string& name) {
  double ticks = 0;
  std::error_code error;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", error)) {
    std::string comm, field;
    std::getline(std::ifstream(task.path() / "comm"), comm);
    if (!comm.starts_with(name)) continue;
    std::string line;
    std::getline(std::ifstream(task.path() / "stat"), line);
    std::istringstream rest(line.substr(line.rfind(')') + 2));
    for (int k = 3; k < 14; ++k) rest >> field;  // utime and stime are fields 14 and 15 of proc(5)
    double user = 0, system = 0;
    rest >> user >> system;
    ticks += user + system;
  }
  return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// CPU time a frame [ms].
struct Cost {
  double window = 0, rasteriser = 0;
};

std::string text(const Cost& c) {
  char line[96];
  std::snprintf(line, sizeof line, "%5.1f ms + %5.1f ms in the rasteriser's threads", c.window, c.rasteriser);
  return line;
}

Workbench::Setup setup() {
  Workbench::Setup s;
  s.run = false;
  s.remember = false;
  s.folders = {"/nonexistent", "/nonexistent"};
  return s;
}

struct Stage {
  Workbench bench;
  explicit Stage(const Scene& scene) : bench(scene, {}, setup()) {
    while (!bench.context().snapshot || bench.context().status.state == RunState::loading) bench.frame(0.01);
    for (int i = 0; i < 20; ++i) bench.frame(0.01);
  }
  /// Of frames that each follow on `cause`.
  template <typename Cause>
  Cost of(int frames, const Cause& cause) {
    const double window = thread_seconds(), rasteriser = named_seconds("llvmpipe");
    for (int k = 0; k < frames; ++k) {
      const long before = bench.frames_drawn();
      cause(k);
      while (bench.frames_drawn() == before) bench.frame(0);
    }
    const double all = 1e3 / frames;
    return {all * (thread_seconds() - window), all * (named_seconds("llvmpipe") - rasteriser)};
  }
  Cost interface() {
    return of(30, [&](int) { bench.act(Action::deselect); });
  }
  /// The camera moved or an option changed: the same data, drawn again.
  Cost redrawn() {
    return of(30, [&](int k) { bench.context().view.bent_magnification = 1 + k, bench.act(Action::deselect); });
  }
  /// A new state from the worker.
  Cost renewed() {
    return of(20, [&](int) {
      const auto seen = bench.context().snapshot;
      bench.act(Action::field, bench.context().view.field == Field::speed ? 1 : 0);
      while (bench.context().snapshot == seen) bench.frame(0.001);
      bench.act(Action::deselect);
    });
  }
  void report(const char* name) {
    MESSAGE(std::string(name), ", ", bench.context().snapshot->particles, " particles, ", bench.view().size().width,
            " x ", bench.view().size().height, std::string(bench.view().software() ? ", software renderer" : ""));
    MESSAGE("  panels only:    ", text(interface()));
    MESSAGE("  redrawn:        ", text(redrawn()));
    MESSAGE("  with new state: ", text(renewed()));
  }
};

Scene shipped(const char* name) {
  return load_scene(asset_path("scenes") / (std::string(name) + ".json"));
}

/// A unit square or cube with two particles a cell and axis.
Scene block(int dimension, double spacing) {
  const bool flat = dimension == 2;
  const nlohmann::json zero = flat ? nlohmann::json{0, 0} : nlohmann::json{0, 0, 0};
  const nlohmann::json one = flat ? nlohmann::json{1, 1} : nlohmann::json{1, 1, 1};
  const nlohmann::json scene{
      {"dimension", dimension},
      {"gravity", flat ? nlohmann::json{0, -9.81} : nlohmann::json{0, -9.81, 0}},
      {"grid", {{"spacing", spacing}}},
      {"materials", {{"rubber", {{"model", "neo_hookean"}, {"density", 1000}, {"young", 1e5}, {"poisson", 0.3}}}}},
      {"bodies",
       nlohmann::json::array(
           {{{"name", "block"}, {"material", "rubber"}, {"shape", {{"type", "box"}, {"min", zero}, {"max", one}}}}})}};
  return parse_scene(scene.dump(), "test");
}

Scene hundred_thousand() {
  return block(2, 0.0064);
}

#define NEEDS_DISPLAY()                                                  \
  if (const std::string why = test::display_or_reason(); !why.empty()) { \
    MESSAGE("skipped: ", why);                                           \
    return;                                                              \
  }

}  // namespace

TEST_SUITE("long") {
  TEST_CASE("cost of frames") {
    NEEDS_DISPLAY();
    Stage(shipped("welcome")).report("welcome");
    Stage(shipped("twisted-bar")).report("twisted-bar");
    Stage(shipped("torus-on-ball")).report("torus-on-ball");
    Stage(hundred_thousand()).report("a block");
    Stage(block(3, 1. / 23)).report("a cube");
    Stage(block(2, 0.002)).report("a block");
    Stage(block(3, 0.02)).report("a cube");
  }

  TEST_CASE("100 thousand particles: a frame costs the window's thread at most 16 ms") {
    NEEDS_DISPLAY();
    Stage stage(hundred_thousand());
    REQUIRE(stage.bench.context().snapshot->particles > 95'000);
    CHECK(stage.interface().window < 16);
    CHECK(stage.redrawn().window < 16);
  }

  TEST_CASE("100 thousand particles: pause and edits are acknowledged in the next frame while a step takes seconds") {
    NEEDS_DISPLAY();
    // A soft block that hangs and may fall for long in one step: Newton has much to do.
    const nlohmann::json held{{"region", {{"type", "box"}, {"min", {0, 0.95}}, {"max", {1, 1}}}},
                              {"fix", {true, true}}};
    Stage stage(edited(hundred_thousand(), std::vector<Edit>{{"/constraints", nlohmann::json::array({held})},
                                                             {"/materials/rubber/young", 1e4},
                                                             {"/time/step", 0.3},
                                                             {"/time/end", 100}}));
    AppContext& context = stage.bench.context();
    stage.bench.act(Action::run_pause);
    while (!context.status.step_in_flight) stage.bench.frame(0.001);
    for (int k = 0; k < 5; ++k) stage.bench.frame(0.01);
    REQUIRE(context.status.step_in_flight);  // still the same long step
    const long step = context.status.step;
    REQUIRE(context.change({{"/gravity", {0, -5}}}));
    double begin = thread_seconds();
    stage.bench.frame(0);
    MESSAGE("an edit is shown after ", 1e3 * (thread_seconds() - begin), " ms of CPU");
    CHECK(context.status.edit.applies_at_step == step + 1);
    begin = thread_seconds();
    stage.bench.act(Action::run_pause);
    stage.bench.frame(0);
    MESSAGE("a pause is shown after ", 1e3 * (thread_seconds() - begin), " ms of CPU");
    CHECK(context.status.state == RunState::paused);
  }

  TEST_CASE("switching scenes") {
    NEEDS_DISPLAY();
    Stage stage(shipped("colliding-discs"));
    AppContext& context = stage.bench.context();
    for (const char* name : {"welcome", "stretched-strip", "twisted-bar", "torus-on-ball"}) {
      const Scene scene = shipped(name);
      const std::uint64_t run = context.status.run;
      const auto begin = Clock::now();
      timespec from{}, to{};
      clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &from);
      stage.bench.open_scene(scene, {}, false);
      while (context.status.run == run) stage.bench.frame(0.01);
      clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &to);
      const double cpu =
          static_cast<double>(to.tv_sec - from.tv_sec) + 1e-9 * static_cast<double>(to.tv_nsec - from.tv_nsec);
      MESSAGE(std::string(name), ": shown after ", 1e3 * std::chrono::duration<double>(Clock::now() - begin).count(),
              " ms, ", 1e3 * cpu, " ms of CPU in all threads");
      CHECK(context.snapshot->dimension == scene.dimension);
    }
  }

  TEST_CASE("the first picture of the welcome scene comes within half a second") {
    NEEDS_DISPLAY();
    const auto begin = Clock::now();
    const double cpu = thread_seconds();
    Workbench bench(shipped("welcome"), {}, setup());
    while (!bench.context().snapshot || bench.frames_drawn() == 0) bench.frame(0.01);
    const double shown = std::chrono::duration<double>(Clock::now() - begin).count();
    const double spent = thread_seconds() - cpu;
    MESSAGE("first picture after ", shown, " s, of which the window's thread worked ", spent, " s");
    CHECK(spent < 0.5);
  }
}
