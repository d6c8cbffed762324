// Rigid boundaries and Coulomb friction (THEORY T7).
#include <numbers>

#include "core/bases/basis.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

/// Half the basis' support: how far from a wall its nodes feel the material.
double reach(const BasisInfo& basis) {
  return 0.5 * basis.nodes_per_axis * 0.1;
}

/// A flat stiff block that lies on the floor y = 0, gravity turned by `angle` instead of the floor.
test::Json incline(double angle, double mu) {
  test::Json scene = test::block();
  scene["grid"]["spacing"] = 0.05;
  scene["time"]["step"] = 0.005;
  scene["bodies"][0]["shape"] = test::box({0, 0}, {0.4, 0.1});
  scene["materials"]["rubber"]["young"] = 1e7;
  scene["gravity"] = {10 * std::sin(angle), -10 * std::cos(angle)};
  scene["boundaries"] = test::Json::array({test::floor_at(2, 0)});
  scene["boundaries"][0]["friction"] = mu;
  return scene;
}

}  // namespace

TEST_CASE("a dropped block comes to rest above the floor and never goes through it") {
  for (const int dimension : {2, 3})
    for (const BasisInfo& basis : bases()) {
      CAPTURE(dimension);
      CAPTURE(basis.name);
      test::Json scene = test::block(dimension, 0.1, dimension == 2 ? 0.5 : 0.3);
      scene["grid"]["basis"] = basis.name;
      scene["gravity"] = test::point(dimension, 0, -9.81);
      scene["boundaries"] = test::Json::array({test::floor_at(dimension, 0)});
      const auto simulation = test::start(scene);
      for (int k = 0; k < 120; ++k) {
        test::run(*simulation, 1);
        REQUIRE(test::lowest(*simulation) > 0);
      }
      CHECK(test::mean_velocity(*simulation).norm() < 0.1);  // it fell with 1.4 m/s and rings a little
      CHECK(test::lowest(*simulation) < reach(basis));
    }
}

TEST_CASE("first touch comes up to half the basis' support early, and not before") {
  for (const BasisInfo& basis : bases()) {
    CAPTURE(basis.name);
    test::Json scene = test::block();
    scene["grid"]["basis"] = basis.name;
    scene["time"]["step"] = 0.002;
    scene["bodies"][0]["velocity"] = {0, -1};
    scene["boundaries"] = test::Json::array({test::floor_at(2, -0.2)});
    const auto simulation = test::start(scene);
    const double before = test::mean_velocity(*simulation)[1];
    double gap = 1e300;
    while (std::abs(test::mean_velocity(*simulation)[1] - before) < 1e-9) {
      gap = test::lowest(*simulation) + 0.2;
      REQUIRE(gap > 0);
      test::run(*simulation, 1);
    }
    CHECK(gap <= reach(basis) + 1e-9);
    CHECK(gap > reach(basis) - 0.15);
  }
}

