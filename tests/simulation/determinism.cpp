// The same bytes for any number of threads, after a restart, and after a step that came to nothing.
#include <thread>

#include "core/math/parallel.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

/// A block thrown onto a rubbing floor against a wall that moves; loaded on one side.
test::Json rough_ride() {
  test::Json scene = test::block(2, 0.05, 0.45);
  scene["grid"]["spacing"] = 0.05;
  scene["gravity"] = {0, -9.81};
  scene["transfer"] = {{"type", "flip"}, {"flip_ratio", 0.95}};
  scene["bodies"][0]["velocity"] = {"2 - Y", "-1"};
  scene["boundaries"] = test::Json::array({test::floor_at(2, 0)});
  scene["boundaries"][0]["friction"] = 0.4;
  scene["boundaries"].push_back({{"shape", {{"type", "half_space"}, {"point", {0.8, 0}}, {"normal", {-1, 0}}}},
                                 {"velocity", {"-2*cos(5*t)", 0}},
                                 {"friction", 0.2}});
  scene["loads"] = {
      {{"body", "block"}, {"region", test::box({0, 0.45}, {1, 0.45})}, {"traction", {"500*sin(9*t)", -300}}}};
  return scene;
}

/// Two balls of two materials that collide above a slipping floor.
test::Json collision() {
  test::Json scene = test::block(3);
  scene["gravity"] = {0, -9.81, 0};
  scene["materials"]["jelly"] = {{"model", "fixed_corotated"}, {"density", 500}, {"young", 2e4}, {"poisson", 0.4}};
  scene["bodies"] = {{{"name", "a"},
                      {"material", "rubber"},
                      {"velocity", {3, 0, "X"}},
                      {"shape", {{"type", "ball"}, {"center", {0.3, 0.3, 0.3}}, {"radius", 0.25}}}},
                     {{"name", "b"},
                      {"material", "jelly"},
                      {"velocity", {-3, 0, 0}},
                      {"shape", {{"type", "ball"}, {"center", {0.9, 0.35, 0.35}}, {"radius", 0.25}}}}};
  scene["boundaries"] = test::Json::array({test::floor_at(3, 0)});
  scene["boundaries"][0]["friction"] = 0.3;
  return scene;
}

/// Nearly incompressible, particles of a cell share their change of volume, beside a material that does not.
test::Json shared_volumes() {
  test::Json scene = collision();
  scene["materials"]["rubber"]["poisson"] = 0.49;
  scene["materials"]["rubber"]["f_bar"] = true;
  return scene;
}

/// The same with adaptive steps from this dt, at this tolerance.
test::Json adaptive(test::Json scene, double step, double tolerance) {
  scene["time"]["control"] = "adaptive";
  scene["time"]["step"] = step;
  scene["time"]["tolerance"] = tolerance;
  return scene;
}

void check_threads(const test::Json& scene, int steps = 20) {
  const auto one = test::start(scene, 1), two = test::start(scene, 2), three = test::start(scene, 3);
  for (int k = 0; k < steps; ++k) {
    CAPTURE(k);
    for (Simulation* s : {one.get(), two.get(), three.get()}) test::run(*s, 1);
    test::check_equal(one->report(), two->report());
    test::check_equal(one->report(), three->report());
  }
  test::check_equal(one->particles(), two->particles());
  test::check_equal(one->particles(), three->particles());
  CHECK(test::state_of(*one) == test::state_of(*two));
  CHECK(test::state_of(*one) == test::state_of(*three));
}

void check_restart(const test::Json& scene, int steps = 7) {
  const auto whole = test::start(scene), resumed = test::start(scene, 2);
  test::run(*whole, steps);
  std::stringstream file(test::state_of(*whole));
  resumed->load_state(file);
  CHECK(test::state_of(*resumed) == test::state_of(*whole));
  test::check_equal(resumed->particles(), whole->particles());
  CHECK(resumed->time() == whole->time());
  CHECK(resumed->report().step == steps);
  for (int k = 0; k < 8; ++k) {
    CAPTURE(k);
    test::run(*whole, 1);
    test::run(*resumed, 1);
    test::check_equal(resumed->report(), whole->report());
  }
  CHECK(test::state_of(*resumed) == test::state_of(*whole));
}

}  // namespace

