// Motions whose answer is known without a formula: free flight, spin, a particle by itself (THEORY T6).
#include "core/bases/basis.hpp"
#include "core/integrators/integrator.hpp"
#include "core/transfers/transfer.hpp"
#include "tests/numerics.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;

namespace {

test::Json flying(int dimension, std::string_view basis, std::string_view transfer, const test::Json& velocity) {
  test::Json scene = test::block(dimension, 0.1, 0.3);
  scene["grid"]["basis"] = basis;
  scene["transfer"] = {{"type", transfer}};
  scene["bodies"][0]["velocity"] = velocity;
  return scene;
}

}  // namespace

TEST_CASE("a free body in uniform motion moves exactly and stays unstrained, also exactly on cell faces") {
  // Particles start at odd multiples of dx/4; these velocities carry some of them onto faces and nodes at every step.
  for (const int dimension : {2, 3})
    for (const BasisInfo& basis : bases())
      for (const TransferInfo& transfer : transfers())
        for (const IntegratorInfo& integrator : integrators())
          for (const Vec3& v : {Vec3(2.5, -5, 7.5), Vec3(-2.5, 1.25, 0), Vec3(0.37, -0.11, 3)}) {
            if (!integrator.inertia) continue;  // refuses a free body
            CAPTURE(dimension);
            CAPTURE(basis.name);
            CAPTURE(transfer.name);
            CAPTURE(integrator.name);
            CAPTURE(v[0]);
            test::Json scene = flying(dimension, basis.name, transfer.name, test::point(dimension, v[0], v[1], v[2]));
            scene["integrator"] = {{"type", integrator.name}};
            if (!integrator.implicit) scene["materials"]["rubber"]["young"] = 1e4;  // within the explicit limit
            const auto simulation = test::start(scene);
            test::run(*simulation, 8);
            double x = 0, speed = 0, F = 0;
            const Vec3 in_plane = dimension == 2 ? Vec3(v[0], v[1], 0) : v;
            for (const ParticleState& p : simulation->particles()) {
              x = std::max(x, (p.x - p.X - 0.08 * in_plane).norm());
              speed = std::max(speed, (p.v - in_plane).norm());
              F = std::max(F, (p.F - Mat3::Identity()).norm());
            }
            CHECK(x < 1e-12);
            CHECK(speed < 1e-11);
            CHECK(F < 1e-11);
          }
}

TEST_CASE("a free body keeps its linear momentum under every basis and transfer") {
  for (const int dimension : {2, 3})
    for (const BasisInfo& basis : bases())
      for (const TransferInfo& transfer : transfers()) {
        CAPTURE(dimension);
        CAPTURE(basis.name);
        CAPTURE(transfer.name);
        const test::Json turning =
            dimension == 2 ? test::Json{"1 - 2*Y", "0.5 + 2*X"} : test::Json{"1 - 2*Y", "0.5 + 2*X", "0.3"};
        const auto simulation = test::start(flying(dimension, basis.name, transfer.name, turning));
        const Vec3 before = simulation->report().balance.momentum;
        test::run(*simulation, 10);
        CHECK((simulation->report().balance.momentum - before).norm() < 1e-6 * before.norm());
      }
}

TEST_CASE("linear momentum is kept with every choice of mass matrix") {
  for (const TransferInfo& transfer : transfers())
    for (const char* inertia : {"lumped", "consistent"})
      for (const char* velocity : {"lumped", "consistent"}) {
        const bool refuses = transfer.name == "apic" || transfer.name == "fmpm";
        if (refuses && std::string_view(velocity) == "consistent") continue;
        CAPTURE(transfer.name);
        CAPTURE(inertia);
        CAPTURE(velocity);
        test::Json scene = flying(2, "quadratic", transfer.name, {"1 - 2*Y", "0.5 + 2*X"});
        scene["transfer"]["velocity_mass"] = velocity;
        scene["integrator"] = {{"mass", inertia}};
        scene["solver"] = {{"newton_tolerance", 1e-10}};
        const auto simulation = test::start(scene);
        const Vec3 before = simulation->report().balance.momentum;
        test::run(*simulation, 10);
        CHECK((simulation->report().balance.momentum - before).norm() < 1e-9 * before.norm());
      }
}

TEST_CASE("transfers and time integration take their own shares of angular momentum") {
  for (const int dimension : {2, 3})
    for (const BasisInfo& basis : bases())
      for (const TransferInfo& transfer : transfers()) {
        CAPTURE(dimension);
        CAPTURE(basis.name);
        CAPTURE(transfer.name);
        test::Json spin =
            dimension == 2 ? test::Json{"-3*(Y - 0.2)", "3*(X - 0.2)"} : test::Json{"-3*(Y - 0.2)", "3*(X - 0.2)", "0"};
        const auto simulation = test::start(flying(dimension, basis.name, transfer.name, spin));
        test::run(*simulation, 1);  // APIC's affine velocities start at zero: the first transfer is PIC's
        for (int k = 0; k < 3; ++k) {
          const Vec3 before = simulation->report().balance.angular_momentum;
          test::run(*simulation, 1);
          const StepReport& report = simulation->report();
          const Vec3 change = report.balance.angular_momentum - before;
          const AngularLedger& by = report.angular;
          CHECK((by.transfer + by.time_integration + by.outside - change).norm() < 1e-12 * before.norm());
          CHECK(by.outside.norm() < 1e-5 * before.norm());  // nothing turns it but what Newton left
          // Under the linear basis D_p changes as the particle moves while C_p is kept, under averaged ones as its
          // domain turns: small, but not rounding.
          const double kept = basis.affine_by_moments && !basis.averaged() ? 1e-12 : 5e-3;
          if (transfer.name == "apic") CHECK(report.angular.transfer.norm() < kept * before.norm());
          if (transfer.name == "pic") CHECK(report.angular.transfer.norm() > 1e-2 * before.norm());
          CHECK(report.angular.time_integration[2] < 0);  // backward Euler damps
        }
      }
}

