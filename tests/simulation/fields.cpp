// The fields that snapshots carry: each against the state of the particle, or the look at the node, that it is of.
#include "core/diagnostics/fields.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "core/diagnostics/strain.hpp"
#include "core/look.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;
using namespace pf::test;

namespace {

constexpr std::uint64_t all = ~std::uint64_t{0};

/// Spinning, so that every component of every field is something.
std::unique_ptr<Simulation> moved(int dimension) {
  Json scene = block(dimension);
  scene["gravity"] = point(dimension, 0, -9.81);
  scene["bodies"][0]["velocity"] = dimension == 2 ? Json{"-6*Y+X", "9*X"} : Json{"-6*Y+2*Z", "9*X", "3*Y-X"};
  auto simulation = make_simulation(parse_scene(scene.dump(), "test"), {1, ""});
  simulation->set_recording(RecordLevel::residuals);
  for (int k = 0; k < 5; ++k) REQUIRE(simulation->step().status == StepStatus::accepted);
  return simulation;
}

double value(const Snapshot& s, Field field, std::size_t i) {
  return s.field[static_cast<std::size_t>(field)].at(i);
}
Field after(Field field, int k) {
  return static_cast<Field>(static_cast<int>(field) + k);
}

}  // namespace

TEST_CASE("fields of particles are those of their states, in 2D and 3D") {
  for (const int d : {2, 3}) {
    CAPTURE(d);
    const auto simulation = moved(d);
    Snapshot s;
    simulation->capture({.fields = all, .grid = true, .stress = true}, s);
    double off_diagonal = 0;
    for (std::size_t p = 0; p < s.particles; p += 7) {
      const ParticleState state = simulation->particle(s.id[p]);
      const auto near = [&](Field field, double expected, double size) {
        CAPTURE(field_info(field).key);
        CHECK(std::abs(value(s, field, p) - expected) <= 1e-6 * (size + std::abs(expected)));
      };
      const double stress = state.sigma.norm();
      const Vec3 u = state.x - state.X;
      for (int a = 0; a < 3; ++a) {
        near(after(Field::velocity_x, a), state.v[a], 0.1);
        near(after(Field::displacement_x, a), u[a], 0.01);
        near(after(Field::stress_xx, a), state.sigma(a, a), stress);
      }
      near(Field::displacement, u.norm(), 0);
      constexpr int pairs[3][2] = {{0, 1}, {1, 2}, {0, 2}};
      const Mat3 E = 0.5 * (state.F.transpose() * state.F - Mat3::Identity());
      for (int k = 0; k < 3; ++k) {
        near(after(Field::stress_xy, k), state.sigma(pairs[k][0], pairs[k][1]), stress);
        near(after(Field::strain_xy, k), E(pairs[k][0], pairs[k][1]), 1);
        near(after(Field::strain_xx, k), E(k, k), 1);
      }
      off_diagonal += std::abs(state.sigma(0, 1));
      const Vec3 principal = Eigen::SelfAdjointEigenSolver<Mat3>(state.sigma).eigenvalues();
      for (int k = 0; k < 3; ++k) near(after(Field::stress_1, k), principal[2 - k], stress);
      near(Field::shear, 0.5 * (principal[2] - principal[0]), stress);
      double product = 1;
      for (int k = 0; k < 3; ++k) product *= value(s, after(Field::stretch_1, k), p);
      CHECK(product == doctest::Approx(state.F.determinant()).epsilon(1e-5));
      CHECK(value(s, Field::stretch_1, p) >= value(s, Field::stretch_2, p));
      const double density = state.mass / (state.volume0 * state.F.determinant());
      near(Field::kinetic_density, 0.5 * density * state.v.squaredNorm(), 0);
      for (int c = 0; c < 3; ++c)
        CHECK(s.stress[6 * p + static_cast<std::size_t>(c)] == doctest::Approx(state.sigma(c, c)).epsilon(1e-5));
    }
    CHECK(off_diagonal > 0);
  }
}

TEST_CASE("equivalent strain is the logarithm of a bar's stretch at constant volume; rotations are no strain") {
  for (const double stretch : {0.5, 1.0, 1.7}) {
    const Mat3 bar = Vec3(stretch, 1 / std::sqrt(stretch), 1 / std::sqrt(stretch)).asDiagonal();
    Mat3 turn;
    turn << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
    CHECK(equivalent_strain<3>(turn * bar) == doctest::Approx(std::abs(std::log(stretch))).epsilon(1e-10));
    CHECK((green_strain<3>(turn * bar) - green_strain<3>(bar)).norm() < 1e-12);
    CHECK(principal_stretches<3>(turn * bar).maxCoeff() == doctest::Approx(bar.maxCoeff()));
  }
  // Plane strain: the third stretch is 1, and counts.
  const Mat<2> flat = Vec<2>(2, 0.5).asDiagonal();
  CHECK(equivalent_strain<2>(flat) == doctest::Approx(2 / std::sqrt(3.0) * std::log(2)));
}

TEST_CASE("fields of nodes are the step's: mass adds up, inner forces are those that a look at the node finds") {
  for (const int d : {2, 3}) {
    CAPTURE(d);
    const auto simulation = moved(d);
    Snapshot s;
    simulation->capture({.fields = all, .grid = true}, s);
    REQUIRE(s.nodes > 20);
    double mass = 0, residuals = 0, largest = 0;
    for (std::size_t i = 0; i < s.nodes; ++i) {
      mass += value(s, Field::node_mass, i);
      residuals += value(s, Field::node_residual, i);
      largest = std::max(largest, value(s, Field::node_force, i));
      const Vec3 v(value(s, Field::node_velocity_x, i), value(s, Field::node_velocity_y, i),
                   value(s, Field::node_velocity_z, i));
      CHECK(v.norm() == doctest::Approx(value(s, Field::node_speed, i)).epsilon(1e-5));
      CHECK(v.y() == doctest::Approx(s.node_velocity[i * static_cast<std::size_t>(d) + 1]).epsilon(1e-5));
    }
    CHECK(mass == doctest::Approx(simulation->mass()).epsilon(1e-5));
    CHECK(largest > 0);
    CHECK(residuals > 0);
    CHECK(residuals < 0.1 * largest * static_cast<double>(s.nodes));
    for (std::size_t i = 0; i < s.nodes; i += 1 + s.nodes / 20) {
      NodeIndex index{};
      for (std::size_t a = 0; a < static_cast<std::size_t>(d); ++a)
        index[a] = s.node_index[i * static_cast<std::size_t>(d) + a];
      const Look look = simulation->look({{}, index});
      REQUIRE(look.node);
      CHECK(std::abs(value(s, Field::node_force, i) - look.node->internal.norm()) < 1e-5 * largest);
      for (int a = 0; a < d; ++a)
        CHECK(std::abs(value(s, after(Field::node_force_x, a), i) - look.node->internal[a]) < 1e-5 * largest);
    }
  }
}

TEST_CASE("only what is asked for is worked out") {
  const auto simulation = moved(2);
  Snapshot s;
  simulation->capture({.fields = field_bit(Field::stress_xy)}, s);
  for (const FieldInfo& info : fields())
    CHECK(s.field[static_cast<std::size_t>(info.field)].size() ==
          (info.field == Field::stress_xy ? s.particles : std::size_t{0}));
  CHECK(s.stress.empty());
  simulation->capture({.fields = field_bit(Field::node_mass), .grid = true}, s);
  for (const FieldInfo& info : fields())
    CHECK(s.field[static_cast<std::size_t>(info.field)].size() ==
          (info.field == Field::node_mass ? s.nodes : std::size_t{0}));
}
