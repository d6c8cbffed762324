// The window never waits for the worker, and the worker answers within a frame, whatever a step costs.
#include <doctest/doctest.h>

#include <thread>

#include "app/session.hpp"
#include "tests/session/fake_simulation.hpp"

using namespace pf;
using namespace pf::app;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

Scene scene_of(double step, double end) {
  Scene scene;
  scene.name = "fake";
  scene.gravity = {0, -9.81, 0};
  scene.grid.spacing = 0.1;
  scene.time.step = step;
  scene.time.end = end;
  scene.materials = {{"m", "neo_hookean", 1000, {{"young", 1e5}, {"poisson", 0.3}}}};
  Body body;
  body.name = "b";
  body.material = "m";
  body.shape.type = "ball";
  body.shape.radius = 1;
  scene.bodies = {body};
  return scene;
}

struct Stage {
  test::FakeControl control;
  Session session{1, [this](const Scene& scene, const SimulationOptions&) {
                    return std::make_unique<test::FakeSimulation>(scene, control);
                  }};

  template <typename Condition>
  bool until(Condition condition, Clock::duration limit = 10s) {
    const auto deadline = Clock::now() + limit;
    while (!condition(session.status())) {
      if (Clock::now() > deadline) return false;
      std::this_thread::sleep_for(200us);
    }
    return true;
  }
  void open(const Scene& scene, bool run) {
    session.open(scene, run);
    REQUIRE(until([](const SessionStatus& s) { return s.state != RunState::loading; }));
  }
};

double seconds_of(const auto& what) {
  const auto begin = Clock::now();
  what();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

constexpr double frame = 0.016;
// Sanitizers and a loaded machine slow everything but the step that nobody may wait for.
constexpr double generous = 0.2;

}  // namespace

TEST_CASE("a step of 5 s: pause takes effect within a frame and the state stays the last accepted one") {
  Stage stage;
  stage.open(scene_of(0.01, 1), false);
  stage.control.step_seconds = 5;
  stage.session.run();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.step_in_flight; }));
  CHECK(seconds_of([&] { stage.session.pause(); }) < frame);
  CHECK(stage.session.status().state == RunState::paused);  // what the next frame shows
  CHECK(seconds_of([&] { REQUIRE(stage.until([](const SessionStatus& s) { return !s.step_in_flight; })); }) < generous);
  CHECK(stage.session.status().step == 0);
  CHECK(stage.control.steps_cancelled == 1);
}

TEST_CASE("a step of 5 s: an edit is acknowledged at once and never cancels it") {
  Stage stage;
  stage.open(scene_of(0.01, 1), false);
  stage.control.step_seconds = 1;
  stage.session.run();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.step_in_flight; }));
  Scene changed = scene_of(0.01, 1);
  for (int i = 1; i <= 50; ++i) {  // a dragged slider
    changed.gravity.y() = -i;
    CHECK(seconds_of([&] { stage.session.edit(changed); }) < frame);
    const Acknowledgement said = stage.session.status().edit;
    CHECK(said.edit == static_cast<std::uint64_t>(i));
    CHECK(said.applies_at_step == 1);
  }
  CHECK(stage.control.gravity_seen == 0);  // not in the middle of the step
  REQUIRE(stage.until([](const SessionStatus& s) { return s.edit.applies_at_step < 0; }));
  CHECK(stage.session.status().step >= 1);
  CHECK(stage.control.gravity_seen == -50);
  CHECK(stage.control.steps_cancelled == 0);
}

