// Runs compared side by side: at the same time, each what it would be alone.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <thread>

#include "app/compare/comparison.hpp"
#include "core/params/problem.hpp"
#include "core/runner.hpp"
#include "core/scene/scene_io.hpp"

using namespace pf;
using namespace pf::app;

namespace {

Scene ball() {
  return parse_scene(R"({"name": "Ball", "dimension": 2, "gravity": [0, -9.81], "grid": {"spacing": 0.1},
      "time": {"end": 0.2, "step": 0.01},
      "materials": {"rubber": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0.3}},
      "bodies": [{"name": "ball", "material": "rubber", "shape": {"type": "ball", "center": [0, 0.5], "radius": 0.4}}],
      "boundaries": [{"shape": {"type": "half_space", "point": [0, 0], "normal": [0, 1]}}]})",
                     "test");
}

std::vector<LaneSpec> three() {
  return {{"As it is", {}},
          {"Time step 2.5 ms", {{"/time/step", 0.0025}}},
          {"Midpoint", {{"/integrator/type", "implicit_midpoint"}}}};
}

std::string bytes(const Simulation& simulation) {
  std::ostringstream out;
  simulation.save_state(out);
  return std::move(out).str();
}

/// All lanes to the `frames`th common time.
void go(LaneSet& lanes, long frames) {
  while (!(lanes.level() && lanes.frame() >= frames)) REQUIRE(lanes.advance(nullptr));
}

template <typename Done>
bool wait_for(const Done& done) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!done()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace

TEST_CASE("lanes meet at common times, and each is byte for byte what it is alone") {
  const Scene scene = ball();
  LaneSet lanes(1);
  lanes.open(scene, three());
  CHECK(lanes.interval() == doctest::Approx(0.01));
  go(lanes, 7);
  CHECK(lanes.time() == doctest::Approx(0.07));
  for (const Lane& lane : lanes.lanes()) {
    CAPTURE(lane.spec.name);
    CHECK(lane.simulation->time() == doctest::Approx(0.07).epsilon(1e-12));
    const auto alone = make_simulation(edited(scene, lane.spec.edits));
    while (alone->time() < 0.07 - 1e-9) REQUIRE(alone->step().status == StepStatus::accepted);
    CHECK(bytes(*alone) == bytes(*lane.simulation));
  }
  CHECK(lanes.lanes()[0].history.size() == 1 + 7);
  CHECK(lanes.lanes()[1].history.size() == 1 + 28);
  go(lanes, 20);
  CHECK(lanes.finished());
  CHECK_FALSE(lanes.advance(nullptr));
}

TEST_CASE("common times are multiples of the longest step, as far apart as the scenes' frames") {
  Scene coarse = ball(), fine = ball();
  fine.time.step = 0.004;
  fine.time.frame = 0.025;
  CHECK(common_interval({coarse, fine}) == doctest::Approx(0.03));
  fine.time.frame.reset();
  CHECK(common_interval({coarse, fine}) == doctest::Approx(0.01));
  // A step that is no divisor is shortened to meet the others.
  LaneSet lanes(1);
  lanes.open(ball(), {{"a", {}}, {"b", {{"/time/step", 0.004}}}});
  go(lanes, 3);
  CHECK(lanes.lanes()[1].simulation->time() == doctest::Approx(0.03).epsilon(1e-12));
  CHECK(lanes.lanes()[1].history.size() == 1 + 9);
}

TEST_CASE("a lane that comes later catches up, one that goes leaves the others as they are") {
  const Scene scene = ball();
  std::vector<LaneSpec> specs = three();
  LaneSet lanes(1);
  lanes.open(scene, {specs[0], specs[1]});
  go(lanes, 5);
  const std::string before = bytes(*lanes.lanes()[0].simulation);
  lanes.change(scene, specs);
  CHECK(bytes(*lanes.lanes()[0].simulation) == before);
  CHECK_FALSE(lanes.level());
  while (!lanes.level()) REQUIRE(lanes.advance(nullptr));
  CHECK(lanes.frame() == 5);
  CHECK(lanes.lanes()[2].simulation->time() == doctest::Approx(0.05));
  lanes.change(scene, {specs[0], specs[2]});
  CHECK(lanes.frame() == 5);
  CHECK(lanes.lanes()[1].spec.name == "Midpoint");
  for (const LaneSample& s : lanes.lanes()[1].history) CHECK(s.lane == 1);
  // Another first lane is another reference: all begin anew.
  lanes.change(scene, {specs[2], specs[0]});
  CHECK(lanes.frame() == 0);
}

