// What every time scheme must do: converge at its order, keep or lose the energy that its formula says, meet walls,
// moving constraints and friction, and go on from a saved state as if nothing had been.
#include <algorithm>
#include <numbers>

#include "core/bases/basis.hpp"
#include "core/integrators/integrator.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

constexpr double period = 0.4;  ///< of the bar's lowest mode [s]

/// A bar of one length on rollers, held at the left, in its lowest mode; so little that no particle leaves its cell.
/// Three cells high: with fewer particles than nodes the consistent mass would be blended with the lumped one.
test::Json bar(std::string_view integrator, int cells, double step) {
  test::Json scene = test::Json::parse(R"json({
    "dimension": 2, "constants": {"A": 0.00001, "w": 15.707963267948966},
    "grid": {"spacing": 1}, "time": {"end": 0.4, "step": 1},
    "transfer": {"type": "pic", "velocity_mass": "consistent"}, "solver": {"newton_tolerance": 1e-8, "linear": "direct"},
    "materials": {"bar": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0}},
    "bodies": [{"material": "bar", "shape": {"type": "box", "min": [0, 0], "max": [1, 0.0625]}}],
    "constraints": [{"region": {"type": "box", "min": [-1, -1], "max": [0, 2]}, "fix": [true, false]},
                    {"region": {"type": "box", "min": [-1, -1], "max": [2, 2]}, "fix": [false, true]}],
    "exact": {"position": ["X + A*sin(w*t)*sin(pi*X/2)", "Y"]}})json");
  scene["integrator"] = {{"type", integrator}};
  scene["grid"]["spacing"] = 1.0 / cells;
  scene["bodies"][0]["shape"]["max"] = {1, 3.0 / cells};
  scene["time"]["step"] = step;
  return scene;
}

/// The same bar, pushed from rest by a smooth force that is small at first: waves too fast for any step stay asleep.
/// (With no force at all, a first step would have nothing but rounding to converge to.)
test::Json pushed_bar(std::string_view integrator, double step) {
  test::Json scene = bar(integrator, 4, step);
  scene.erase("exact");
  scene["time"]["end"] = 0.3;
  scene["body_force"] = {"0.025*sin(5*t + 0.4)^4*sin(pi*X/2)", 0};
  return scene;
}

std::vector<ParticleState> final_state(const test::Json& scene) {
  const auto simulation = test::start(scene);
  while (simulation->step().status == StepStatus::accepted) {
  }
  REQUIRE(simulation->time() == simulation->scene().time.end);
  return simulation->particles();
}

double distance(const std::vector<ParticleState>& a, const std::vector<ParticleState>& b,
                Vec3 ParticleState::*member = &ParticleState::x) {
  double sum = 0;
  for (std::size_t p = 0; p < a.size(); ++p) sum += (a[p].*member - b[p].*member).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Energy after so many steps over the energy at first.
double energy_left(const test::Json& scene, int steps) {
  const auto simulation = test::start(scene);
  const double before = simulation->report().balance.total();
  test::run(*simulation, steps);
  return simulation->report().balance.total() / before;
}

}  // namespace

namespace {

/// Observed orders over three halvings of the step.
void check_orders(std::string_view basis) {
  for (const char* mass : {"lumped", "consistent"}) {
    const auto run = [&](std::string_view integrator, double step) {
      test::Json scene = pushed_bar(integrator, step);
      scene["integrator"]["mass"] = mass;
      scene["grid"]["basis"] = basis;
      return final_state(scene);
    };
    const std::vector<ParticleState> fine = run("tr_bdf2", 0.0001);
    for (const IntegratorInfo& integrator : integrators()) {
      if (!integrator.inertia) continue;
      CAPTURE(integrator.name);
      CAPTURE(mass);
      CAPTURE(basis);
      // Symplectic Euler's places are of second order where it starts from rest: of it, the velocity's error.
      const auto error = [&](int k) {
        const std::vector<ParticleState> end = run(integrator.name, (integrator.implicit ? 0.01 : 0.0008) / (1 << k));
        return distance(end, fine, integrator.implicit ? &ParticleState::x : &ParticleState::v);
      };
      double errors[4];
      for (int k = 0; k < 4; ++k) errors[k] = error(k);
      for (int k = 0; k < 3; ++k) CHECK(std::abs(std::log2(errors[k] / errors[k + 1]) - integrator.order) < 0.1);
    }
  }
}

}  // namespace

