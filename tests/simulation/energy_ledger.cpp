// The account of energy closes to rounding whatever the scheme, and each entry is what a formula says where one exists.
#include <algorithm>

#include "core/integrators/integrator.hpp"
#include "core/transfers/transfer.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

std::unique_ptr<Simulation> counted(const test::Json& scene) {
  auto simulation = test::start(scene);
  simulation->set_ledger(true);
  return simulation;
}

/// A block that turns, falls on a rubbing floor, is pushed on a side and held by a moving clamp: all there is outside.
test::Json busy(int dimension) {
  test::Json scene = test::block(dimension, 0.1, 0.5);
  scene["gravity"] = test::point(dimension, 0.5, -9.81);
  scene["bodies"][0]["velocity"] = test::point(dimension, 1, -2);
  scene["bodies"][0]["velocity"][0] = "1 - 3*Y";
  test::Json floor = test::floor_at(dimension, 0.05);
  floor["friction"] = 0.4;
  scene["boundaries"] = test::Json::array({floor});
  test::Json velocity = test::point(dimension, 0, 0);
  velocity[0] = "0.5*cos(9*t)";
  test::Json fix = test::Json::array({true, false});
  if (dimension == 3) fix.push_back(false);
  scene["constraints"] = test::Json::array(
      {{{"region", test::box(test::point(dimension, 0.4, 0.4, -1), test::point(dimension, 0.7, 0.7, 1))},
        {"fix", fix},
        {"velocity", velocity}}});
  test::Json traction = test::point(dimension, 0, 0);
  traction[1] = "400*sin(20*t)";
  scene["loads"] = test::Json::array(
      {{{"body", "block"},
        {"region", test::box(test::point(dimension, 0.1, 0.1, -1), test::point(dimension, 0.1, 0.5, 1))},
        {"traction", traction}}});
  scene["body_force"] = test::point(dimension, 0, 0);
  scene["body_force"][0] = "2*sin(5*t)";
  return scene;
}

/// Change of the particles' energy, all that the account says, and the size of what was added up.
struct Closure {
  double change, account, size;
};

Closure closure_of(const Balance& before, const StepReport& after) {
  const EnergyLedger& e = after.energy;
  const double size = std::abs(before.kinetic) + std::abs(before.elastic) + std::abs(before.potential) +
                      std::abs(e.loads) + std::abs(e.boundary) + std::abs(e.time_integration) + std::abs(e.mouse) +
                      std::abs(after.balance.total());
  return {after.balance.total() - before.total(), e.sum(), size};
}

}  // namespace

TEST_CASE("the account closes over all transfers and integrators, with walls, friction, clamps, loads and the mouse") {
  for (const IntegratorInfo& integrator : integrators())
    for (const TransferInfo& transfer : transfers())
      for (const int dimension : {2, 3}) {
        const bool tried = integrator.inertia && (transfer.name == "apic" || integrator.name == "backward_euler");
        if (dimension == 3 && !tried) continue;
        CAPTURE(std::string(integrator.name));
        CAPTURE(std::string(transfer.name));
        CAPTURE(dimension);
        test::Json scene = busy(dimension);
        scene["integrator"] = {{"type", integrator.name}};
        scene["transfer"] = {{"type", transfer.name}};
        if (!integrator.implicit) scene["time"]["step"] = 0.001;
        if (!integrator.inertia) {  // what is held everywhere has an equilibrium
          for (auto& fix : scene["constraints"][0]["fix"]) fix = true;
          scene["constraints"][0]["region"]["min"] = test::point(dimension, -1, 0.4, -1);
          scene["constraints"][0]["velocity"][0] = "0.1*cos(9*t)";
          scene.erase("boundaries");
          scene["gravity"] = test::point(dimension, 0.2, -0.5);
        }
        const auto simulation = counted(scene);
        for (int k = 0; k < 12; ++k) {
          if (k == 6 && integrator.implicit) simulation->set_grab(Grab{test::centre(*simulation), {0.6, 0.6, 0}, 0.15});
          const Balance before = simulation->report().balance;
          test::run(*simulation, 1);
          const StepReport& report = simulation->report();
          REQUIRE(report.energy.known);
          const Closure closure = closure_of(before, report);
          CAPTURE(closure.change);
          CAPTURE(closure.account);
          CHECK(std::abs(closure.change - closure.account) <= 1e-12 * closure.size);
          if (k >= 6 && integrator.implicit) CHECK(report.energy.mouse != 0);
        }
        CHECK(simulation->report().energy.loads != 0);
        CHECK(simulation->report().energy.boundary != 0);
      }
}

TEST_CASE("a consistent mass has the same account") {
  test::Json scene = busy(2);
  scene["integrator"] = {{"type", "implicit_midpoint"}, {"mass", "consistent"}};
  scene["transfer"] = {{"type", "flip"}, {"velocity_mass", "consistent"}};
  scene["bodies"][0]["particles_per_axis"] = 3;
  const auto simulation = counted(scene);
  for (int k = 0; k < 10; ++k) {
    const Balance before = simulation->report().balance;
    test::run(*simulation, 1);
    const Closure closure = closure_of(before, simulation->report());
    CHECK(std::abs(closure.change - closure.account) <= 1e-12 * closure.size);
  }
}

