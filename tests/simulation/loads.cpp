// Forces from outside: tractions, body forces, prescribed motion (THEORY T3, INTERFACE fine print 6).
#include "core/bases/basis.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

Vec3 momentum(const Simulation& simulation) {
  return simulation.report().balance.momentum;
}

test::Json exact_block(int dimension, std::string_view basis) {
  test::Json scene = test::block(dimension);
  scene["grid"]["basis"] = basis;
  scene["solver"] = {{"newton_tolerance", 1e-12}};
  return scene;
}

}  // namespace

TEST_CASE("a traction's total force is traction times area") {
  for (const int dimension : {2, 3})
    for (const BasisInfo& basis : bases()) {
      CAPTURE(dimension);
      CAPTURE(basis.name);
      test::Json scene = exact_block(dimension, basis.name);
      scene["loads"] = {{{"body", "block"},
                         {"region", test::box(test::point(dimension, 0.5, 0, 0), test::point(dimension, 0.5, 1, 1))},
                         {"traction", test::point(dimension, 300, -120, 70)}}};
      const auto simulation = test::start(scene);
      test::run(*simulation, 1);
      const double area = dimension == 2 ? 0.4 : 0.16;
      const Vec3 expected = 0.01 * area * Vec3(300, -120, dimension == 2 ? 0 : 70);
      CHECK((momentum(*simulation) - expected).norm() < 1e-9 * expected.norm());
      // Nominal: the same force on the deformed body.
      test::run(*simulation, 9);
      CHECK((momentum(*simulation) - 10 * expected).norm() < 1e-8 * expected.norm());
    }
}

TEST_CASE("a traction that varies along the surface and in time gives the integral at the stage time") {
  test::Json scene = exact_block(2, "quadratic");
  scene["loads"] = {{{"body", "block"}, {"region", test::box({0.5, 0}, {0.5, 1})}, {"traction", {"1000*Y*t", 0}}}};
  scene["solver"] = {{"newton_tolerance", 1e-9}};  // the loads are small: below this the stress is rounding
  const auto simulation = test::start(scene);
  test::run(*simulation, 3);
  // Backward Euler: dt sum t_n; integral of Y over [0.1, 0.5] is 0.12.
  CHECK(momentum(*simulation)[0] == doctest::Approx(1000 * 0.12 * 0.01 * (0.01 + 0.02 + 0.03)).epsilon(1e-7));
}

TEST_CASE("gravity and a body force give every particle its own acceleration") {
  test::Json scene = exact_block(3, "quadratic");
  scene["gravity"] = {0, -9.81, 0};
  scene["body_force"] = {"2*X", "t", "-Y*Z"};
  const auto simulation = test::start(scene);
  test::run(*simulation, 1);
  Vec3 expected = Vec3::Zero();
  for (const ParticleState& p : simulation->particles())
    expected += 0.01 * p.mass * Vec3(2 * p.X[0], -9.81 + 0.01, -p.X[1] * p.X[2]);
  CHECK((momentum(*simulation) - expected).norm() < 1e-9 * expected.norm());
}

TEST_CASE("a prescribed velocity displaces by its integral, whatever the step") {
  for (const double step : {0.01, 0.004}) {
    test::Json scene = test::block();
    scene["time"]["step"] = step;
    scene["constraints"] = {
        {{"region", test::box({-9, -9}, {9, 9})}, {"fix", {true, true}}, {"velocity", {"sin(10*t)", "3*t^2"}}}};
    const auto simulation = test::start(scene);
    test::run(*simulation, 20);
    const double t = simulation->time();
    for (const ParticleState& p : simulation->particles()) {
      CHECK(p.x[0] - p.X[0] == doctest::Approx((1 - std::cos(10 * t)) / 10).epsilon(1e-9));
      CHECK(p.x[1] - p.X[1] == doctest::Approx(t * t * t).epsilon(1e-9));
    }
  }
}

TEST_CASE("constraints hold one component and leave the other") {
  test::Json scene = exact_block(2, "quadratic");
  scene["gravity"] = {1, -9.81};
  scene["constraints"] = {{{"region", test::box({-9, -9}, {9, 9})}, {"fix", {false, true}}}};
  const auto simulation = test::start(scene);
  test::run(*simulation, 10);
  CHECK(test::mean_velocity(*simulation)[0] == doctest::Approx(0.1).epsilon(1e-9));
  for (const ParticleState& p : simulation->particles()) CHECK(std::abs(p.x[1] - p.X[1]) < 1e-14);
}
