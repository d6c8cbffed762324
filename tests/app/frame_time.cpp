// Frames while an implicit step goes on for about a second: how long the window takes for each, by the clock and of CPU
// time, and what keyframes of the run take of memory. The figures of docs/performance.md:
//   ./test.sh -L long -R 'while a step takes a second|keyframes of a long run' -V
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "tests/app/hand.hpp"

using namespace pf;
using namespace pf::app;
using namespace pf::app::staged;

namespace {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A block of some 40 thousand particles that hangs and may fall for long in each step: Newton has much to do.
Scene slow_block() {
  Scene scene = parse_scene(R"({"name": "Slow block", "dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.01},
      "time": {"end": 100, "step": 0.2},
      "materials": {"soft": {"model": "neo_hookean", "density": 1000, "young": 1e4, "poisson": 0.3}},
      "bodies": [{"name": "block", "material": "soft", "shape": {"type": "box", "min": [0, 0], "max": [1, 1]}}],
      "constraints": [{"region": {"type": "box", "min": [0, 0.95], "max": [1, 1]}, "fix": [true, true]}]})",
                            "test");
  return scene;
}

struct Times {
  std::vector<double> wall, cpu;  ///< of frames, sorted [ms]

  double median(const std::vector<double>& t) const { return t[t.size() / 2]; }
  void sort() {
    std::sort(wall.begin(), wall.end());
    std::sort(cpu.begin(), cpu.end());
  }
};

/// Frames that `cause` asks for, while steps are under way, for so long.
Times frames_while_stepping(Stage& stage, double seconds, const std::function<void(int)>& cause) {
  Times times;
  const auto begin = Clock::now();
  for (int k = 0; std::chrono::duration<double>(Clock::now() - begin).count() < seconds; ++k) {
    const long drawn = stage->frames_drawn();
    cause(k);
    const auto from = Clock::now();
    const double cpu = thread_seconds();
    stage->frame(0);
    if (stage->frames_drawn() == drawn || !stage.context().status.step_in_flight) continue;
    times.wall.push_back(std::chrono::duration<double, std::milli>(Clock::now() - from).count());
    times.cpu.push_back(1e3 * (thread_seconds() - cpu));
  }
  times.sort();
  return times;
}

void report(const char* what, const Times& t) {
  MESSAGE(std::string(what), ": ", t.wall.size(), " frames, median ", t.median(t.wall), " ms by the clock, worst ",
          t.wall.back(), "; of CPU in the window's thread median ", t.median(t.cpu), ", worst ", t.cpu.back());
}

}  // namespace

TEST_SUITE("long") {
  TEST_CASE("the window answers while a step takes a second") {
    NEEDS_DISPLAY();
    Stage stage(slow_block());
    REQUIRE(stage.ready());
    AppContext& context = stage.context();
    context.session.set_rate(0);
    stage->act(Action::run_pause);
    REQUIRE(stage.until([&] { return context.status.step >= 2 && context.status.step_in_flight; }));
    GlfwWindow::Pointer mouse{};
    const Times panels = frames_while_stepping(stage, 8, [&](int k) {
      mouse.x = static_cast<float>(20 + k % 200);
      mouse.y = static_cast<float>(100 + k % 500);
      stage->feed(mouse);
    });
    const Times camera = frames_while_stepping(stage, 8, [&](int k) {
      mouse.x = 700;
      mouse.y = 400;
      mouse.wheel = k % 2 ? 0.2F : -0.2F;
      stage->feed(mouse);
    });
    MESSAGE(context.snapshot->particles, " particles, ", context.status.step_ms, " ms a step");
    report("the mouse over the panels", panels);
    report("the camera moved in every frame", camera);
    REQUIRE(panels.cpu.size() > 20);
    REQUIRE(camera.cpu.size() > 20);
    // The clock is the machine's business, the thread's own time is ours.
    CHECK(panels.median(panels.cpu) < 8);
    CHECK(panels.cpu.back() < 50);
    CHECK(camera.median(camera.cpu) < 16);
    CHECK(camera.cpu.back() < 60);
    stage->act(Action::run_pause);
  }

  TEST_CASE("keyframes of a long run stay within their budget, and so does the process") {
    NEEDS_DISPLAY();
    const auto resident = [] {
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;  // counted in KiB
    };
    Scene scene = shipped("twisted-bar");
    scene.time.end = 100;
    Stage stage(scene);
    REQUIRE(stage.ready());
    AppContext& context = stage.context();
    context.session.set_rate(0);
    constexpr std::size_t budget = std::size_t{32} << 20;
    context.session.set_rewind_memory(0);
    stage->act(Action::run_pause);
    REQUIRE(stage.until([&] { return context.status.step >= 40; }));
    CHECK(context.status.rewind_bytes == 0);
    const double without = resident();
    context.session.set_rewind_memory(budget);
    stage->act(Action::reset);
    std::size_t most = 0;
    REQUIRE(stage.until([&] {
      most = std::max(most, context.status.rewind_bytes);
      return context.status.run == 2 && context.status.step >= 260;
    }));
    stage->act(Action::run_pause);
    const double with = resident();
    MESSAGE(context.snapshot->particles, " particles, ", context.status.step, " steps: keyframes took at most ",
            static_cast<double>(most) / 1e6, " MB of ", static_cast<double>(budget) / 1e6, " MB; the process grew by ",
            with - without, " MB");
    CHECK(most <= budget);
    CHECK(most > budget / 4);  // and made use of it
    CHECK(with - without < 1.25 * static_cast<double>(budget) / 1e6 + 8);
  }
}