TEST_CASE("every time scheme converges at its order on a fixed grid, whatever mass") {
  check_orders("quadratic");
}

TEST_SUITE("long") {
  TEST_CASE("every time scheme converges at its order on a fixed grid, whatever basis is sampled at the particles") {
    // Averaged ones fall short of it: docs/integrators.md.
    for (const BasisInfo& basis : bases())
      if (basis.name != "quadratic" && !basis.averaged()) check_orders(basis.name);
  }
}

TEST_CASE("energy after five periods is what each scheme's formula says") {
  const double dt = period / 100, w = 2 * std::numbers::pi / period;
  for (const IntegratorInfo& integrator : integrators()) {
    if (!integrator.inertia) continue;
    CAPTURE(integrator.name);
    test::Json scene = bar(integrator.name, 16, dt);
    scene["time"]["end"] = 5 * period;
    scene["integrator"]["mass"] = "consistent";
    if (!integrator.implicit) {  // the full mass of splines leaves no step stable at the free edges
      scene["time"]["step"] = dt / 2;
      scene["integrator"]["mass"] = "lumped";
      scene["transfer"] = {{"type", "flip"}, {"flip_ratio", 1}};
    }
    const double left = energy_left(scene, integrator.implicit ? 500 : 1000);
    MESSAGE(integrator.name << ": E/E0 = " << left);
    if (integrator.name == "backward_euler")
      CHECK(left == doctest::Approx(std::pow(1 + w * w * dt * dt, -500)).epsilon(0.02));
    else
      CHECK(left == doctest::Approx(1).epsilon(integrator.implicit ? 2e-3 : 0.04));
  }
}

TEST_CASE("the spectral radius says what generalised-alpha leaves of waves that are too fast for the step") {
  // The lowest mode with w dt = 200; in ten steps.
  const auto left = [](double r) {
    test::Json scene = bar("generalized_alpha", 4, 200 * period / (2 * std::numbers::pi));
    scene["constants"]["A"] = 1e-6;
    scene["time"]["end"] = 1e4;
    scene["integrator"]["spectral_radius"] = r;
    return energy_left(scene, 10);
  };
  const double all = left(1), most = left(0.8), little = left(0.3);
  CHECK(all > 0.9);
  CHECK(most < 0.5 * all);
  CHECK(little < 1e-2 * most);
}

TEST_CASE("what a moving constraint holds moves as it says, to the order of the scheme") {
  for (const IntegratorInfo& integrator : integrators()) {
    CAPTURE(integrator.name);
    test::Json scene = test::block();
    scene["time"] = {{"end", 0.4}, {"step", 0.01}};
    scene["integrator"] = {{"type", integrator.name}};
    scene["transfer"] = {{"type", "pic"}};
    scene["constraints"] = {
        {{"region", test::box({-9, -9}, {9, 9})}, {"fix", {true, true}}, {"velocity", {"cos(3*t)", "t"}}}};
    const auto simulation = test::start(scene);
    while (simulation->step().status == StepStatus::accepted) {
    }
    // Displacements are the velocity's integral in every scheme; velocities are those at the end where the order is
    // two.
    const bool first = integrator.order == 1;
    for (const ParticleState& p : simulation->particles()) {
      CHECK((p.x - p.X - Vec3(std::sin(1.2) / 3, 0.08, 0)).norm() < 1e-9);
      CHECK((p.v - Vec3(std::cos(1.2), 0.4, 0)).norm() < (first ? 0.02 : 1e-9));
    }
  }
}

TEST_CASE("a bar whose end is moved answers at the order of the scheme") {
  for (const char* mass : {"lumped", "consistent"}) {
    const auto run = [&](std::string_view integrator, double step) {
      test::Json scene = pushed_bar(integrator, step);
      scene["integrator"]["mass"] = mass;
      scene["constraints"][0]["velocity"] = {"0.0005*sin(5*t)^4", 0};
      return final_state(scene);
    };
    const std::vector<ParticleState> fine = run("tr_bdf2", 0.0002);
    for (const IntegratorInfo& integrator : integrators()) {
      if (!integrator.inertia || !integrator.implicit) continue;
      CAPTURE(integrator.name);
      CAPTURE(mass);
      const double coarse = distance(run(integrator.name, 0.005), fine),
                   half = distance(run(integrator.name, 0.0025), fine);
      CHECK(std::log2(coarse / half) == doctest::Approx(integrator.order).epsilon(0.1));
    }
  }
}

