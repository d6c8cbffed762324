#include "core/runner.hpp"

#include <doctest/doctest.h>

#include "fake_simulation.hpp"
#include "scene.hpp"

using namespace pf;
using namespace pf::test;

namespace {

struct Recorder : RunObserver {
  std::vector<long> states;
  std::vector<std::pair<long, long>> frames;  ///< number, step
  int ends = 0;
  void on_state(const Simulation& simulation) override { states.push_back(simulation.report().step); }
  void on_frame(const Simulation& simulation, long number) override {
    frames.emplace_back(number, simulation.report().step);
  }
  void on_end(const Simulation& /*simulation*/, const RunResult& /*result*/) override { ++ends; }
};

using Frames = std::vector<std::pair<long, long>>;

Recorder run(FreeFlight& simulation, const RunLimits& limits = {}) {
  Recorder recorder;
  Runner runner(simulation);
  runner.add(recorder);
  runner.run(limits);
  return recorder;
}

}  // namespace

TEST_CASE("a run shows the initial state and every step up to the end") {
  FreeFlight simulation(small_scene(2, time_member(0.5, 0.1, 0.1)));
  const Recorder recorder = run(simulation);
  CHECK(recorder.states == std::vector<long>{0, 1, 2, 3, 4, 5});
  CHECK(simulation.time() == 0.5);
  CHECK(recorder.ends == 1);
}

TEST_CASE("a frame is due at the first step at or after its time; the first and the last state always") {
  SUBCASE("frames every 2.5 steps: at steps 0, 3, 5, 8, 10") {
    FreeFlight simulation(small_scene(2, time_member(1, 0.1, 0.25)));
    CHECK(run(simulation).frames == Frames{{0, 0}, {1, 3}, {2, 5}, {3, 8}, {4, 10}});
  }
  SUBCASE("rounding of n * step does not delay a frame: 0.1 + 0.1 + 0.1 is 3 * 0.1") {
    FreeFlight simulation(small_scene(2, time_member(0.7, 0.1, 0.1)));
    CHECK(run(simulation).frames == Frames{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}});
  }
  SUBCASE("a step longer than the interval is one frame") {
    FreeFlight simulation(small_scene(2, time_member(1, 0.5, 0.1)));
    CHECK(run(simulation).frames == Frames{{0, 0}, {1, 1}, {2, 2}});
  }
  SUBCASE("a last state that is not due is shown all the same, once") {
    FreeFlight simulation(small_scene(2, time_member(0.5, 0.1, 0.4)));
    CHECK(run(simulation).frames == Frames{{0, 0}, {1, 4}, {2, 5}});
  }
}

TEST_CASE("the limit of steps and the end: the first reached wins") {
  FreeFlight limited(small_scene(2, time_member(1, 0.1, 1)));
  CHECK(run(limited, {.steps = 3}).states.back() == 3);
  FreeFlight ended(small_scene(2, time_member(1, 0.1, 1)));
  CHECK(run(ended, {.steps = 30}).states.back() == 10);
  FreeFlight none(small_scene(2, time_member(1, 0.1, 1)));
  CHECK(run(none, {.steps = 0}).states == std::vector<long>{0});
}

TEST_CASE("a failed step ends the run with its reason; the last good state is shown") {
  FreeFlight simulation(small_scene(2, time_member(1, 0.1, 1)));
  simulation.fail_after = 4;
  Recorder recorder;
  Runner runner(simulation);
  runner.add(recorder);
  const RunResult result = runner.run();
  CHECK(result.end == RunEnd::failed);
  CHECK(result.last_attempt.failure == "particle 1 went away");
  CHECK(recorder.frames == Frames{{0, 0}, {1, 4}});
  CHECK(recorder.ends == 1);
}

TEST_CASE("an interrupted run ends between steps") {
  FreeFlight simulation(small_scene(2, time_member(1, 0.1, 1)));
  struct Interrupter : RunObserver {
    std::atomic<bool> flag{false};
    void on_state(const Simulation& s) override { flag = s.report().step == 2; }
  } interrupter;
  Runner runner(simulation);
  runner.add(interrupter);
  CHECK(runner.run({}, &interrupter.flag).end == RunEnd::interrupted);
  CHECK(simulation.report().step == 2);
}

TEST_CASE("events are applied before the first step that begins at or after their time, in order of time") {
  const std::string events = R"(, "events": [
    {"time": 0.3, "set": {"/transfer/flip_ratio": 0.25}},
    {"time": 0,    "set": {"/transfer/flip_ratio": 0.5}},
    {"time": 0.31, "set": {"/solver/max_newton": 9}}])";
  FreeFlight simulation(small_scene(2, time_member(1, 0.1, 1) + events));
  run(simulation);
  CHECK(simulation.applied == std::vector<long>{0, 3, 4});
  CHECK(simulation.scene().transfer.flip_ratio == 0.25);
  CHECK(simulation.scene().solver.max_newton == 9);
}

TEST_CASE("frames and events go on where a cursor says") {
  FreeFlight simulation(small_scene(2, time_member(1, 0.1, 0.25)));
  while (simulation.report().step < 4) simulation.step(nullptr);
  Recorder recorder;
  Runner runner(simulation, {.frames = 2, .next_due = 2, .events = 0});
  runner.add(recorder);
  runner.run();
  CHECK(recorder.frames == Frames{{2, 5}, {3, 8}, {4, 10}});
}