TEST_CASE("a slipping floor holds from both sides and lets everything slide") {
  test::Json scene = test::block(2, 0, 0.3);
  scene["bodies"][0]["velocity"] = {1, 1};
  scene["boundaries"] = test::Json::array({test::floor_at(2, 0)});
  scene["boundaries"][0]["contact"] = "slip";
  scene["solver"] = {{"newton_tolerance", 1e-10}};
  const auto simulation = test::start(scene);
  test::run(*simulation, 30);
  CHECK(test::mean_velocity(*simulation)[0] == doctest::Approx(1).epsilon(1e-8));
  CHECK(std::abs(test::mean_velocity(*simulation)[1]) < 0.5);
  CHECK(test::lowest(*simulation) < 0.1);
  scene["boundaries"][0]["contact"] = "separate";
  const auto free = test::start(scene);
  test::run(*free, 30);
  CHECK(test::mean_velocity(*free)[1] == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("a sticking wall carries a body along; one that only touches pushes it ahead") {
  for (const char* contact : {"stick", "separate"}) {
    CAPTURE(contact);
    test::Json scene = test::block(2, 0.0, 0.4);
    scene["boundaries"] = {{{"shape", {{"type", "half_space"}, {"point", {0, 0}}, {"normal", {1, 0}}}},
                            {"contact", contact},
                            {"velocity", {"min(1, 5*t)", 0}}}};
    const auto simulation = test::start(scene);
    for (int k = 0; k < 100; ++k) {
      test::run(*simulation, 1);
      const double t = simulation->time(), wall = t < 0.2 ? 2.5 * t * t : 0.1 + t - 0.2;
      for (const ParticleState& p : simulation->particles()) REQUIRE(p.x[0] > wall);
    }
    const double v = test::mean_velocity(*simulation)[0];
    CHECK(v > 0.9);
    CHECK(v < 1.5);
    if (std::string_view(contact) == "stick") CHECK(v == doctest::Approx(1).epsilon(0.05));
  }
}

TEST_CASE("a container's corner holds what is thrown into it, from every side") {
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    test::Json scene = test::block(dimension, 0.35, 0.65);
    scene["bodies"][0]["velocity"] = test::point(dimension, 4, -3, 3.5);
    scene["boundaries"] = {
        {{"shape", test::box(test::point(dimension, 0, 0, 0), test::point(dimension, 1, 1, 1))}, {"invert", true}}};
    const auto simulation = test::start(scene);
    for (int k = 0; k < 60; ++k) {
      test::run(*simulation, 1);
      for (const ParticleState& p : simulation->particles())
        for (int a = 0; a < dimension; ++a) REQUIRE((p.x[a] > 0 && p.x[a] < 1));
    }
  }
}

TEST_CASE("a block slides down an incline with g (sin - mu cos) when tan exceeds mu") {
  const double angle = std::numbers::pi / 6;
  for (const double mu : {0.0, 0.2, 0.4}) {
    CAPTURE(mu);
    const auto simulation = test::start(incline(angle, mu));
    test::run(*simulation, 20);
    const double before = test::mean_velocity(*simulation)[0];
    test::run(*simulation, 40);
    const double acceleration = (test::mean_velocity(*simulation)[0] - before) / 0.2;
    CHECK(acceleration == doctest::Approx(10 * (std::sin(angle) - mu * std::cos(angle))).epsilon(0.03));
    CHECK(test::lowest(*simulation) > 0);
  }
}

TEST_CASE("a block on an incline stays where it is when mu exceeds tan") {
  const double angle = std::numbers::pi / 6;
  for (const double mu : {0.65, 1.0}) {
    CAPTURE(mu);
    const auto simulation = test::start(incline(angle, mu));
    const double x = test::centre(*simulation)[0];
    test::run(*simulation, 60);
    CHECK(test::centre(*simulation)[0] - x < 1e-3);
    CHECK(std::abs(test::mean_velocity(*simulation)[0]) < 1e-3);
  }
}

namespace {

/// A ball above a valley of two walls, neither upright nor at right angles; in 3D a third wall and a smaller ball.
test::Json valley(int dimension, double mu) {
  test::Json scene = test::block(dimension);
  const bool flat = dimension == 2;
  scene["gravity"] = test::point(dimension, 0, -9.81);
  scene["grid"]["spacing"] = flat ? 0.05 : 0.1;
  scene["bodies"][0]["shape"] = {
      {"type", "ball"}, {"center", test::point(dimension, 0, flat ? 0.75 : 0.6)}, {"radius", flat ? 0.3 : 0.25}};
  const auto wall = [&](double x, double y, double z) {
    return test::Json{{"shape",
                       {{"type", "half_space"},
                        {"point", test::point(dimension, 0, 0)},
                        {"normal", test::point(dimension, x, y, z)}}},
                      {"friction", mu}};
  };
  scene["boundaries"] = {wall(0.6, 0.8, 0.1), wall(-0.5, 0.9, 0.2)};
  if (!flat) scene["boundaries"].push_back(wall(0.1, 0.9, -0.6));
  return scene;
}

}  // namespace

TEST_CASE("oblique walls that meet, smooth or rough, never cost a retry and hold what falls between them") {
  for (const int dimension : {2, 3})
    for (const double mu : {0.0, 0.4}) {
      CAPTURE(dimension);
      CAPTURE(mu);
      const auto simulation = test::start(valley(dimension, mu));
      for (int k = 0; k < (dimension == 2 ? 200 : 80); ++k) {
        test::run(*simulation, 1);
        const StepReport& report = simulation->report();
        REQUIRE_MESSAGE(report.retries == 0, report.warnings.front());
        REQUIRE(report.residual <= 1e-6);
      }
      CHECK(test::mean_velocity(*simulation).norm() < 0.5);  // it fell with nearly 3 m/s and rings
      CHECK(test::centre(*simulation).head<2>().norm() < 0.6);
    }
}

TEST_CASE("oblique walls in 3D under multigrid: held nodes' rounding is none of its business") {
  for (const double mu : {0.0, 0.4}) {
    CAPTURE(mu);
    test::Json scene = valley(3, mu);
    scene["solver"] = {{"linear", "pcg_multigrid"}};
    const auto simulation = test::start(scene);
    for (int k = 0; k < 40; ++k) {
      test::run(*simulation, 1);
      REQUIRE(simulation->report().retries == 0);
    }
  }
}

TEST_SUITE("long") {
  TEST_CASE("no shipped scene needs a retry, at its own tolerance or at 1e-6, smooth or rough") {
    for (const std::string name : {"welcome", "colliding-discs", "drooping-cantilever", "spinning-disc",
                                   "stretched-strip", "twisted-bar", "torus-on-ball"})
      for (const bool rough : {false, true}) {
        CAPTURE(name);
        CAPTURE(rough);
        std::vector<Edit> edits;
        if (rough) edits = {parse_set("/solver/newton_tolerance=1e-6")};
        Scene scene = load_scene(PUSHFORWARD_SOURCE "/assets/scenes/" + name + ".json", edits);
        if (rough)
          for (Boundary& wall : scene.boundaries) wall.friction = 0.4;
        const auto simulation = make_simulation(scene, {2});
        int retries = 0;
        StepStatus status = StepStatus::accepted;
        while ((status = simulation->step().status) == StepStatus::accepted) retries += simulation->report().retries;
        CHECK(status == StepStatus::finished);
        CHECK(retries == 0);
      }
  }
}
