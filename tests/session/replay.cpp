// A recorded live session, run without a window, gives the same state to the byte.
#include <doctest/doctest.h>

#include <sstream>

#include "core/runner.hpp"
#include "core/scene/scene_io.hpp"
#include "tests/session/watched.hpp"

using namespace pf;
using namespace pf::app;
using namespace std::chrono_literals;

namespace {

constexpr const char* falling_ball = R"({"dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.1},
    "time": {"end": 1, "step": 0.01},
    "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e4, "poisson": 0.3}},
    "bodies": [{"name": "ball", "material": "rubber", "velocity": [1, 0],
                "shape": {"type": "ball", "center": [0, 0.35], "radius": 0.3}}],
    "boundaries": [{"shape": {"type": "half_space", "point": [0, 0], "normal": [0, 1]}}],
    "events": [{"time": 0.025, "set": {"/gravity/0": 2}}]})";

std::string state_of(const Simulation& simulation) {
  std::ostringstream out;
  for (const ParticleState& p : simulation.particles()) {
    out.write(reinterpret_cast<const char*>(p.x.data()), sizeof(double) * 3);
    out.write(reinterpret_cast<const char*>(p.v.data()), sizeof(double) * 3);
    out.write(reinterpret_cast<const char*>(p.F.data()), sizeof(double) * 9);
  }
  return out.str();
}

struct Edited : WatchedSession {
  void edit(const Scene& scene) {
    session.edit(scene);
    wait([](const SessionStatus& s) { return s.edit.applies_at_step < 0; });
  }
};

}  // namespace

TEST_CASE("a session edited live replays byte-equal from its record") {
  const Scene start = parse_scene(falling_ball, "test");
  Edited live;
  live.session.open(start, false);
  live.wait([](const SessionStatus& s) { return s.state == RunState::paused; });
  live.steps(5);
  live.edit(edited(start, std::vector<Edit>{{"/transfer/flip_ratio", 0.5}}));
  live.steps(3);
  live.edit(edited(start, std::vector<Edit>{{"/transfer/flip_ratio", 0.5}, {"/materials/rubber/young", 2e4}}));
  live.steps(1);
  live.edit(edited(start, std::vector<Edit>{{"/materials/rubber/young", 2e4}, {"/gravity/1", -5.0}}));
  live.steps(4);

  // Through the text of the file, as a user would replay it.
  const Scene recorded = parse_scene(scene_text(live.session.recorded()), "recorded");
  CHECK(recorded.events.size() == 4);
  const auto replay = make_simulation(recorded);
  Runner(*replay).run({live.session.status().step});
  CHECK(replay->time() == live.session.status().time);
  CHECK((state_of(*replay) == state_of(*live.simulation)));

  // The edits did change the motion.
  const auto unedited = make_simulation(start);
  Runner(*unedited).run({replay->report().step});
  CHECK((state_of(*unedited) != state_of(*replay)));
}

TEST_CASE("a pause in the middle of a step leaves no trace") {
  const Scene start = parse_scene(falling_ball, "test");
  Edited live;
  live.session.set_rate(0);
  live.session.open(start, false);
  live.wait([](const SessionStatus& s) { return s.state == RunState::paused; });
  for (int i = 0; i < 20; ++i) {
    live.session.run();
    std::this_thread::sleep_for(3ms);
    live.session.pause();
    live.wait([](const SessionStatus& s) { return !s.step_in_flight; });
  }
  // The worker may be just before a step that is no longer wanted: its answer to a question shows it idle.
  live.session.look({0, std::nullopt});
  while (!live.session.looked()) std::this_thread::sleep_for(1ms);
  const auto straight = make_simulation(start);
  REQUIRE(live.session.status().step > 0);
  Runner(*straight).run({live.session.status().step});
  CHECK((state_of(*straight) == state_of(*live.simulation)));
}
