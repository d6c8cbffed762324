// Going back and forward again gives the same bytes; a session with edits replays them without a window.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "app/session.hpp"
#include "core/keyframes.hpp"
#include "core/output/stats.hpp"
#include "core/scene/scene_io.hpp"
#include "core/simulation.hpp"
#include "tests/temporary_folder.hpp"

using namespace pf;
using namespace pf::app;
using namespace std::chrono_literals;

namespace {

Scene falling(const std::string& more = "") {
  return parse_scene(R"({"dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.1},
    "time": {"end": 1, "step": 0.01})" +
                         more + R"(,
    "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e4, "poisson": 0.3}},
    "bodies": [{"name": "ball", "material": "rubber", "velocity": [1, 0],
                "shape": {"type": "ball", "center": [0, 0.35], "radius": 0.3}}],
    "boundaries": [{"shape": {"type": "half_space", "point": [0, 0], "normal": [0, 1]}, "friction": 0.3}],
    "events": [{"time": 0.025, "set": {"/gravity/0": 2}}]})",
                     "test");
}

/// Every step's complete state, as it was when the run came there first.
struct Watched {
  Simulation* simulation = nullptr;
  std::map<long, std::string> seen;
  Session session{1, [this](const Scene& scene, const SimulationOptions& options) {
                    auto made = make_simulation(scene, options);
                    simulation = made.get();
                    return made;
                  }};

  explicit Watched(const Scene& scene) {
    session.open(scene, false);
    wait([](const SessionStatus& s) { return s.state == RunState::paused; });
  }
  void wait(auto condition) {
    for (int i = 0; i < 300000 && !condition(session.status()); ++i) std::this_thread::sleep_for(100us);
    REQUIRE(condition(session.status()));
  }
  /// While the worker is idle.
  std::string state() const {
    std::ostringstream out;
    simulation->save_state(out);
    return out.str();
  }
  void step() {
    const long step = session.status().step;
    session.step_once();
    wait([=](const SessionStatus& s) { return s.step == step + 1 && !s.step_in_flight; });
  }
  void steps(long count) {
    for (long i = 0; i < count; ++i) {
      step();
      seen[session.status().step] = state();
    }
  }
  void edit(const Scene& scene) {
    session.edit(scene);
    wait([](const SessionStatus& s) { return s.edit.applies_at_step < 0; });
    seen[session.status().step] = state();  // what "auto" has counted is forgotten by some
  }
  void go_to(long step) {
    session.go_to(step);
    wait([=](const SessionStatus& s) { return s.target < 0 && !s.step_in_flight; });
    REQUIRE(session.status().step == step);
    REQUIRE(simulation->report().step == step);
  }
};

Scene with(const Scene& scene, const std::vector<Edit>& edits) {
  return edited(scene, edits);
}

}  // namespace

TEST_CASE("going back and forth through a run with edits, events and a pull by the mouse gives the same bytes") {
  for (const std::size_t memory : {Keyframes::default_budget, std::size_t{0}}) {
    for (const char* control :
         {R"(, "integrator": {"type": "generalized_alpha"})", R"(, "transfer": {"type": "apic"})"}) {
      CAPTURE(memory);
      CAPTURE(control);
      const Scene start = falling(control);
      Watched live(start);
      live.session.set_rewind_memory(memory);
      live.seen[0] = live.state();
      live.steps(7);
      Scene now = with(start, {{"/materials/rubber/young", 3e4}});
      live.edit(now);
      live.steps(6);
      live.session.set_grab(Grab{{0.1, 0.3, 0}, {0.2, 0.6, 0}, 0.2});
      live.steps(3);
      live.session.set_grab(Grab{{0.1, 0.3, 0}, {0.4, 0.7, 0}, 0.2});
      live.steps(4);
      live.session.set_grab(std::nullopt);
      live.steps(5);
      now = with(now, {{"/gravity/1", 3.0}});
      live.edit(now);
      live.steps(9);
      REQUIRE(live.session.status().reached == 34);
      for (const long step : {33L, 5L, 6L, 14L, 15L, 16L, 8L, 7L, 1L, 0L, 20L, 34L, 26L, 12L}) {
        CAPTURE(step);
        live.go_to(step);
        CHECK((live.state() == live.seen.at(step)));
        CHECK(live.session.snapshot()->report.step == step);
        CHECK(live.session.status().reached == 34);
      }
      // On from the past without an edit: the same, up to the end and beyond.
      live.go_to(10);
      while (live.session.status().step < 34) {
        live.step();
        const long step = live.session.status().step;
        CHECK((live.state() == live.seen.at(step)));
      }
      CHECK(live.session.status().branches == 0);
    }
  }
}

