// What a frame costs the window's thread with many particles; apart from the short tests for the time it takes.
#include <doctest/doctest.h>
#include <unistd.h>

#include <ctime>

#include "app/workbench.hpp"
#include "core/assets.hpp"
#include "core/scene/scene_io.hpp"
#include "tests/app/display.hpp"

using namespace pf;
using namespace pf::app;

namespace {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

TEST_SUITE("long") {
  TEST_CASE("100 thousand particles: a frame costs the window's thread at most 16 ms") {
    if (const std::string why = test::display_or_reason(); !why.empty()) {
      MESSAGE("skipped: ", why);
      return;
    }
    const Scene scene = parse_scene(R"({"dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.0064},
        "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
        "bodies": [{"name": "block", "material": "rubber", "shape": {"type": "box", "min": [0, 0], "max": [1, 1]}}]})",
                                    "test");
    Workbench::Setup setup;
    setup.run = false;
    setup.remember = false;
    setup.folders = {"/nonexistent", "/nonexistent"};
    Workbench bench(scene, {}, setup);
    while (!bench.context().snapshot) bench.frame(0.01);
    REQUIRE(bench.context().snapshot->particles > 95'000);
    for (int i = 0; i < 20; ++i) bench.frame(0.01);
    const auto cost = [&](Action reason) {
      const long before = bench.frames_drawn();
      const double begin = thread_seconds();
      while (bench.frames_drawn() < before + 50) {
        bench.act(reason);
        bench.frame(0);
      }
      return (thread_seconds() - begin) / 50;
    };
    const double interface = cost(Action::deselect), picture = cost(Action::grid);
    MESSAGE("CPU time a frame: ", 1e3 * interface, " ms, with a new picture ", 1e3 * picture, " ms");
    CHECK(interface < 0.016);
    // A processor that plays the graphics card needs longer for 100 thousand squares.
    if (!bench.view().software()) CHECK(picture < 0.016);
  }

  TEST_CASE("the first picture of the welcome scene comes within half a second") {
    if (const std::string why = test::display_or_reason(); !why.empty()) {
      MESSAGE("skipped: ", why);
      return;
    }
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const double cpu = thread_seconds();
    Workbench::Setup setup;
    setup.remember = false;
    setup.folders = {"/nonexistent", "/nonexistent"};
    Workbench bench(load_scene(asset_path("scenes/welcome.json")), {}, setup);
    while (!bench.context().snapshot || bench.frames_drawn() == 0) bench.frame(0.01);
    const double shown = std::chrono::duration<double>(Clock::now() - begin).count();
    const double spent = thread_seconds() - cpu;
    MESSAGE("first picture after ", shown, " s, of which the window's thread worked ", spent, " s");
    CHECK(spent < 0.5);  // the clock says more about what else the machine does
  }
}