TEST_CASE("threads never change a bit: contact, friction, moving walls and loads in 2D") {
  test::Json scene = rough_ride();
  check_threads(scene);
  scene["transfer"] = {{"type", "flip"}, {"flip_ratio", 0.9}, {"velocity_mass", "consistent"}};
  scene["integrator"] = {{"mass", "consistent"}};
  scene["solver"] = {{"linear", "direct"}};
  check_threads(scene, 6);
}

TEST_CASE("threads never change a bit of adaptive steps: implicit, explicit, from one to the other") {
  check_threads(adaptive(rough_ride(), 0.02, 10));
  check_threads(adaptive(rough_ride(), 0.02, 0.05), 60);
  check_threads(adaptive(collision(), 0.02, 1), 30);
}

TEST_CASE("threads never change a bit: colliding balls in 3D") {
  check_threads(collision());
}

TEST_CASE("threads never change a bit, and a saved state goes on byte-equal: volume changes that a cell shares") {
  check_threads(shared_volumes(), 8);
  check_restart(shared_volumes());
  test::Json direct = rough_ride();
  direct["materials"]["rubber"]["f_bar"] = true;
  direct["solver"] = {{"linear", "direct"}};
  check_threads(direct, 6);
  direct["integrator"] = {{"type", "symplectic_euler"}};
  direct["time"]["step"] = 5e-4;
  check_threads(direct, 20);
}

TEST_CASE("a saved state goes on byte-equal: friction, moving walls, loads; APIC in 3D; the automatic solver") {
  check_restart(rough_ride());
  check_restart(collision());
  test::Json stiff = rough_ride();  // so that "auto" turns to the direct solver on the way
  stiff["materials"]["rubber"]["young"] = 1e7;
  check_restart(stiff);
}

TEST_CASE("a saved state goes on byte-equal with adaptive steps, whatever they are at") {
  for (const double tolerance : {10.0, 0.3, 0.05, 0.005}) {
    CAPTURE(tolerance);
    check_restart(adaptive(rough_ride(), 0.02, tolerance), 7);
    check_restart(adaptive(rough_ride(), 0.02, tolerance), 40);
    check_restart(adaptive(collision(), 0.02, tolerance), 11);
  }
}

TEST_CASE("a state that is cut short, of another scene or no state at all is refused and changes nothing") {
  const auto simulation = test::start(rough_ride());
  test::run(*simulation, 3);
  const std::string state = test::state_of(*simulation);
  const auto other = test::start(test::block());
  const std::string before = test::state_of(*other);
  for (const std::string& bad : {state, state.substr(0, state.size() / 2), std::string("no state"), std::string()}) {
    std::istringstream in(bad);
    CHECK_THROWS_AS(other->load_state(in), InputError);
    CHECK(test::state_of(*other) == before);
  }
  for (const std::size_t kept : {std::size_t{10}, std::size_t{100}, state.size() / 3, state.size() - 1}) {
    std::istringstream in(state.substr(0, kept));
    CHECK_THROWS_AS(simulation->load_state(in), InputError);
    CHECK(test::state_of(*simulation) == state);
  }
}

