// What running, ending, failing and resetting do to the state, the history and the record.
#include <doctest/doctest.h>

#include <thread>

#include "app/session.hpp"
#include "core/scene/scene_io.hpp"
#include "tests/session/fake_simulation.hpp"

using namespace pf;
using namespace pf::app;
using namespace std::chrono_literals;

namespace {

Scene scene_of(double step, double end) {
  return parse_scene(R"({"dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.1},
      "materials": {"m": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
      "bodies": [{"name": "b", "material": "m", "shape": {"type": "ball", "center": [0, 0], "radius": 1}}]})",
                     "test", std::vector<Edit>{{"/time/step", step}, {"/time/end", end}});
}

struct Stage {
  test::FakeControl control;
  Session session{1, [this](const Scene& scene, const SimulationOptions&) {
                    if (scene.name == "too large") throw InputError("", {{"/bodies", "1 TB", "less"}});
                    return std::make_unique<test::FakeSimulation>(scene, control);
                  }};
  template <typename Condition>
  bool until(Condition condition) {
    for (int i = 0; i < 50000; ++i) {
      if (condition(session.status())) return true;
      std::this_thread::sleep_for(200us);
    }
    return false;
  }
  bool reaches(RunState state) {
    return until([=](const SessionStatus& s) { return s.state == state && !s.step_in_flight; });
  }
};

}  // namespace

TEST_CASE("at the end the session pauses, plays again, goes on or loops as told") {
  Stage stage;
  stage.session.set_rate(0);
  stage.session.open(scene_of(0.01, 0.1), true);
  REQUIRE(stage.reaches(RunState::finished));
  CHECK(stage.session.status().step == 10);
  CHECK(stage.session.snapshot()->report.step == 10);

  stage.session.run();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.run == 2; }));
  REQUIRE(stage.reaches(RunState::finished));

  stage.session.set_at_end(AtEnd::go_on);
  stage.session.run();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.step > 20; }));
  CHECK(stage.session.status().run == 2);
  stage.session.pause();

  stage.session.set_at_end(AtEnd::loop);
  stage.session.reset();
  stage.session.run();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.run >= 5; }));
}

TEST_CASE("a failed step leaves the last good state and its message, and a change lets the run go on") {
  Stage stage;
  stage.session.set_rate(0);
  stage.control.fail_at = 3;
  stage.session.open(scene_of(0.01, 1), true);
  REQUIRE(stage.reaches(RunState::failed));
  CHECK(stage.session.status().step == 3);
  CHECK(stage.session.snapshot()->report.step == 3);
  CHECK(stage.session.status().message == "particle 2 turned inside out");
  stage.control.fail_at = -1;
  stage.session.edit(scene_of(0.005, 1));
  REQUIRE(stage.reaches(RunState::paused));
  stage.session.run();
  REQUIRE(stage.reaches(RunState::finished));
}

TEST_CASE("a scene that cannot be built says why and the next one opens") {
  Stage stage;
  Scene large = scene_of(0.01, 1);
  large.name = "too large";
  stage.session.open(large, true);
  REQUIRE(stage.until([](const SessionStatus& s) { return s.state == RunState::failed; }));
  CHECK(stage.until([](const SessionStatus& s) { return s.message.find("/bodies") != std::string::npos; }));
  stage.session.run();
  stage.session.step_once();
  stage.session.open(scene_of(0.01, 1), false);
  REQUIRE(stage.reaches(RunState::paused));
  CHECK(stage.session.status().message.empty());
}

TEST_CASE("history holds every accepted state of a run, once and in order") {
  Stage stage;
  stage.session.set_rate(0);
  stage.session.open(scene_of(0.01, 0.5), true);
  REQUIRE(stage.reaches(RunState::finished));
  std::vector<HistorySample> samples;
  stage.session.drain_history(samples);
  REQUIRE(samples.size() == 51);
  for (std::size_t i = 0; i < samples.size(); ++i) CHECK(samples[i].report.step == static_cast<long>(i));
  stage.session.drain_history(samples);
  CHECK(samples.size() == 51);
}

TEST_CASE("a setting that needs a reset waits for it, and undoing the change takes the wait back") {
  Stage stage;
  stage.session.open(scene_of(0.01, 1), false);
  REQUIRE(stage.reaches(RunState::paused));
  Scene finer = scene_of(0.01, 1);
  finer.grid.spacing = 0.05;
  stage.session.edit(finer);
  REQUIRE(stage.until([](const SessionStatus& s) { return s.edit.applies_at_step < 0 && s.edit.needs_reset; }));
  finer.gravity.y() = -1;  // live settings go through all the same
  stage.session.edit(finer);
  REQUIRE(stage.until([](const SessionStatus& s) { return s.edit.applies_at_step < 0; }));
  CHECK(stage.control.gravity_seen == -1);
  CHECK(stage.session.status().edit.needs_reset);
  stage.session.edit(scene_of(0.01, 1));
  REQUIRE(stage.until([](const SessionStatus& s) { return s.edit.applies_at_step < 0; }));
  CHECK_FALSE(stage.session.status().edit.needs_reset);
  stage.session.edit(finer);
  stage.session.reset();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.run == 2 && s.state == RunState::paused; }));
  CHECK_FALSE(stage.session.status().edit.needs_reset);
}

