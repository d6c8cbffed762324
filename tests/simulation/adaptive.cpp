// Adaptive steps of whole simulations: how exact they are, what is chosen and why, and where they end.
#include <set>

#include "core/runner.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

/// A bar held at one end that swings along its axis in its lowest mode, 15.7 rad/s at 1e5 Pa; one-dimensional.
test::Json bar(double young, double end) {
  return {
      {"dimension", 2},
      {"grid", {{"spacing", 0.125}}},
      {"time", {{"end", end}, {"step", 0.05}, {"control", "adaptive"}}},
      {"transfer", {{"type", "flip"}, {"flip_ratio", 1}}},
      {"materials", {{"bar", {{"model", "linear_elastic"}, {"density", 1000}, {"young", young}, {"poisson", 0}}}}},
      {"bodies",
       test::Json::array(
           {{{"material", "bar"}, {"velocity", {"0.1*sin(pi*X/2)", 0}}, {"shape", test::box({0, 0}, {1, 0.125})}}})},
      {"constraints",
       {{{"region", test::box({-1, -1}, {0, 2})}, {"fix", {true, false}}},
        {{"region", test::box({-1, -1}, {2, 2})}, {"fix", {false, true}}}}}};
}

struct Ran {
  std::vector<ParticleState> particles;
  std::vector<StepReport> steps;
  int count(bool implicit) const {
    return static_cast<int>(
        std::count_if(steps.begin(), steps.end(), [&](const auto& r) { return r.control.implicit == implicit; }));
  }
};

Ran run_to_end(const test::Json& scene) {
  const auto simulation = test::start(scene);
  Ran ran;
  for (;;) {
    const StepReport& report = simulation->step();
    if (report.status == StepStatus::finished) break;
    REQUIRE_MESSAGE(report.status == StepStatus::accepted, report.failure);
    ran.steps.push_back(report);
  }
  CHECK(simulation->time() == simulation->scene().time.end);
  ran.particles = simulation->particles();
  return ran;
}

double distance(const Ran& a, const Ran& b) {
  double squares = 0, mass = 0;
  for (std::size_t p = 0; p < a.particles.size(); ++p) {
    squares += a.particles[p].mass * (a.particles[p].x - b.particles[p].x).squaredNorm();
    mass += a.particles[p].mass;
  }
  return std::sqrt(squares / mass);
}

}  // namespace

TEST_CASE("implicit adaptive steps of a bar are as exact as their tolerance says") {
  test::Json scene = bar(1e5, 0.5);
  scene["integrator"] = {{"mass", "consistent"}};  // explicit steps are not considered
  test::Json fine = scene;
  fine["time"] = {{"end", 0.5}, {"step", 5e-5}};
  const Ran exact = run_to_end(fine);
  // Below about 1e-4 the jump of the next test hides the error.
  for (const double tolerance : {3e-3, 3e-4}) {
    CAPTURE(tolerance);
    scene["time"]["tolerance"] = tolerance;
    const Ran adaptive = run_to_end(scene);
    CHECK(adaptive.count(false) == 0);
    const double rate = distance(adaptive, exact) / 0.5;
    CHECK(rate < 1.5 * tolerance);
    CHECK(rate > 0.2 * tolerance);
  }
}

TEST_CASE("explicit where that takes less counted work, implicit where only what is slow or small moves fast") {
  test::Json scene = bar(1e5, 0.5);
  scene["time"]["tolerance"] = 1e-3;
  const Ran soft = run_to_end(scene);
  CHECK(soft.count(true) == 0);
  for (const StepReport& report : soft.steps) {
    const ControlReport& c = report.control;
    CHECK(report.dt <= c.explicit_limit);
    CHECK(c.explicit_cost < c.implicit_cost);
    CHECK((c.limited_by == StepLimit::stability || c.limited_by == StepLimit::landing));
  }
  // The stiff bar's vibration is a hundredth of a millimetre: nobody asked for it.
  scene = bar(1e9, 0.5);
  scene["time"]["tolerance"] = 1e-2;
  const Ran stiff = run_to_end(scene);
  CHECK(stiff.count(false) == 0);
  CHECK(stiff.steps.size() < 20);
}