TEST_CASE("a cancelled step leaves every particle as it was, and the run goes on as if it had not begun") {
  for (const test::Json& scene : {rough_ride(), collision(), adaptive(rough_ride(), 0.02, 10.0),
                                  adaptive(rough_ride(), 0.02, 0.05), adaptive(collision(), 0.02, 1.0)})
    for (const int wait_us : {0, 200, 1000, 4000}) {
      CAPTURE(wait_us);
      const auto undisturbed = test::start(scene), cancelled = test::start(scene);
      test::run(*undisturbed, 3);
      test::run(*cancelled, 2);
      const std::vector<ParticleState> before = cancelled->particles();
      const std::string state = test::state_of(*cancelled);
      std::atomic<bool> cancel = wait_us == 0;
      std::jthread hand([&] {
        std::this_thread::sleep_for(std::chrono::microseconds(wait_us));
        cancel = true;
      });
      const StepReport& report = cancelled->step(&cancel);
      // An explicit step does not look up while it works: it is over within a few passes.
      if (wait_us == 0 && !scene["time"].contains("control")) CHECK(report.status == StepStatus::cancelled);
      if (report.status == StepStatus::accepted) continue;  // it was faster than the hand
      CHECK(report.status == StepStatus::cancelled);
      test::check_equal(cancelled->particles(), before);
      CHECK(test::state_of(*cancelled) == state);
      CHECK(cancelled->report().step == 2);
      test::run(*cancelled, 1);
      test::check_equal(cancelled->report(), undisturbed->report());
      CHECK(test::state_of(*cancelled) == test::state_of(*undisturbed));
    }
}

namespace {

/// A block whose ends are driven into each other at this speed [m/s].
test::Json crushed(double speed) {
  test::Json scene = test::block();
  scene["constraints"] = {{{"region", test::box({-1, -1}, {0.2, 2})}, {"fix", {true, true}}, {"velocity", {speed, 0}}},
                          {{"region", test::box({0.4, -1}, {2, 2})}, {"fix", {true, true}}, {"velocity", {-speed, 0}}}};
  return scene;
}

}  // namespace

TEST_CASE("a step that turns material inside out is retried with smaller dt, and the user is told") {
  const auto simulation = test::start(crushed(15));
  const StepReport& report = simulation->step();
  REQUIRE(report.status == StepStatus::accepted);
  CHECK(report.retries > 0);
  CHECK(report.dt == doctest::Approx(0.01 * std::pow(0.5, report.retries)).epsilon(1e-12));
  CHECK(report.warnings.size() == static_cast<std::size_t>(report.retries));
  CHECK(report.min_J > 0);
  CHECK(simulation->time() == doctest::Approx(report.dt).epsilon(1e-12));
}

TEST_CASE("a step that cannot succeed fails with its reason, the state untouched, and the run can be mended") {
  const auto simulation = test::start(crushed(0));
  test::run(*simulation, 3);
  Scene impossible = simulation->scene();
  impossible = edited(impossible, std::vector<Edit>{{"/constraints/0/velocity", {1e7, 0}}});
  REQUIRE(simulation->apply(impossible));
  const std::string state = test::state_of(*simulation);
  const std::vector<ParticleState> before = simulation->particles();
  const StepReport& report = simulation->step();
  CHECK(report.status == StepStatus::failed);
  CHECK(report.retries >= 10);
  CHECK(report.failure.find("inside out") != std::string::npos);
  CHECK(report.failure.find("may help") != std::string::npos);
  CHECK(simulation->report().step == 3);
  test::check_equal(simulation->particles(), before);
  CHECK(test::state_of(*simulation) == state);
  REQUIRE(simulation->apply(parse_scene(crushed(0).dump(), "test")));
  test::run(*simulation, 3);
}

TEST_CASE("a run ends exactly at its end and says so") {
  test::Json scene = test::block();
  scene["time"] = {{"end", 0.025}, {"step", 0.01}};
  const auto simulation = test::start(scene);
  test::run(*simulation, 3);
  CHECK(simulation->time() == 0.025);
  CHECK(simulation->step().status == StepStatus::finished);
  CHECK(simulation->report().step == 3);
  simulation->set_end(0.04);
  test::run(*simulation, 2);
  CHECK(simulation->time() == 0.04);
}