TEST_CASE("an edit reaches every lane but not the setting that a lane has of its own") {
  const Scene scene = ball();
  LaneSet lanes(1);
  lanes.open(scene, {{"As it is", {}}, {"Softer", {{"/materials/rubber/young", 5e4}}}});
  go(lanes, 3);
  lanes.edit(edited(scene, std::vector<Edit>{{"/materials/rubber/young", 2e5}, {"/gravity/1", -3.0}}));
  const auto young = [&](std::size_t k) {
    return lanes.lanes()[k].simulation->scene().materials[0].parameters[0].second;
  };
  CHECK(young(0) == 2e5);
  CHECK(young(1) == 5e4);
  for (const Lane& lane : lanes.lanes()) {
    CHECK(lane.simulation->scene().gravity.y() == -3);
    CHECK(lane.simulation->time() == doctest::Approx(0.03));
  }
  CHECK_FALSE(lanes.waits_for_reset());
  go(lanes, 5);
  lanes.edit(edited(scene, std::vector<Edit>{{"/bodies/0/particles_per_axis", 3}}));
  CHECK(lanes.waits_for_reset());
  lanes.reset();
  CHECK_FALSE(lanes.waits_for_reset());
  CHECK(lanes.frame() == 0);
  CHECK(lanes.lanes()[0].simulation->particle_count() == lanes.lanes()[1].simulation->particle_count());
  CHECK(lanes.lanes()[1].scene.materials[0].parameters[0].second == 5e4);
}

TEST_CASE("distances are particle by particle, by id") {
  LaneSet lanes(1);
  lanes.open(ball(), {{"As it is", {}}, {"No gravity", {{"/gravity", {0, 0}}}}, {"Finer", {{"/grid/spacing", 0.08}}}});
  go(lanes, 6);
  Snapshot first, second, other;
  for (auto [k, into] : {std::pair{0, &first}, {1, &second}, {2, &other}})
    lanes.lanes()[static_cast<std::size_t>(k)].simulation->capture({}, *into);
  const std::vector<float> apart = distances(second, first);
  REQUIRE(apart.size() == second.particles);
  double worst = 0;
  for (std::size_t p = 0; p < second.particles; ++p) {
    const ParticleState a = lanes.lanes()[0].simulation->particle(second.id[p]);
    const ParticleState b = lanes.lanes()[1].simulation->particle(second.id[p]);
    CHECK(static_cast<double>(apart[p]) == doctest::Approx((a.x - b.x).norm()).epsilon(1e-6));
    worst = std::max(worst, (a.x - b.x).norm());
  }
  const LaneDistance sum = summed(second, apart, 1);
  CHECK(sum.max == doctest::Approx(worst).epsilon(1e-6));
  // In free fall, backward Euler: g dt^2 n (n + 1) / 2.
  CHECK(sum.rms == doctest::Approx(9.81 * 1e-4 * 21).epsilon(1e-3));
  for (const float d : distances(first, first)) CHECK(d == 0);
  CHECK(distances(other, first).empty());
}

TEST_CASE("lanes that the machine cannot hold are refused with a reason, and nothing is lost") {
  LaneSet lanes(1);
  lanes.open(ball(), three());
  go(lanes, 2);
  std::vector<LaneSpec> specs = three();
  specs.push_back({"Far too fine", {{"/grid/spacing", 2e-6}}});
  try {
    lanes.change(ball(), specs);
    FAIL("was accepted");
  } catch (const InputError& error) {
    CHECK(error.problems()[0].found.find("GB") != std::string::npos);
  }
  CHECK(lanes.lanes().size() == 3);
  CHECK(lanes.frame() == 2);
}

TEST_CASE("the thread plays, steps, edits and resets all lanes together") {
  Comparison comparison(1);
  comparison.request({}, true);
  comparison.set_rate(0);
  comparison.set_lanes(ball(), three());
  REQUIRE(wait_for([&] { return comparison.frame() && comparison.frame()->lanes.size() == 3; }));
  CHECK(comparison.status().state == CompareState::paused);
  comparison.step();
  REQUIRE(wait_for([&] { return comparison.status().frame == 1; }));
  CHECK(comparison.status().state == CompareState::paused);
  comparison.run();
  REQUIRE(wait_for([&] { return comparison.status().state == CompareState::finished; }));
  const auto frame = comparison.frame();
  for (const LaneFrame& lane : frame->lanes) CHECK(lane.snapshot->report.time == doctest::Approx(0.2));
  CHECK(frame->lanes[1].steps == 80);
  REQUIRE(frame->lanes[1].distance);
  CHECK(frame->lanes[1].distance->rms > 0);
  const auto& colored = frame->lanes[1].snapshot->field[static_cast<std::size_t>(Field::error)];
  CHECK(colored.size() == frame->lanes[1].snapshot->particles);
  ComparisonNews news = comparison.news();
  CHECK(news.samples.size() == 21 + 81 + 21);
  CHECK(news.distances.size() == 3 * 21);
  comparison.reset();
  REQUIRE(wait_for([&] { return comparison.status().frame == 0; }));
  comparison.set_lanes(ball(), {});
  REQUIRE(wait_for([&] { return comparison.status().state == CompareState::closed; }));
  CHECK(comparison.frame() == nullptr);
}
