// What `newton_tolerance` promises: the same at any stiffness, spacing and time step (THEORY T4).
#include <algorithm>

#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

/// A bar held at one end begins to fall.
test::Json bar(double young, double spacing, double dt, double tolerance) {
  test::Json scene = test::block(2);
  scene["gravity"] = {0, -9.81};
  scene["grid"]["spacing"] = spacing;
  scene["time"]["step"] = dt;
  scene["solver"]["newton_tolerance"] = tolerance;
  scene["materials"]["rubber"]["young"] = young;
  scene["bodies"][0]["shape"] = test::box({0, 0}, {2, 1});
  scene["constraints"] = test::Json::array({{{"region", test::box({-1, -1}, {0, 2})}, {"fix", {true, true}}}});
  return scene;
}

std::vector<ParticleState> after_steps(const test::Json& scene, int steps) {
  const auto simulation = test::start(scene);
  for (int k = 0; k < steps; ++k) {
    test::run(*simulation, 1);
    REQUIRE(simulation->report().retries == 0);  // a shorter step would be another motion
  }
  return simulation->particles();
}

}  // namespace

TEST_CASE("what is left of the motion's error follows Newton's tolerance, at any stiffness, spacing and time step") {
  constexpr int steps = 4;
  for (const double young : {1e4, 1e6, 1e8, 1e10})
    for (const double spacing : {1. / 8, 1. / 24})
      for (const double dt : {1e-4, 1e-3, 1e-2}) {
        CAPTURE(young);
        CAPTURE(spacing);
        CAPTURE(dt);
        // Where waves cross the body many times in a step nothing but stiffness resists, and the slowest modes make
        // much of a small force.
        const double wave = std::sqrt(1.35 * young / 1000);
        const double amplification = wave * dt < 4 ? 10 : 200;
        const auto exact = after_steps(bar(young, spacing, dt, 1e-8), steps);
        for (const double tolerance : {1e-3, 1e-5}) {
          CAPTURE(tolerance);
          const auto found = after_steps(bar(young, spacing, dt, tolerance), steps);
          double apart = 0, moved = 0;
          for (std::size_t p = 0; p < exact.size(); ++p) {
            apart = std::max(apart, (found[p].x - exact[p].x).norm());
            moved = std::max(moved, (exact[p].x - exact[p].X).norm());
          }
          CHECK(apart < amplification * tolerance * moved);
        }
      }
}