TEST_CASE("a dropped block comes to rest on the floor under every time scheme") {
  for (const IntegratorInfo& integrator : integrators()) {
    if (!integrator.inertia) continue;
    CAPTURE(integrator.name);
    test::Json scene = test::block();
    scene["gravity"] = {0, -9.81};
    scene["boundaries"] = test::Json::array({test::floor_at(2, 0)});
    scene["integrator"] = {{"type", integrator.name}};
    scene["transfer"] = {{"type", "flip"}, {"flip_ratio", 0.9}};  // explicit and midpoint steps damp nothing themselves
    scene["time"]["step"] = 0.005;
    const auto simulation = test::start(scene);
    const double before = simulation->report().balance.total();
    for (int k = 0; k < 300; ++k) {
      test::run(*simulation, 1);
      REQUIRE(test::lowest(*simulation) > 0);
      REQUIRE(simulation->report().balance.total() < 1.01 * before);
    }
    CHECK(test::mean_velocity(*simulation).norm() < 0.15);  // it fell with 1.4 m/s and rings a little
    CHECK(test::lowest(*simulation) < 0.15);
  }
}

TEST_CASE("Coulomb's law holds under every time scheme: sliding with g (sin - mu cos), sticking below tan") {
  const double angle = std::numbers::pi / 6;
  for (const IntegratorInfo& integrator : integrators())
    for (const double mu : {0.3, 0.8}) {
      if (!integrator.inertia) continue;
      CAPTURE(integrator.name);
      CAPTURE(mu);
      test::Json scene = test::block();
      scene["grid"]["spacing"] = 0.05;
      scene["time"]["step"] = integrator.implicit ? 0.005 : 0.0005;
      scene["integrator"] = {{"type", integrator.name}};
      scene["transfer"] = {{"type", "pic"}};
      scene["bodies"][0]["shape"] = test::box({0, 0}, {0.4, 0.1});
      scene["materials"]["rubber"]["young"] = 1e6;
      scene["gravity"] = {10 * std::sin(angle), -10 * std::cos(angle)};
      scene["boundaries"] = test::Json::array({test::floor_at(2, 0)});
      scene["boundaries"][0]["friction"] = mu;
      const auto simulation = test::start(scene);
      const int steps = integrator.implicit ? 20 : 200;
      test::run(*simulation, 2 * steps);
      const double before = test::mean_velocity(*simulation)[0];
      test::run(*simulation, 2 * steps);
      const double acceleration = (test::mean_velocity(*simulation)[0] - before) / 0.2;
      const double exact = std::max(0.0, 10 * (std::sin(angle) - mu * std::cos(angle)));
      CHECK(std::abs(acceleration - exact) < 0.15);
      CHECK(test::lowest(*simulation) > 0);
    }
}

TEST_CASE("a run goes on from a saved state to the bit under every time scheme") {
  for (const int dimension : {2, 3})
    for (const IntegratorInfo& integrator : integrators()) {
      CAPTURE(dimension);
      CAPTURE(integrator.name);
      test::Json scene = test::block(dimension, 0, 0.3);
      scene["gravity"] = test::point(dimension, 1, -10);
      scene["integrator"] = {{"type", integrator.name}};
      scene["boundaries"] = test::Json::array({test::floor_at(dimension, 0)});
      scene["boundaries"][0]["contact"] = "stick";
      const auto whole = test::start(scene), part = test::start(scene), rest = test::start(scene, 2);
      test::run(*whole, 8);
      test::run(*part, 4);
      std::istringstream in(test::state_of(*part));
      rest->load_state(in);
      test::run(*rest, 4);
      test::check_equal(whole->particles(), rest->particles());
      CHECK(test::state_of(*whole) == test::state_of(*rest));
    }
}

TEST_CASE("what is extrapolated inside out is tried again with a smaller step") {
  for (const char* integrator : {"implicit_midpoint", "generalized_alpha"}) {
    CAPTURE(integrator);
    test::Json scene = test::block();
    scene["integrator"] = {{"type", integrator}};
    scene["time"]["step"] = 0.05;
    scene["bodies"][0]["velocity"] = {"-800*(X - 0.3)", "0"};
    scene["materials"]["rubber"]["young"] = 1e6;
    const auto simulation = test::start(scene);
    int retries = 0;
    for (int k = 0; k < 5; ++k) {
      test::run(*simulation, 1);
      retries += simulation->report().retries;
      REQUIRE(simulation->report().min_J > 0);
    }
    CHECK(retries > 0);
  }
}