TEST_CASE("a longer step than the tolerance allows is given up before it is taken") {
  test::Json scene = bar(1e5, 0.3);
  scene["integrator"] = {{"mass", "consistent"}};
  scene["time"]["tolerance"] = 1e-4;
  const Ran ran = run_to_end(scene);
  CHECK(ran.steps[0].control.given_up > 0);
  CHECK(ran.steps[0].retries == 0);
  CHECK(ran.steps[0].warnings.empty());
  CHECK(ran.steps[0].dt < 0.01);
  // The held nodes share a consistent mass with free ones: a jump that no dt makes smaller, and none is made short for.
  CHECK(ran.steps.size() < 20000);
  CHECK(ran.steps[0].dt > 1e-6);
}

TEST_CASE("adaptive steps land on the end, and on the times that a study looks at") {
  test::Json scene = test::block();
  scene["gravity"] = {0, -9.81};
  scene["time"] = {{"end", 0.35}, {"step", 0.04}, {"control", "adaptive"}, {"tolerance", 1}};
  run_to_end(scene);
  const auto simulation = test::start(scene);
  struct Times final : RunObserver {
    std::set<double> seen;
    void on_state(const Simulation& s) override { seen.insert(s.time()); }
  } times;
  Runner runner(*simulation);
  runner.add(times);
  CHECK(runner.run({.steps = {}, .landings = {0.1, 0.2, 0.3}}).end == RunEnd::done);
  for (const double at : {0.1, 0.2, 0.3, 0.35}) CHECK(times.seen.contains(at));
}

TEST_CASE("the control of steps may change while the scene runs") {
  test::Json scene = test::block();
  scene["gravity"] = {0, -9.81};
  const auto simulation = test::start(scene);
  test::run(*simulation, 3);
  CHECK_FALSE(simulation->report().control.adaptive);
  const Scene adaptive = edited(simulation->scene(), std::vector<Edit>{{"/time/control", "adaptive"}});
  REQUIRE(simulation->apply(adaptive));
  test::run(*simulation, 20);
  CHECK(simulation->report().control.adaptive);
  REQUIRE(simulation->apply(edited(adaptive, std::vector<Edit>{{"/time/control", "fixed"}})));
  test::run(*simulation, 2);
  CHECK_FALSE(simulation->report().control.adaptive);
  CHECK(simulation->time() == std::round(simulation->time() / 0.01) * 0.01);
}

TEST_CASE("while the mouse holds the material steps are implicit: its spring has no part in the explicit limit") {
  test::Json scene = bar(1e5, 10);
  scene["time"]["tolerance"] = 1e-3;
  const auto simulation = test::start(scene);
  test::run(*simulation, 5);
  CHECK_FALSE(simulation->report().control.implicit);
  simulation->set_grab(Grab{{1, 0.06, 0}, {1.1, 0.06, 0}, 0.1});
  test::run(*simulation, 5);
  CHECK(simulation->report().control.implicit);
  simulation->set_grab({});
  test::run(*simulation, 40);
  CHECK_FALSE(simulation->report().control.implicit);
}

TEST_CASE("explicit adaptive steps are leapfrog: they fall freely without error, whatever their lengths") {
  test::Json scene = test::block();
  scene["gravity"] = {0, -9.81};
  scene["time"] = {{"end", 0.5}, {"step", 0.05}, {"control", "adaptive"}};
  scene["bodies"][0]["velocity"] = {1, 3};
  const auto simulation = test::start(scene);
  const Vec3 start = test::centre(*simulation);
  while (simulation->step().status == StepStatus::accepted) CHECK_FALSE(simulation->report().control.implicit);
  const Vec3 fallen = start + Vec3(0.5, 1.5 - 0.5 * 9.81 * 0.25, 0);
  CHECK((test::centre(*simulation) - fallen).norm() < 1e-12);
}