TEST_CASE("in free fall backward Euler loses m (g dt)^2 / 2 a step, midpoint nothing") {
  constexpr double g = 9.81, dt = 0.01;
  for (const char* integrator : {"backward_euler", "implicit_midpoint", "trapezoidal", "symplectic_euler"}) {
    CAPTURE(integrator);
    test::Json scene = test::block();
    scene["gravity"] = {0, -g};
    scene["integrator"] = {{"type", integrator}};
    scene["transfer"] = {{"type", "flip"}, {"flip_ratio", 1}};
    scene["solver"] = {{"newton_tolerance", 1e-12}};
    const auto simulation = counted(scene);
    const double mass = simulation->mass();
    for (int k = 0; k < 5; ++k) {
      test::run(*simulation, 1);
      const bool euler = std::string(integrator).find("euler") != std::string::npos;
      CHECK(simulation->report().energy.time_integration ==
            doctest::Approx(euler ? -0.5 * mass * g * g * dt * dt : 0).epsilon(1e-6).scale(mass * g * g * dt * dt));
    }
  }
}

TEST_CASE("what a clamp and a load give is the force times the way") {
  // Stretched between clamps, quasi-statically: all work goes into elastic energy, but for what a step's mean force
  // gets wrong, of second order.
  test::Json bar = test::block(2, 0, 1);
  bar["integrator"] = {{"type", "quasi_static"}};
  bar["constraints"] =
      test::Json::array({{{"region", test::box({-1, -1}, {0, 2})}, {"fix", {true, true}}},
                         {{"region", test::box({1, -1}, {2, 2})}, {"fix", {true, true}}, {"velocity", {1, 0}}}});
  double errors[2];
  for (const int fine : {0, 1}) {
    bar["time"]["step"] = fine ? 0.0005 : 0.001;
    const auto simulation = counted(bar);
    double work = 0;
    for (int k = 0; k < (fine ? 40 : 20); ++k) {
      test::run(*simulation, 1);
      work += simulation->report().energy.boundary;
    }
    const double elastic = simulation->report().balance.elastic;
    CHECK(work > elastic);
    CHECK(work == doctest::Approx(elastic).epsilon(0.1));
    errors[fine] = work - elastic;
  }
  CHECK(errors[0] / errors[1] == doctest::Approx(2).epsilon(0.1));

  // A free body under a constant traction from the left: F times the way of its mass centre.
  test::Json pushed = test::block();
  pushed["loads"] =
      test::Json::array({{{"body", "block"}, {"region", test::box({0.1, 0.1}, {0.1, 0.5})}, {"traction", {50, 0}}}});
  const auto simulation = counted(pushed);
  for (int k = 0; k < 20; ++k) {
    test::run(*simulation, 1);
    CHECK(simulation->report().energy.boundary == 0);
    CHECK(simulation->report().energy.loads > 0);
  }
}

TEST_CASE("PIC's transfers lose what a turning disc has, APIC's keep it, and Newton's tolerance bounds its part") {
  double lost[2], solver[2];
  for (const int apic : {0, 1}) {
    test::Json scene = test::block();
    scene["transfer"] = {{"type", apic ? "apic" : "pic"}};
    scene["bodies"][0]["velocity"] = {"-2*(Y-0.3)", "2*(X-0.3)"};
    const auto simulation = counted(scene);
    const double first = simulation->report().balance.kinetic;
    lost[apic] = 0;
    for (int k = 0; k < 10; ++k) {
      test::run(*simulation, 1);
      lost[apic] -= (simulation->report().energy.to_grid + simulation->report().energy.to_particles) / first;
    }
  }
  CHECK(lost[0] > 0.3);
  CHECK(lost[1] < 0.2 * lost[0]);
  for (const int tight : {0, 1}) {
    test::Json scene = busy(2);
    scene["solver"] = {{"newton_tolerance", tight ? 1e-11 : 1e-2}};
    const auto simulation = counted(scene);
    solver[tight] = 0;
    for (int k = 0; k < 10; ++k) {
      test::run(*simulation, 1);
      solver[tight] += std::abs(simulation->report().energy.solver);
    }
  }
  CHECK(solver[1] < 1e-6 * solver[0]);
}

TEST_CASE(
    "an edit's change of the energy is an entry of its own; the account changes no bit and costs nothing when off") {
  const test::Json scene = busy(2);
  const auto plain = test::start(scene), simulation = counted(scene);
  test::run(*plain, 5);
  test::run(*simulation, 5);
  CHECK(test::state_of(*plain) == test::state_of(*simulation));
  CHECK_FALSE(plain->report().energy.known);
  CHECK(plain->report().work.gradient == simulation->report().work.gradient);

  const Balance before = simulation->report().balance;
  REQUIRE(simulation->apply(edited(simulation->scene(), std::vector<Edit>{{"/materials/rubber/young", 3e5}})));
  test::run(*simulation, 1);
  CHECK(simulation->report().energy.edits == doctest::Approx(2 * before.elastic));
  const Closure closure = closure_of(before, simulation->report());
  CHECK(std::abs(closure.change - closure.account) <= 1e-12 * closure.size);
  test::run(*simulation, 1);
  CHECK(simulation->report().energy.edits == 0);
}
