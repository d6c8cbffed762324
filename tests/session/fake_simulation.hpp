// A simulation without physics whose steps take as long as a test wants: for the timing of the worker.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <new>
#include <stdexcept>
#include <thread>

#include "core/scene/scene.hpp"
#include "core/simulation.hpp"

namespace pf::test {

/// Shared by a test and the simulations that it makes.
struct FakeControl {
  std::atomic<double> step_seconds{0};
  std::atomic<long> steps_begun{0}, steps_cancelled{0}, captures{0}, built{0};
  std::atomic<long> fail_at{-1};   ///< the step after this index fails
  std::atomic<long> throw_at{-1};  ///< the step after this index throws
  std::atomic<bool> capture_throws{false};
  std::atomic<double> gravity_seen{0};  ///< of the newest scene applied
};

class FakeSimulation : public Simulation {
 public:
  FakeSimulation(const Scene& scene, FakeControl& control) : scene_(scene), control_(control), end_(scene.time.end) {
    ++control_.built;
  }
  const Scene& scene() const override { return scene_; }
  std::size_t particle_count() const override { return 3; }
  double mass() const override { return 0; }
  double stable_step() const override { return 0; }
  double time() const override { return accepted_.time; }
  const StepReport& report() const override { return accepted_; }
  const StepReport& step(const std::atomic<bool>* cancel) override {
    other_ = {};
    ++control_.steps_begun;
    if (accepted_.time >= end_ - 1e-12) return with(StepStatus::finished);
    if (control_.throw_at >= 0 && accepted_.step >= control_.throw_at) throw std::runtime_error("out of everything");
    if (accepted_.step == control_.fail_at) {
      other_.failure = "particle 2 turned inside out";
      return with(StepStatus::failed);
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(control_.step_seconds.load());
    while (std::chrono::steady_clock::now() < end) {
      if (cancel && *cancel) {
        ++control_.steps_cancelled;
        return with(StepStatus::cancelled);
      }
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    ++accepted_.step;
    accepted_.dt = scene_.time.step;
    accepted_.time += scene_.time.step;
    return accepted_;
  }
  void set_end(double end) override { end_ = end; }
  bool apply(const Scene& scene) override {
    if (!(scene.grid == scene_.grid)) return false;
    scene_ = scene;
    control_.gravity_seen = scene.gravity.y();
    return true;
  }
  void set_grab(const std::optional<Grab>& grab) override { grab_ = grab; }
  void capture(const SnapshotRequest& request, Snapshot& into) const override {
    ++control_.captures;
    if (control_.capture_throws) throw std::bad_alloc();
    into.report = accepted_;
    into.particles = 3;
    into.x.assign(6, accepted_.time);
    into.id = {0, 1, 2};
    for (int f = 0; f < field_count; ++f)
      if (request.fields & field_bit(static_cast<Field>(f))) into.field[static_cast<std::size_t>(f)].assign(3, 1.0f);
  }
  std::vector<ProbeReading> probes() const override { return {}; }
  std::vector<ParticleState> particles() const override { return {}; }
  ParticleState particle(std::uint32_t id) const override {
    ParticleState p;
    p.id = id;
    return p;
  }
  std::string solver_choice() const override { return "fake"; }
  void save_state(std::ostream&) const override {}
  void load_state(std::istream&) override {}

 private:
  const StepReport& with(StepStatus status) {
    other_.status = status;
    other_.step = accepted_.step;
    other_.time = accepted_.time;
    return other_;
  }
  Scene scene_;
  FakeControl& control_;
  double end_;
  StepReport accepted_, other_;
  std::optional<Grab> grab_;
};

}  // namespace pf::test
