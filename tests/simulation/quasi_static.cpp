// Equilibrium without inertia (THEORY T7).
#include "core/bases/basis.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

/// A bar on rollers, held at the left, pulled at the right by a traction that grows to `load` at t = 1.
test::Json pulled_bar(double load, double step) {
  test::Json scene = test::Json::parse(R"json({
    "dimension": 2, "grid": {"spacing": 0.125}, "time": {"end": 1, "step": 1}, "integrator": {"type": "quasi_static"},
    "materials": {"bar": {"model": "neo_hookean", "density": 1000, "young": 1e5, "poisson": 0}},
    "bodies": [{"name": "bar", "material": "bar", "shape": {"type": "box", "min": [0, 0], "max": [1, 0.25]}}],
    "constraints": [{"region": {"type": "box", "min": [-1, -1], "max": [0, 2]}, "fix": [true, false]},
                    {"region": {"type": "box", "min": [-1, -1], "max": [3, 2]}, "fix": [false, true]}],
    "loads": [{"body": "bar", "region": {"type": "box", "min": [1, -1], "max": [1, 1]}, "traction": ["0", 0]}]})json");
  scene["time"]["step"] = step;
  scene["loads"][0]["traction"][0] = std::to_string(load) + "*t";
  return scene;
}

std::vector<Problem> problems_of(const test::Json& scene) {
  try {
    test::start(scene);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

}  // namespace

TEST_CASE("a small pull stretches a bar by load over modulus, and nothing moves by itself") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    test::Json scene = pulled_bar(1, 0.25);
    scene["grid"]["basis"] = basis.name;
    scene["solver"] = {{"newton_tolerance", 1e-9}};
    const auto simulation = test::start(scene);
    test::run(*simulation, 4);
    CHECK(simulation->report().balance.kinetic == 0);
    // Splines hold the bar by the nodes beyond its end, too: half a cell of it is stiffer.
    double left = 1e300, stretch = 0;
    for (const ParticleState& p : simulation->particles())
      if (std::abs(p.X[0] - 0.5) < left) left = std::abs(p.X[0] - 0.5), stretch = p.F(0, 0) - 1;
    CHECK(stretch == doctest::Approx(1e-5).epsilon(1e-3));
    CHECK(simulation->report().balance.elastic == doctest::Approx(0.5 * 1e-5 * 0.25).epsilon(0.1));
  }
}

TEST_CASE("a pull that is taken back leaves the bar as it was, and v is the way over dt") {
  test::Json scene = pulled_bar(2e3, 0.1);
  scene["loads"][0]["traction"][0] = "2e3*sin(pi*t)";
  const auto simulation = test::start(scene);
  test::run(*simulation, 5);
  double longest = 0;
  for (const ParticleState& p : simulation->particles()) longest = std::max(longest, p.x[0]);
  CHECK(longest > 0.97 + 0.015);
  const std::vector<ParticleState> before = simulation->particles();
  test::run(*simulation, 1);
  const std::vector<ParticleState> after = simulation->particles();
  for (std::size_t p = 0; p < before.size(); ++p) CHECK((after[p].v - (after[p].x - before[p].x) / 0.1).norm() < 1e-10);
  test::run(*simulation, 4);
  for (const ParticleState& p : simulation->particles()) CHECK((p.x - p.X).norm() < 2e-4);
}

TEST_CASE("an increment that is too large is bisected") {
  test::Json scene = pulled_bar(-4e5, 1);
  scene["solver"] = {{"max_newton", 5}};
  const auto simulation = test::start(scene);
  test::run(*simulation, 1);
  CHECK(simulation->report().retries > 0);
  CHECK(simulation->time() < 1);
}

TEST_CASE("free rigid motion is refused with the reason, and so is what cannot go without inertia") {
  const auto refusal = [](const test::Json& scene) {
    const std::vector<Problem> problems = problems_of(scene);
    return problems.empty() ? std::string() : problems[0].pointer + " " + problems[0].found;
  };
  test::Json scene = pulled_bar(1, 0.5);
  CHECK(refusal(scene) == "");
  scene["constraints"][1]["region"]["max"] = {-5, -5};
  scene["constraints"][1]["region"]["min"] = {-6, -6};
  CHECK(refusal(scene).find("/integrator/type \"quasi_static\", but what lies about") == 0);
  CHECK(refusal(scene).find("free to move") != std::string::npos);
  scene["constraints"][0] = {{"region", test::box({-0.01, -0.01}, {0.01, 0.01})}, {"fix", {true, true}}};
  CHECK(refusal(scene).find("free to turn") != std::string::npos);
  // One of two bodies is free; they lie far apart.
  scene = pulled_bar(1, 0.5);
  scene["bodies"].push_back({{"material", "bar"}, {"shape", test::box({5, 5}, {6, 6})}});
  CHECK(refusal(scene).find("(5.5, 5.5)") != std::string::npos);

  scene = pulled_bar(1, 0.5);
  scene["time"]["control"] = "adaptive";
  CHECK(refusal(scene).find("/time/control \"adaptive\" beside the integrator") == 0);
  scene = pulled_bar(1, 0.5);
  scene.erase("loads");
  scene["exact"] = {{"position", {"X*(1 + t)", "Y"}}};
  scene["manufactured"] = true;
  CHECK(refusal(scene).find("/manufactured") == 0);
}

TEST_CASE("what becomes free while it runs stops the run with the reason and without a retry") {
  test::Json scene = pulled_bar(1, 0.25);
  const auto simulation = test::start(scene);
  test::run(*simulation, 1);
  scene["constraints"][0]["fix"] = {false, true};
  REQUIRE(simulation->apply(parse_scene(scene.dump(), "test")));
  const StepReport& report = simulation->step();
  CHECK(report.status == StepStatus::failed);
  CHECK(report.retries == 0);
  CHECK(report.failure.find("free to move") != std::string::npos);
}
