// What hands do to a running simulation: pins and pushes act at once, are taken back, replay and rewind to the byte.
#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include "core/keyframes.hpp"
#include "core/runner.hpp"
#include "core/scene/scene_io.hpp"
#include "tests/session/watched.hpp"

using namespace pf;
using namespace pf::app;
using namespace std::chrono_literals;

namespace {

std::string text_of(int dimension) {
  const bool flat = dimension == 2;
  return std::string(R"({"dimension": )") + (flat ? "2" : "3") + R"(, "gravity": [0, -9.81)" + (flat ? "" : ", 0") +
         R"(], "grid": {"spacing": 0.1}, "time": {"end": 1, "step": 0.01},
    "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3},
                  "steel": {"model": "hencky", "density": 2000, "young": 1e6, "poisson": 0.2}},
    "bodies": [{"name": "box", "material": "rubber", "shape": {"type": "box", "min": )" +
         (flat ? "[0, 0], \"max\": [0.8, 0.4]" : "[0, 0, 0], \"max\": [0.6, 0.3, 0.3]") + R"(}}]})";
}

std::string state_of(const Simulation& simulation) {
  std::ostringstream out;
  simulation.save_state(out);
  return std::move(out).str();
}

struct Live : WatchedSession {
  Scene scene;

  explicit Live(const Scene& start) : scene(start) {
    session.open(scene, false);
    wait([](const SessionStatus& s) { return s.state == RunState::paused; });
  }
  void send(const Scene& next) {
    const auto before = session.snapshot();
    session.edit(next);
    // The picture comes after the word that the edit has been applied.
    wait([&](const SessionStatus& s) { return s.edit.applies_at_step < 0 && session.snapshot() != before; });
    CHECK_FALSE(session.status().edit.needs_reset);
  }
  void edit(const std::vector<Edit>& edits) { send(scene = edited(scene, edits)); }
  void go_to(long step) {
    session.go_to(step);
    wait([=](const SessionStatus& s) { return s.step == step && s.target < 0; });
    session.pause();  // answered once the worker is idle
    std::this_thread::sleep_for(5ms);
  }

  /// The record, run without a window, ends in the same bytes; so does going back and forward again.
  void check_replay() {
    const long end = session.status().step;
    const std::string bytes = state_of(*simulation);
    const std::string saved = scene_text(session.recorded());
    const auto again = make_simulation(parse_scene(saved, "record"));
    Runner runner(*again);
    runner.run({.steps = end});
    CHECK(state_of(*again) == bytes);
    for (const long back : {end / 2, 1L}) {
      go_to(back);
      go_to(end);
      CHECK(state_of(*simulation) == bytes);
    }
  }
};

nlohmann::json ball(const std::vector<double>& centre, double radius) {
  return {{"type", "ball"}, {"center", centre}, {"radius", radius}};
}

Vec3 mean(const Simulation& simulation) {
  Vec3 sum = Vec3::Zero();
  double mass = 0;
  for (const ParticleState& p : simulation.particles()) sum += p.mass * p.x, mass += p.mass;
  return sum / mass;
}

}  // namespace

TEST_CASE("a pin holds the material at once, and lets it go again") {
  for (const int d : {2, 3}) {
    CAPTURE(d);
    Live live(parse_scene(text_of(d), "test"));
    live.steps(5);
    const auto corner = [&] {
      const ParticleState first = live.simulation->particle(0);
      return first.x;
    };
    const Vec3 at = corner();
    std::vector<double> centre{at.x(), at.y(), at.z()};
    centre.resize(static_cast<std::size_t>(d));
    const std::vector<bool> fix(static_cast<std::size_t>(d), true);
    live.edit({{"/constraints/-", {{"region", ball(centre, 0.2)}, {"fix", fix}}}});
    CHECK(live.session.snapshot()->scene->regions.size() == 1);
    live.steps(12);
    CHECK((corner() - at).norm() < 0.02);                                    // held
    CHECK(mean(*live.simulation).y() < -0.01 + 0.5 * (d == 2 ? 0.4 : 0.3));  // the rest hangs
    live.edit({{"/constraints", nlohmann::json::array()}});
    CHECK(live.session.snapshot()->scene->regions.empty());
    const double before = live.simulation->report().balance.momentum.y();
    live.steps(6);
    // It falls freely again.
    CHECK(live.simulation->report().balance.momentum.y() - before ==
          doctest::Approx(-9.81 * 0.06 * live.simulation->mass()).epsilon(1e-6));
    live.check_replay();
  }
}

TEST_CASE("a ball pushes the material aside, leaves no trace in the scene, and replays") {
  for (const int d : {2, 3}) {
    CAPTURE(d);
    Scene start = parse_scene(text_of(d), "test", std::vector<Edit>{{"/gravity/1", 0}});
    Live live(start);
    live.steps(2);
    std::vector<double> centre{-0.25, 0.2, 0.15}, right{2.0, 0, 0}, none{0, 0, 0};
    for (auto* v : {&centre, &right, &none}) v->resize(static_cast<std::size_t>(d));
    Scene pushing =
        edited(start, std::vector<Edit>{{"/boundaries/-", {{"shape", ball(centre, 0.2)}, {"contact", "separate"}}}});
    live.send(pushing);
    CHECK(live.session.snapshot()->boundary_displacement.size() == 1);
    live.steps(2);
    CHECK(live.simulation->report().balance.momentum.norm() < 1e-9);
    pushing = edited(pushing, std::vector<Edit>{{"/boundaries/0/velocity", right}});
    live.send(pushing);
    live.steps(10);
    CHECK(live.session.snapshot()->boundary_displacement[0].x() == doctest::Approx(0.2));
    CHECK(live.simulation->report().balance.momentum.x() > 0);
    const Vec3 pushed = live.simulation->report().balance.momentum;
    live.send(start);  // the ball goes
    CHECK(live.session.snapshot()->boundary_displacement.empty());
    live.steps(3);
    // Nothing pushes any more.
    CHECK((live.simulation->report().balance.momentum - pushed).norm() < 1e-6 * pushed.norm());
    live.check_replay();
  }
}

TEST_CASE("cuts and paint replay, rewind and are taken back to the byte") {
  for (const int d : {2, 3})
    for (const std::size_t memory : {Keyframes::default_budget, std::size_t{0}}) {
      CAPTURE(d);
      CAPTURE(memory);
      Live live(parse_scene(text_of(d), "test"));
      live.session.set_rewind_memory(memory);
      const auto work = [&](const Stroke& stroke, std::uint64_t gesture) {
        const auto before = live.session.snapshot();
        live.session.stroke(stroke, gesture);
        live.wait([&](const SessionStatus&) { return live.session.snapshot() != before; });
      };
      const auto ball_of = [&](double x, double y) {
        Shape shape;
        shape.type = "ball";
        shape.center = Vec3(x, y, d == 3 ? 0.15 : 0);
        shape.radius = 0.12;
        return shape;
      };
      live.steps(6);
      const std::size_t all = live.simulation->particle_count();
      const std::string whole = state_of(*live.simulation);
      work({"cut", ball_of(0.3, 0.15), ""}, 1);
      work({"cut", ball_of(0.3, 0.05), ""}, 1);
      CHECK(live.session.status().stroke_is_newest);
      const std::size_t left = live.session.snapshot()->particles;
      CHECK(left < all);
      CHECK(live.session.snapshot()->report.strokes.cut == all - left);
      CHECK(live.session.snapshot()->id.size() == left);
      live.steps(5);
      work({"paint", ball_of(0.1, 0.1), "steel"}, 2);
      live.edit({{"/gravity/1", -5.0}});
      live.steps(5);
      REQUIRE(live.session.recorded().events.size() == 4);
      live.check_replay();
      for (const long step : {6L, 8L, 11L, 16L, 2L, 16L}) live.go_to(step);
      CHECK(live.simulation->report().strokes.cut == all - left);
      // Another stroke in the past: what came later is forgotten. Then it is taken back, and the run stands there
      // whole.
      live.go_to(9);
      work({"cut", ball_of(0.5, 0.2), ""}, 3);
      CHECK(live.session.status().reached == 9);
      live.steps(3);
      live.check_replay();
      live.session.take_back_strokes();
      live.wait([](const SessionStatus& s) { return s.step == 9 && s.reached == 9 && s.target < 0; });
      CHECK(live.session.snapshot()->particles == left);
      live.session.take_back_strokes();  // of gesture 1, both
      live.wait([](const SessionStatus& s) { return s.step == 6 && s.reached == 6 && s.target < 0; });
      live.session.pause();
      std::this_thread::sleep_for(5ms);
      CHECK(state_of(*live.simulation) == whole);
      CHECK_FALSE(live.session.status().stroke_is_newest);
      live.session.take_back_strokes();
      live.steps(1);
      CHECK(live.simulation->particle_count() == all);
    }
}

TEST_CASE("strokes that were taken back come back to the byte, at the steps that they were done at") {
  Live live(parse_scene(text_of(2), "test"));
  const auto ball_at = [](double x, double y) {
    Shape shape;
    shape.type = "ball";
    shape.center = Vec3(x, y, 0);
    shape.radius = 0.12;
    return shape;
  };
  const auto cut = [&](double x, double y, std::uint64_t gesture) {
    const auto before = live.session.snapshot();
    live.session.stroke({"cut", ball_at(x, y), ""}, gesture);
    live.wait([&](const SessionStatus&) { return live.session.snapshot() != before; });
  };
  const auto stands = [&](long step, std::size_t particles) {
    live.wait([&](const SessionStatus& s) {
      return s.step == step && s.reached == step && s.target < 0 && live.session.snapshot()->particles == particles;
    });
    live.session.pause();
    std::this_thread::sleep_for(5ms);
  };
  live.steps(4);
  const std::size_t all = live.simulation->particle_count();
  cut(0.3, 0.15, 1);
  const std::size_t once = live.simulation->particle_count();
  live.steps(2);
  cut(0.1, 0.05, 2);  // a drag over three steps
  live.steps(3);
  cut(0.1, 0.2, 2);
  const std::size_t twice = live.simulation->particle_count();
  const std::string done = state_of(*live.simulation);
  const Scene recorded = live.session.recorded();
  REQUIRE(twice < once);
  live.session.take_back_strokes();
  stands(6, once);
  live.session.take_back_strokes();
  stands(4, all);
  CHECK(live.session.status().stroke_was_taken_back);
  live.steps(3);  // what was simulated without them is forgotten
  live.session.bring_back_strokes();
  stands(4, once);
  live.session.bring_back_strokes();
  stands(9, twice);
  CHECK(state_of(*live.simulation) == done);
  CHECK(live.session.recorded() == recorded);
  CHECK_FALSE(live.session.status().stroke_was_taken_back);
  live.steps(2);  // a record that ends sooner does not get to its last event
  live.check_replay();
  // Something new comes in the place of what was taken back.
  live.session.take_back_strokes();
  stands(6, once);
  cut(0.5, 0.2, 3);
  CHECK_FALSE(live.session.status().stroke_was_taken_back);
}

TEST_CASE("a stroke that would leave nothing is refused with a word, and leaves no record") {
  Live live(parse_scene(text_of(2), "test"));
  live.steps(3);
  const std::string before = state_of(*live.simulation);
  Shape all;
  all.type = "ball";
  all.radius = 9;
  live.session.stroke({"cut", all, ""}, 1);
  live.wait([](const SessionStatus& s) { return !s.message.empty(); });
  CHECK(live.session.status().message.find("all particles") != std::string::npos);
  CHECK(state_of(*live.simulation) == before);
  CHECK(live.session.recorded().events.empty());
}

TEST_CASE("a probe that is placed is read at once, in the past too, and is no edit of the run") {
  Live live(parse_scene(text_of(2), "test"));
  live.steps(8);
  live.go_to(5);
  live.edit({{"/probes/-", {{"name", "tip"}, {"at", {0.825, 0.375}}}}});
  REQUIRE(live.session.snapshot()->probes.size() == 1);
  CHECK((live.session.snapshot()->probes[0].X - Vec3(0.775, 0.375, 0)).norm() < 1e-9);
  CHECK(live.session.status().reached == 8);  // what came after is still there
  CHECK(live.session.recorded().events.empty());
  CHECK(live.session.recorded().probes.size() == 1);
  live.go_to(2);
  CHECK(live.session.snapshot()->probes.size() == 1);
  live.go_to(8);
  live.steps(2);
  std::vector<HistorySample> samples;
  live.session.drain_history(samples);
  CHECK(samples.back().probes.size() == 1);
  CHECK(samples.back().probes[0].x.y() < 0.375);
  live.edit({{"/probes", nlohmann::json::array()}});
  CHECK(live.session.snapshot()->probes.empty());
}

TEST_CASE("a wall from the middle of the list waits for the reset") {
  Scene start = parse_scene(text_of(2), "test");
  const nlohmann::json floor{{"shape", {{"type", "half_space"}, {"point", {0, -1}}, {"normal", {0, 1}}}}};
  const nlohmann::json wall{{"shape", {{"type", "half_space"}, {"point", {2, 0}}, {"normal", {-1, 0}}}}};
  start = edited(start, std::vector<Edit>{{"/boundaries/-", floor}, {"/boundaries/-", wall}});
  Live live(start);
  live.steps(2);
  Scene next = start;
  next.boundaries.erase(next.boundaries.begin());
  live.session.edit(next);
  live.wait([](const SessionStatus& s) { return s.edit.applies_at_step < 0; });
  CHECK(live.session.status().edit.needs_reset);
  CHECK(live.simulation->scene().boundaries.size() == 2);
}
