// A body in free flight whose every number is known: shows what the outputs do with a state, without a solver.
#pragma once

#include <istream>
#include <ostream>

#include "core/params/problem.hpp"
#include "core/simulation.hpp"

namespace pf::test {

/// Two particles moving with velocity (1, 2, 3); steps of time.step, the last one shortened to end at time.end.
class FreeFlight : public Simulation {
 public:
  explicit FreeFlight(Scene scene) : scene_(std::move(scene)) { describe(0); }

  const Scene& scene() const override { return scene_; }
  std::size_t particle_count() const override { return 2; }
  double mass() const override { return 4; }
  double stable_step() const override { return 0.125; }
  double time() const override { return report_.time; }
  const StepReport& report() const override { return report_; }
  const StepReport& step(const std::atomic<bool>* cancel) override {
    if (cancel != nullptr && cancel->load()) return attempt(StepStatus::cancelled);
    if (report_.step == fail_after) return attempt(StepStatus::failed);
    if (report_.time >= scene_.time.end) return attempt(StepStatus::finished);
    const double next = static_cast<double>(report_.step + 1) * scene_.time.step;
    const double dt = std::min(next, scene_.time.end) - report_.time;
    const double time = std::min(next, scene_.time.end);
    ++report_.step;
    report_.time = time;
    describe(dt);
    return report_;
  }
  void set_end(double end) override { scene_.time.end = end; }
  bool apply(const Scene& scene) override {
    applied.push_back(report_.step);
    if (scene.dimension != scene_.dimension) return false;
    scene_ = scene;
    return true;
  }
  void set_grab(const std::optional<Grab>& /*grab*/) override {}
  void capture(const SnapshotRequest& request, Snapshot& into) const override {
    into.dimension = scene_.dimension;
    into.spacing = 0.5;
    into.report = report_;
    into.nodes = 0;
    if (!request.grid || report_.step == 0) return;
    for (int j = 0; j < 2; ++j)
      for (int i = -1; i < 2; ++i) {
        into.node_index.insert(into.node_index.end(), {i, j});
        into.node_mass.push_back(1);
        into.node_velocity.insert(into.node_velocity.end(), {1.0, 2.0});
        into.node_displacement.insert(into.node_displacement.end(), {0.1, 0.2});
        into.node_state.push_back(1);
        ++into.nodes;
      }
  }
  std::vector<ProbeReading> probes() const override {
    std::vector<ProbeReading> readings;
    for (std::size_t k = 0; k < scene_.probes.size(); ++k)
      readings.push_back({k, 0, particle(0).x, particle(0).v, particle(0).sigma});
    return readings;
  }
  std::vector<ParticleState> particles() const override { return {particle(0), particle(1)}; }
  ParticleState particle(std::uint32_t id) const override {
    ParticleState state;
    state.id = id;
    state.mass = 2;
    state.volume0 = 0.25;
    state.X = Vec3(id, 0, 0);
    state.v = Vec3(1, 2, scene_.dimension == 3 ? 3 : 0);
    state.x = state.X + report_.time * state.v;
    state.F.diagonal() = Vec3(2, 1, 1);
    state.sigma << 1, 4, 6, 4, 2, 5, 6, 5, 3;
    return state;
  }
  std::string solver_choice() const override { return "none"; }
  void save_state(std::ostream& out) const override {
    out.write(reinterpret_cast<const char*>(&report_.step), sizeof report_.step);
    out.write(reinterpret_cast<const char*>(&report_.time), sizeof report_.time);
  }
  void load_state(std::istream& in) override {
    in.read(reinterpret_cast<char*>(&report_.step), sizeof report_.step);
    in.read(reinterpret_cast<char*>(&report_.time), sizeof report_.time);
    describe(scene_.time.step);
  }

  long fail_after = -1;
  std::vector<long> applied;  ///< steps after which a scene was applied

 private:
  const StepReport& attempt(StepStatus status) {
    attempt_ = report_;
    attempt_.status = status;
    if (status == StepStatus::failed) attempt_.failure = "particle 1 went away";
    return attempt_;
  }
  void describe(double dt) {
    report_.dt = dt;
    report_.newton.resize(report_.step > 0 ? 3 : 0);
    report_.linear_iterations = report_.step > 0 ? 7 : 0;
    report_.residual = 0.1;
    report_.balance.kinetic = 5;
    report_.balance.elastic = 1.0 / 3;
    report_.balance.potential = -report_.time;
    report_.balance.momentum = Vec3(4, 8, 12);
    report_.balance.angular_momentum = Vec3(-1, -2, -3);
    report_.min_J = 0.5;
    report_.max_J = 2;
    report_.active_nodes = 6;
    report_.cfl = 0.25;
    report_.ms.total = 1.5;
    report_.error = {!scene_.exact_position.empty(), 0.01, 0.02, 0.03, 0.04};
  }

  Scene scene_;
  StepReport report_, attempt_;
};

}  // namespace pf::test