TEST_CASE("backward Euler changes a free body's angular momentum by dt sum m v(n+1) x v(n)") {
  for (const BasisInfo& basis : test::sampled_bases()) {  // the sum is written out with the splines themselves
    CAPTURE(basis.name);
    test::Json scene = flying(2, basis.name, "pic", {"-3*(Y - 0.2)", "3*(X - 0.2)"});
    scene["solver"] = {{"newton_tolerance", 1e-11}};
    const auto simulation = test::start(scene);
    test::run(*simulation, 2);
    const std::vector<ParticleState> before = simulation->particles();
    test::run(*simulation, 1);
    Snapshot snapshot;
    simulation->capture({.fields = 0, .grid = true}, snapshot);
    double expected = 0;
    for (std::size_t i = 0; i < snapshot.nodes; ++i) {
      const Vec<2> x_i = 0.1 * Vec<2>(snapshot.node_index[2 * i], snapshot.node_index[2 * i + 1]);
      Vec<2> momentum = Vec<2>::Zero();
      for (const ParticleState& p : before)
        momentum += p.mass * test::shape<2>(basis.name, 0.1, x_i, Vec<2>(p.x.head<2>())) * p.v.head<2>();
      const double* v = &snapshot.node_velocity[2 * i];
      expected += 0.01 * (v[0] * momentum[1] - v[1] * momentum[0]);
    }
    CHECK(expected < 0);
    CHECK(simulation->report().angular.time_integration[2] == doctest::Approx(expected).epsilon(1e-7));
  }
}

namespace {

/// When a scheme's loads act in the mean, as a part of the step.
double mean_stage(std::string_view integrator) {
  if (integrator == "backward_euler") return 1;
  if (integrator == "symplectic_euler") return 0;
  if (integrator == "generalized_alpha") return 1 / 1.8;  // spectral radius 0.8
  return 0.5;
}

}  // namespace

TEST_CASE("the torque of gravity is no fault of the time scheme") {
  for (const IntegratorInfo& integrator : integrators())
    for (const char* inertia : {"lumped", "consistent"}) {
      if (!integrator.inertia) continue;
      CAPTURE(integrator.name);
      CAPTURE(inertia);
      test::Json scene = flying(2, "quadratic", "apic", {"1 - 2*(Y - 0.2)", "2*(X - 0.2)"});
      scene["gravity"] = {0, -10};
      scene["integrator"] = {{"type", integrator.name}, {"mass", inertia}};
      scene["solver"] = {{"newton_tolerance", 1e-11}};
      const auto simulation = test::start(scene);
      test::run(*simulation, 3);
      double mass = 0, before = 0, after = 0;
      for (const ParticleState& p : simulation->particles()) mass += p.mass, before += p.mass * p.x[0];
      test::run(*simulation, 1);
      for (const ParticleState& p : simulation->particles()) after += p.mass * p.x[0];
      REQUIRE(std::abs(after - before) > 1e-3 * mass);
      // The loads act where the scheme takes them, some at more than one time: on the mean there.
      const AngularLedger& by = simulation->report().angular;
      const double dt = simulation->report().dt, at = before + mean_stage(integrator.name) * (after - before);
      CHECK(by.outside[2] == doctest::Approx(-10 * dt * at).epsilon(1e-7));
      if (!integrator.implicit || integrator.name == "implicit_midpoint")
        CHECK(std::abs(by.time_integration[2]) < 1e-9 * std::abs(by.outside[2]));
    }
}

TEST_CASE("a particle by itself falls freely: fewer particles than nodes are no trouble to any mass matrix or solver") {
  for (const int dimension : {2, 3})
    for (const BasisInfo& basis : bases())
      for (const char* linear : {"pcg_jacobi", "direct"})
        for (const char* mass : {"lumped", "consistent"})
          for (const char* velocity : {"lumped", "consistent"}) {
            CAPTURE(dimension);
            CAPTURE(basis.name);
            CAPTURE(linear);
            CAPTURE(mass);
            CAPTURE(velocity);
            test::Json scene = test::block(dimension, 0.1, 0.15);
            scene["grid"]["basis"] = basis.name;
            scene["gravity"] = test::point(dimension, 1, -10);
            scene["transfer"] = {{"type", "flip"}, {"velocity_mass", velocity}};
            scene["integrator"] = {{"mass", mass}};
            scene["solver"] = {{"linear", linear}};
            const auto simulation = test::start(scene);
            REQUIRE(simulation->particle_count() == 1);
            test::run(*simulation, 5);
            const ParticleState p = simulation->particle(0);
            CHECK((p.v - Vec3(0.05, -0.5, 0)).norm() < 1e-5);
            CHECK((p.F - Mat3::Identity()).norm() < 1e-3);
          }
}

TEST_CASE("a body steps with consistent inertia under every basis and linear solver") {
  for (const BasisInfo& basis : bases())
    for (const char* linear : {"pcg_jacobi", "direct", "auto"}) {
      CAPTURE(basis.name);
      CAPTURE(linear);
      test::Json scene = flying(2, basis.name, "flip", {"2 - 4*Y", "3*X*X"});
      scene["transfer"]["velocity_mass"] = "consistent";
      scene["integrator"] = {{"mass", "consistent"}};
      scene["solver"] = {{"linear", linear}};
      const auto simulation = test::start(scene);
      const double before = simulation->report().balance.total();
      test::run(*simulation, 20);
      CHECK(simulation->report().balance.total() <= before * (1 + 1e-6));
      CHECK(simulation->report().balance.total() > 0.3 * before);
    }
}