TEST_CASE("a suspended session takes no step whatever it is told, and goes on where it was") {
  Stage stage;
  stage.open(scene_of(0.01, 100), true);
  REQUIRE(stage.until([](const SessionStatus& s) { return s.step > 0; }));
  stage.control.step_seconds = 5;
  REQUIRE(stage.until([](const SessionStatus& s) { return s.step_in_flight; }));
  CHECK(seconds_of([&] { stage.session.suspend(true); }) < frame);
  REQUIRE(stage.until([](const SessionStatus& s) { return s.suspended; }));
  const long step = stage.session.status().step, begun = stage.control.steps_begun;
  CHECK_FALSE(stage.session.status().step_in_flight);
  CHECK(stage.session.status().state == RunState::running);
  stage.control.step_seconds = 0;
  stage.session.pause();
  stage.session.step_once();
  stage.session.run();
  stage.session.edit(scene_of(0.02, 100));
  std::this_thread::sleep_for(50ms);
  CHECK(stage.control.steps_begun == begun);
  stage.session.open(scene_of(0.01, 100), true);  // built and shown, not run
  REQUIRE(stage.until([](const SessionStatus& s) { return s.run == 2 && s.state == RunState::running; }));
  std::this_thread::sleep_for(50ms);
  CHECK(stage.session.status().suspended);
  CHECK(stage.session.status().step == 0);
  stage.session.suspend(false);
  CHECK(stage.until([&](const SessionStatus& s) { return !s.suspended && s.step > step; }));
}

TEST_CASE("another scene is shown while a long step runs") {
  Stage stage;
  stage.open(scene_of(0.01, 1), false);
  stage.control.step_seconds = 5;
  stage.session.run();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.step_in_flight; }));
  const std::uint64_t run = stage.session.status().run;
  const double took = seconds_of([&] {
    stage.session.open(scene_of(0.02, 3), false);
    REQUIRE(stage.until([&](const SessionStatus& s) { return s.run > run && s.state == RunState::paused; }));
  });
  CHECK(took < generous);
  CHECK(stage.control.steps_cancelled == 1);
}

TEST_CASE("the session ends within a frame although a step runs") {
  test::FakeControl control;
  control.step_seconds = 5;
  auto session = std::make_unique<Session>(1, [&](const Scene& scene, const SimulationOptions&) {
    return std::make_unique<test::FakeSimulation>(scene, control);
  });
  session->open(scene_of(0.01, 1), true);
  while (!session->status().step_in_flight) std::this_thread::sleep_for(1ms);
  CHECK(seconds_of([&] { session.reset(); }) < generous);
}

TEST_CASE("playback follows the rate and says which one it reaches") {
  Stage stage;
  stage.open(scene_of(0.005, 100), false);
  for (const double rate : {1.0, 0.25}) {
    stage.session.set_rate(rate);
    stage.session.run();
    const double before = stage.session.status().time;
    std::this_thread::sleep_for(600ms);
    const SessionStatus status = stage.session.status();
    stage.session.pause();
    CHECK(status.time - before == doctest::Approx(0.6 * rate).epsilon(0.25));
    CHECK(status.achieved_rate == doctest::Approx(rate).epsilon(0.2));
  }
  stage.session.set_rate(0);
  stage.session.run();
  std::this_thread::sleep_for(200ms);
  CHECK(stage.session.status().achieved_rate > 5);
}

TEST_CASE("steps slower than the rate are not followed by a sprint") {
  Stage stage;
  stage.open(scene_of(0.01, 100), false);
  stage.control.step_seconds = 0.3;
  stage.session.run();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.step >= 2; }));
  stage.control.step_seconds = 0;
  const long step = stage.session.status().step;
  std::this_thread::sleep_for(200ms);
  CHECK(stage.session.status().step - step < 45);  // 20 in real time, and at most 0.1 s to catch up
}

TEST_CASE("snapshots come at display rate while running and at every state while paused") {
  Stage stage;
  stage.open(scene_of(1e-4, 1e9), false);
  stage.session.set_rate(0);
  const long before = stage.control.captures;
  stage.session.run();
  std::this_thread::sleep_for(500ms);
  stage.session.pause();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.state == RunState::paused && !s.step_in_flight; }));
  CHECK(stage.control.captures - before <= 33);
  CHECK(stage.control.captures - before >= 10);
  for (int i = 0; i < 3; ++i) {
    const long step = stage.session.status().step;
    stage.session.step_once();
    REQUIRE(stage.until([&](const SessionStatus& s) { return s.step == step + 1 && !s.step_in_flight; }));
    CHECK(stage.session.snapshot()->report.step == step + 1);
  }
}
