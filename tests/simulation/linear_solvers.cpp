// Every linear solver leads to the same motion; multigrid's iterations hardly grow; "auto" says what it chose and why.
#include "core/solvers/linear_solver.hpp"

#include <tuple>

#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

/// A bar of 2 (x 1) x 1 m, held at one end, under gravity; `cells` a metre.
test::Json bar(int dimension, int cells, double young) {
  test::Json scene = test::block(dimension);
  scene["grid"]["spacing"] = 1.0 / cells;
  scene["gravity"] = test::point(dimension, 0, -9.81);
  scene["materials"]["rubber"]["young"] = young;
  scene["bodies"][0]["shape"] = test::box(test::point(dimension, 0, 0, 0), test::point(dimension, 2, 1, 1));
  scene["constraints"] =
      test::Json::array({{{"region", test::box(test::point(dimension, -1, -1, -1), test::point(dimension, 0, 2, 2))},
                          {"fix", dimension == 2 ? test::Json{true, true} : test::Json{true, true, true}}}});
  return scene;
}

double iterations_a_newton_step(const test::Json& scene) {
  const auto simulation = test::start(scene);
  test::run(*simulation, 1);
  const StepReport& report = simulation->report();
  return static_cast<double>(report.linear_iterations) / static_cast<double>(report.newton.size() - 1);
}

}  // namespace

TEST_CASE("every linear solver leads to the same motion, with held nodes, walls and friction") {
  for (const int dimension : {2, 3}) {
    test::Json scene = bar(dimension, dimension == 2 ? 8 : 3, 1e6);
    scene["boundaries"] = test::Json::array({test::floor_at(dimension, -0.02)});
    scene["boundaries"][0]["friction"] = 0.3;
    scene["solver"] = {{"newton_tolerance", 1e-9}, {"linear", "direct"}};
    const auto expected = test::start(scene);
    test::run(*expected, 5);
    for (const LinearSolverInfo& solver : linear_solvers()) {
      CAPTURE(solver.name);
      CAPTURE(dimension);
      scene["solver"]["linear"] = std::string(solver.name);
      const auto found = test::start(scene);
      test::run(*found, 5);
      double apart = 0;
      for (std::size_t p = 0; p < expected->particle_count(); ++p)
        apart = std::max(apart, (found->particles()[p].x - expected->particles()[p].x).norm());
      CHECK(apart < 1e-7);
    }
  }
}

TEST_CASE("multigrid: iterations hardly grow with the grid and the stiffness") {
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    const int coarse = dimension == 2 ? 16 : 8;
    const auto count = [&](int cells, double young) {
      test::Json scene = bar(dimension, cells, young);
      scene["solver"]["linear"] = "pcg_multigrid";
      return iterations_a_newton_step(scene);
    };
    const double on_coarse = count(coarse, 1e7), on_fine = count(2 * coarse, 1e7), stiff = count(coarse, 1e9);
    CAPTURE(on_coarse);
    CHECK(on_fine < 1.2 * on_coarse);
    CHECK(stiff < 1.2 * on_coarse);
    CHECK(on_fine < 8);
  }
}

TEST_CASE("auto: block-Jacobi where material is soft, multigrid where it is stiff, factors where nothing coarsens") {
  test::Json thin = bar(2, 10, 1e10);
  thin["bodies"][0]["shape"] = test::box({0, 0}, {10, 0.1});
  const std::pair<test::Json, const char*> cases[] = {{bar(3, 12, 1e4), "pcg_jacobi"},
                                                      {bar(3, 12, 1e8), "pcg_multigrid"},
                                                      {bar(2, 32, 1e4), "pcg_jacobi"},
                                                      {bar(2, 32, 1e9), "pcg_multigrid"},
                                                      {thin, "direct"}};
  for (const auto& [scene, name] : cases) {
    CAPTURE(name);
    const auto simulation = test::start(scene);
    test::run(*simulation, 2);
    const std::string choice = simulation->solver_choice();
    CAPTURE(choice);
    CHECK(choice.starts_with(name));
    CHECK(choice.find(": ") != std::string::npos);
    test::run(*simulation, 2);  // and it stays
    CHECK(simulation->solver_choice().starts_with(name));
  }
}

TEST_CASE(
    "auto: multigrid that was chosen by expectation gives way where block-Jacobi turns out cheaper, and a resumed "
    "run chooses alike") {
  // Waves cross 23 cells a step of the small stiff body, so block-Jacobi is expected to take 60 iterations; but that
  // body only falls, and the soft one needs few of them.
  test::Json scene = bar(2, 32, 1e4);
  scene.erase("constraints");
  scene["bodies"][0]["velocity"] = {"0.1*Y", 0};
  scene["materials"]["stiff"] = scene["materials"]["rubber"];
  scene["materials"]["stiff"]["young"] = 4e6;
  scene["bodies"].push_back({{"name", "pebble"}, {"material", "stiff"}, {"shape", test::box({3, 0}, {3.1, 0.1})}});
  const auto simulation = test::start(scene);
  test::run(*simulation, 2);
  CHECK(simulation->solver_choice().starts_with("pcg_multigrid"));
  test::run(*simulation, 20);
  const auto resumed = test::start(scene);
  std::istringstream saved(test::state_of(*simulation));
  resumed->load_state(saved);
  for (int k = 0; k < 30; ++k) {
    test::run(*simulation, 1);
    test::run(*resumed, 1);
    CHECK(resumed->solver_choice() == simulation->solver_choice());
  }
  CHECK(simulation->solver_choice().starts_with("pcg_jacobi"));
}