TEST_CASE("an edit of a past state begins another run from there, with the scene as it is shown") {
  const Scene start = falling();
  Watched live(start);
  live.steps(5);
  Scene now = with(start, {{"/materials/rubber/young", 3e4}});
  live.edit(now);
  live.steps(15);
  live.go_to(12);
  const auto before = live.seen;
  now = with(now, {{"/gravity/1", -2.0}});
  live.edit(now);
  CHECK(live.session.status().branches == 1);
  CHECK(live.session.status().reached == 12);
  live.steps(8);
  CHECK((live.seen.at(20) != before.at(20)));
  live.go_to(12);
  CHECK((live.state() == live.seen.at(12)));
  live.go_to(20);
  CHECK((live.state() == live.seen.at(20)));

  // Back before the first edit: going on from there takes the scene as shown, both edits at once.
  live.go_to(3);
  live.session.branch();
  live.wait([](const SessionStatus& s) { return s.branches == 2 && s.edit.applies_at_step < 0; });
  live.steps(4);
  const auto other = make_simulation(start);
  for (int k = 0; k < 3; ++k) other->step();
  other->apply(with(other->scene(), {{"/gravity/0", 2}}));  // its own event
  other->apply(with(other->scene(), {{"/materials/rubber/young", 3e4}, {"/gravity/1", -2.0}}));
  for (int k = 0; k < 4; ++k) other->step();
  std::ostringstream expected;
  other->save_state(expected);
  CHECK((live.state() == expected.str()));
}

TEST_CASE("an edit on the way to a past state waits for it") {
  Watched live(falling());
  live.session.set_rewind_memory(0);
  live.steps(20);
  live.session.go_to(15);
  live.session.edit(with(falling(), {{"/gravity/1", 1.0}}));
  live.wait([](const SessionStatus& s) { return s.target < 0 && s.edit.applies_at_step < 0 && s.branches == 1; });
  CHECK(live.session.status().reached == 15);
  const Scene recorded = live.session.recorded();
  REQUIRE(recorded.events.size() == 2);
  CHECK(recorded.events[1].time == doctest::Approx(0.15));
}

TEST_CASE("a run that failed goes back, and fails at the same step again") {
  Scene scene = falling();
  scene.events = {{0.1, {{"/body_force", {"0*sqrt(0.15-t)", "0"}}}, {}}};
  Watched live(scene);
  live.session.set_rate(0);
  live.session.run();
  live.wait([](const SessionStatus& s) { return s.state == RunState::failed; });
  const long last = live.session.status().reached;
  REQUIRE(last >= 9);
  live.go_to(last - 3);
  CHECK(live.session.status().state == RunState::paused);
  live.session.run();
  live.wait([](const SessionStatus& s) { return s.state == RunState::failed; });
  CHECK(live.session.status().reached == last);
}

TEST_CASE("a session with edits and branches, saved and run without a window, gives the same stats to the byte") {
  const Scene start = falling();
  Watched live(start);
  live.steps(5);
  Scene now = with(start, {{"/transfer/type", "apic"}});
  live.edit(now);
  live.steps(6);
  // There and back at one state: FLIP has forgotten APIC's affine velocities.
  live.edit(with(now, {{"/transfer/type", "flip"}}));
  live.edit(now);
  live.steps(10);
  live.go_to(14);
  now = with(now, {{"/materials/rubber/young", 5e4}, {"/gravity/1", -3.0}});
  live.edit(now);
  live.steps(10);
  live.edit(with(now, {{"/boundaries/0/friction", 0.8}, {"/boundaries/0/contact", "separate"}}));
  live.steps(6);
  CHECK(live.session.recording_warning().empty());

  std::map<long, std::string> rows;
  std::vector<HistorySample> samples;
  live.session.drain_history(samples);
  for (HistorySample& sample : samples) {
    const long step = sample.report.step;
    rows.erase(rows.upper_bound(step), rows.end());  // of the branch that was left
    sample.report.ms.total = 0;
    rows[step] = stats_row(sample.report, {2, false});
  }

  const test::TemporaryFolder folder;
  const auto file = folder.path() / "recorded.json";
  save_scene(live.session.recorded(), file);
  const std::string command = std::string(PUSHFORWARD_BINARY) + " run " + file.string() + " --steps 30 --quiet --out " +
                              (folder.path() / "out").string() + " > /dev/null";
  REQUIRE(std::system(command.c_str()) == 0);
  std::ifstream stats(folder.path() / "out" / "stats.csv");
  std::string line;
  std::getline(stats, line);
  // Wall time, the stable step (asked for by the writer of the file) and whether Newton converged stand last.
  const auto without_wall = [](std::string row) {
    for (int cell = 0; cell < 3; ++cell) row.resize(row.rfind(','));
    return row;
  };
  for (long step = 0; step <= 30; ++step) {
    CAPTURE(step);
    REQUIRE(std::getline(stats, line));
    CHECK(without_wall(line) == without_wall(rows.at(step)));
  }
}