TEST_CASE("the record holds each live change as an event at the time of the state that it changed") {
  Stage stage;
  const Scene start = scene_of(0.01, 1);
  stage.session.open(start, false);
  REQUIRE(stage.reaches(RunState::paused));
  for (int i = 1; i <= 2; ++i) {
    stage.session.step_once();
    REQUIRE(stage.until([=](const SessionStatus& s) { return s.step == i && !s.step_in_flight; }));
  }
  Scene changed = start;
  changed.gravity.y() = -5;
  stage.session.edit(changed);
  changed.gravity.y() = -4;
  stage.session.edit(changed);
  REQUIRE(stage.until([](const SessionStatus& s) { return s.edit.applies_at_step < 0; }));
  const Scene recorded = stage.session.recorded();
  REQUIRE(recorded.events.size() == 1);
  CHECK(recorded.events[0].time == stage.session.status().time);
  REQUIRE(recorded.events[0].set.size() == 1);
  CHECK(edited(start, recorded.events[0].set) == changed);
  CHECK(recorded.gravity == start.gravity);
  CHECK(stage.session.recording_warning().empty());

  stage.session.set_grab(Grab{{0, 0, 0}, {1, 0, 0}, 0.1});
  stage.session.step_once();
  REQUIRE(stage.until([](const SessionStatus& s) { return s.step == 3; }));
  CHECK_FALSE(stage.session.recording_warning().empty());
}

TEST_CASE("only the requested fields are captured, and a new request is answered while paused") {
  Stage stage;
  stage.session.request({1u << static_cast<unsigned>(Field::speed), false, false});
  stage.session.open(scene_of(0.01, 1), false);
  REQUIRE(stage.reaches(RunState::paused));
  CHECK(stage.session.snapshot()->field[static_cast<std::size_t>(Field::J)].empty());
  stage.session.request({1u << static_cast<unsigned>(Field::J), false, false});
  REQUIRE(stage.until([&](const SessionStatus&) {
    return stage.session.snapshot()->field[static_cast<std::size_t>(Field::J)].size() == 3;
  }));
  CHECK(stage.session.snapshot()->field[static_cast<std::size_t>(Field::speed)].empty());
}

TEST_CASE("the inspector's question is answered between steps") {
  Stage stage;
  stage.session.open(scene_of(0.01, 1), false);
  stage.session.look({2, std::nullopt});
  std::optional<Look> answer;
  REQUIRE(stage.until([&](const SessionStatus&) { return (answer = stage.session.looked()).has_value(); }));
  REQUIRE(answer->particle);
  CHECK(answer->particle->state.id == 2);
  CHECK_FALSE(stage.session.looked());
}

TEST_CASE("a step that throws while states wait to be shown ends the run, not the program") {
  Stage stage;
  stage.control.throw_at = 50;  // as fast as possible: hardly one state in a hundred is shown
  stage.session.set_rate(0);
  stage.session.open(scene_of(0.01, 10), true);
  REQUIRE(stage.reaches(RunState::failed));
  CHECK(stage.session.status().message.find("out of everything") != std::string::npos);
  stage.session.pause();
  stage.session.run();
  stage.session.step_once();
  stage.session.set_grab(Grab{});
  stage.session.request({});
  stage.session.look({0, std::nullopt});
  stage.session.edit(scene_of(0.02, 10));
  REQUIRE(stage.until([](const SessionStatus& s) { return s.edit.applies_at_step < 0; }));
  CHECK(stage.session.status().state == RunState::failed);
  CHECK(stage.session.snapshot() != nullptr);

  stage.control.throw_at = -1;
  stage.session.reset();
  REQUIRE(stage.reaches(RunState::paused));
}

TEST_CASE("a state that cannot be captured ends the run, not the program") {
  Stage stage;
  stage.session.open(scene_of(0.01, 10), false);
  REQUIRE(stage.reaches(RunState::paused));
  stage.control.capture_throws = true;
  SnapshotRequest other;
  other.grid = true;
  stage.session.request(other);
  REQUIRE(stage.reaches(RunState::failed));
  CHECK_FALSE(stage.session.status().message.empty());
  stage.control.capture_throws = false;
  stage.session.reset();
  REQUIRE(stage.reaches(RunState::paused));
}
