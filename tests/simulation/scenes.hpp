// Small scenes for tests of whole steps, built as JSON, and what the tests ask of them.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include "core/scene/scene_io.hpp"
#include "core/simulation.hpp"

namespace pf::test {

using Json = nlohmann::ordered_json;

/// [x, y] or [x, y, z].
inline Json point(int dimension, double x, double y, double z = 0) {
  return dimension == 2 ? Json{x, y} : Json{x, y, z};
}
inline Json box(const Json& min, const Json& max) {
  return {{"type", "box"}, {"min", min}, {"max", max}};
}
inline Json floor_at(int dimension, double y) {
  return {{"shape", {{"type", "half_space"}, {"point", point(dimension, 0, y)}, {"normal", point(dimension, 0, 1)}}}};
}

/// A block of rubber [low, high]^D on a grid of spacing 0.1, in free flight.
inline Json block(int dimension = 2, double low = 0.1, double high = 0.5) {
  return {
      {"dimension", dimension},
      {"grid", {{"spacing", 0.1}, {"basis", "quadratic"}}},
      {"time", {{"end", 100}, {"step", 0.01}}},
      {"transfer", {{"type", "apic"}}},
      {"materials", {{"rubber", {{"model", "neo_hookean"}, {"density", 1000}, {"young", 1e5}, {"poisson", 0.3}}}}},
      {"bodies", Json::array({{{"name", "block"},
                               {"material", "rubber"},
                               {"shape", box(point(dimension, low, low, low), point(dimension, high, high, high))}}})}};
}

inline std::unique_ptr<Simulation> start(const Json& scene, int threads = 1) {
  return make_simulation(parse_scene(scene.dump(), "test"), {threads});
}

/// `steps` accepted steps.
inline void run(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) {
    const StepReport& report = simulation.step();
    REQUIRE_MESSAGE(report.status == StepStatus::accepted, report.failure);
  }
}

inline std::string state_of(const Simulation& simulation) {
  std::ostringstream out;
  simulation.save_state(out);
  return out.str();
}

/// The same to the bit.
inline void check_equal(const std::vector<ParticleState>& a, const std::vector<ParticleState>& b) {
  REQUIRE(a.size() == b.size());
  bool same = true;
  for (std::size_t p = 0; p < a.size(); ++p)
    same = same && a[p].id == b[p].id && a[p].x == b[p].x && a[p].v == b[p].v && a[p].F == b[p].F &&
           a[p].sigma == b[p].sigma && a[p].energy_density == b[p].energy_density && a[p].mass == b[p].mass;
  CHECK(same);
}

/// Everything but wall times, to the bit.
inline void check_equal(const StepReport& a, const StepReport& b) {
  CHECK(a.status == b.status);
  CHECK(a.step == b.step);
  CHECK(a.time == b.time);
  CHECK(a.dt == b.dt);
  CHECK(a.residual == b.residual);
  CHECK(a.linear_iterations == b.linear_iterations);
  REQUIRE(a.newton.size() == b.newton.size());
  for (std::size_t k = 0; k < a.newton.size(); ++k) {
    CHECK(a.newton[k].residual == b.newton[k].residual);
    CHECK(a.newton[k].energy == b.newton[k].energy);
    CHECK(a.newton[k].step_length == b.newton[k].step_length);
    CHECK(a.newton[k].linear_iterations == b.newton[k].linear_iterations);
    CHECK(a.newton[k].projected == b.newton[k].projected);
    CHECK(a.newton[k].residual_search == b.newton[k].residual_search);
  }
  CHECK(a.balance.kinetic == b.balance.kinetic);
  CHECK(a.balance.elastic == b.balance.elastic);
  CHECK(a.balance.potential == b.balance.potential);
  CHECK(a.balance.momentum == b.balance.momentum);
  CHECK(a.balance.angular_momentum == b.balance.angular_momentum);
  CHECK(a.angular.transfer == b.angular.transfer);
  CHECK(a.angular.time_integration == b.angular.time_integration);
  CHECK(a.angular.outside == b.angular.outside);
  CHECK(a.error.l2 == b.error.l2);
  CHECK(a.error.max == b.error.max);
  CHECK(a.error.velocity_l2 == b.error.velocity_l2);
  CHECK(a.error.F_l2 == b.error.F_l2);
  CHECK(a.min_J == b.min_J);
  CHECK(a.max_J == b.max_J);
  CHECK(a.active_nodes == b.active_nodes);
  CHECK(a.cfl == b.cfl);
  CHECK(a.retries == b.retries);
  CHECK(a.warnings == b.warnings);
}

/// Momentum over mass.
inline Vec3 mean_velocity(const Simulation& simulation) {
  double mass = 0;
  Vec3 momentum = Vec3::Zero();
  for (const ParticleState& p : simulation.particles()) {
    mass += p.mass;
    momentum += p.mass * p.v;
  }
  return momentum / mass;
}
inline Vec3 centre(const Simulation& simulation) {
  double mass = 0;
  Vec3 sum = Vec3::Zero();
  for (const ParticleState& p : simulation.particles()) {
    mass += p.mass;
    sum += p.mass * p.x;
  }
  return sum / mass;
}
inline double lowest(const Simulation& simulation) {
  double y = 1e300;
  for (const ParticleState& p : simulation.particles()) y = std::min(y, p.x[1]);
  return y;
}

}  // namespace pf::test
