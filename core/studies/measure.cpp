#include "core/studies/measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/bases/basis.hpp"
#include "core/params/problem.hpp"
#include "core/runner.hpp"
#include "core/studies/local_fit.hpp"
#include "core/studies/probe_track.hpp"
#include "core/studies/sampling_times.hpp"
#include "core/studies/watchdog.hpp"
#include "core/work_weights.hpp"

namespace pf {

namespace {

double sum_of_masses(const std::vector<ParticleState>& particles) {
  double mass = 0;
  for (const ParticleState& particle : particles) mass += particle.mass;
  return mass;
}

/// Counts what a run costs.
class Meter final : public RunObserver {
 public:
  void on_state(const Simulation& simulation) override {
    const StepReport& report = simulation.report();
    if (!begun_) {
      begun_ = true;
      return;
    }
    // Looking at the state (energies, errors) is not the method's cost.
    wall += 1e-3 * (report.ms.total - report.ms.diagnostics);
    row.steps += 1;
    row.newton_iterations += static_cast<double>(report.newton.size());
    row.linear_iterations += report.linear_iterations;
    row.retries += report.retries;
    work += report.work;
  }
  /// What was counted, as columns.
  void fill(StudyRow& to, int dimension, int nodes_per_axis) const {
    const auto number = [](std::uint64_t n) { return static_cast<double>(n); };
    to.p2g = number(work.p2g), to.g2p = number(work.g2p), to.energy = number(work.energy);
    to.gradient = number(work.gradient), to.tangent = number(work.tangent), to.assembly = number(work.assembly);
    to.hessian_product = number(work.hessian_product), to.diagonal = number(work.diagonal);
    to.solver_operations = number(work.solver_operations), to.stencil_operations = number(work.stencil_operations);
    to.work = weighted_work(work, dimension, nodes_per_axis);
  }
  StudyRow row;
  Work work;
  double wall = 0;

 private:
  bool begun_ = false;
};

/// Energies and momenta against what they should be, at every state or at the times of comparison.
class Ledger {
 public:
  Ledger(const Scene& scene, const std::vector<ParticleState>& particles, const Balance& now,
         const std::optional<Balance>& should)
      : conserves_energy_(conserves_energy(scene)),
        conserves_momentum_(conserves_momentum(scene)),
        gravity_(scene.gravity),
        first_(now),
        first_should_(should),
        mass_(sum_of_masses(particles)) {
    Vec3 centre = Vec3::Zero(), v = now.momentum / mass_;
    for (const ParticleState& p : particles) centre += p.mass / mass_ * p.x;
    for (const ParticleState& p : particles) spin_ += p.mass * (p.x - centre).norm() * (p.v - v).norm();
    see(now);
  }

  /// Any state.
  void see(const Balance& now) {
    kinetic_ = std::max(kinetic_, now.kinetic);
    swing_ = std::max(swing_, std::abs(now.potential - first_.potential));
  }
  /// A state of whose energy and momentum something is known.
  void judge(const Balance& now, double time, const std::optional<Balance>& should) {
    if (should && first_should_) {
      expected_ = std::max(expected_,
                           should->kinetic + should->elastic + std::abs(should->potential - first_should_->potential));
      energy(now.total() - first_.total() - (should->total() - first_should_->total()));
      momentum(now.momentum - should->momentum);
      angular(now.angular_momentum - should->angular_momentum);
      return;
    }
    if (conserves_energy_) energy(now.total() - first_.total());
    if (!conserves_momentum_) return;
    momentum(now.momentum - first_.momentum - time * mass_ * gravity_);
    if (gravity_.isZero()) angular(now.angular_momentum - first_.angular_momentum);
  }
  bool known_at_every_state() const { return !first_should_ || conserves_energy_; }
  double at_play() const {
    const double energy = std::max(first_.kinetic + first_.elastic + swing_, expected_);
    return energy > 0 ? energy : kinetic_;
  }
  double gained() const { return at_play() > 0 ? gained_ / at_play() : not_measured; }

  void fill(StudyRow& row) const {
    row.energy_gained = gained();
    row.energy_lost = at_play() > 0 ? lost_ / at_play() : not_measured;
    row.energy_change = at_play() > 0 ? change_ / at_play() : not_measured;
    const double momentum = std::sqrt(2 * mass_ * kinetic_);
    row.momentum_drift = momentum > 0 ? drift_ / momentum : not_measured;
    row.angular_drift = spin_ > 1e-12 * momentum ? turned_ / spin_ : not_measured;
  }

 private:
  void energy(double above) {
    gained_ = std::max(std::isnan(gained_) ? 0 : gained_, above);
    lost_ = std::max(std::isnan(lost_) ? 0 : lost_, -above);
    change_ = above;
  }
  void momentum(const Vec3& off) { drift_ = std::max(std::isnan(drift_) ? 0 : drift_, off.norm()); }
  void angular(const Vec3& off) { turned_ = std::max(std::isnan(turned_) ? 0 : turned_, off.norm()); }

  bool conserves_energy_, conserves_momentum_;
  Vec3 gravity_;
  Balance first_;
  std::optional<Balance> first_should_;
  double mass_, spin_ = 0, kinetic_ = 0, swing_ = 0, expected_ = 0;
  double gained_ = not_measured, lost_ = not_measured, change_ = not_measured, drift_ = not_measured,
         turned_ = not_measured;
};

/// Errors against the reference.
class Errors {
 public:
  void add(const std::vector<ParticleState>& particles, const std::vector<Expected>& expected) {
    double mass = 0, squares[4] = {};
    for (std::size_t p = 0; p < expected.size(); ++p) {
      const ParticleState& is = particles[p];
      const Expected& should = expected[p];
      const double e[4] = {(is.x - should.x).squaredNorm(), (is.v - should.v).squaredNorm(),
                           (is.F - should.F).squaredNorm(), (is.sigma - should.sigma).squaredNorm()};
      mass += is.mass;
      for (int k = 0; k < 4; ++k) {
        squares[k] += is.mass * e[k];
        max_[k] = std::isnan(e[k]) ? e[k] : std::max(max_[k], std::sqrt(e[k]));
      }
    }
    if (expected.empty()) return;
    ++count_;
    for (int k = 0; k < 4; ++k) sum_[k] += squares[k] / mass;
  }
  void fill(StudyRow& row) const {
    if (count_ == 0) return;
    const auto l2 = [this](int k) { return std::sqrt(sum_[k] / count_); };
    row.error_l2 = l2(0), row.error_max = max_[0];
    row.error_velocity_l2 = l2(1), row.error_velocity_max = max_[1];
    row.error_F_l2 = l2(2), row.error_F_max = max_[2];
    row.error_stress_l2 = l2(3), row.error_stress_max = max_[3];
  }

 private:
  double sum_[4] = {}, max_[4] = {};
  double count_ = 0;
};

/// Noise of stress and velocity at the times of comparison.
class Noise {
 public:
  Noise(const Scene& scene, const std::vector<ParticleState>& particles)
      : dimension_(scene.dimension), spacing_(scene.grid.spacing) {
    fit(particles);
  }
  void add(const std::vector<ParticleState>& particles) {
    const bool others = !std::equal(particles.begin(), particles.end(), ids_.begin(), ids_.end(),
                                    [](const ParticleState& p, std::uint32_t id) { return p.id == id; });
    if (others) fit(particles);  // some have come, or were cut away
    std::vector<double> stress, velocity;
    for (const ParticleState& p : particles) {
      for (int k = 0; k < 9; ++k) stress.push_back(p.sigma.data()[k]);
      for (int a = 0; a < 3; ++a) velocity.push_back(p.v[a]);
    }
    const Roughness s = roughness(fits_, stress, 9, mass_), v = roughness(fits_, velocity, 3, mass_);
    ++count_;
    const double found[] = {s.noise, s.size, v.noise, v.size};
    for (int k = 0; k < 4; ++k) squares_[k] += found[k] * found[k];
  }
  void fill(StudyRow& row) const {
    if (count_ == 0) return;
    if (squares_[1] > 0) row.stress_noise = std::sqrt(squares_[0] / squares_[1]);
    if (squares_[3] > 0) row.velocity_noise = std::sqrt(squares_[2] / squares_[3]);
  }

 private:
  void fit(const std::vector<ParticleState>& particles) {
    std::vector<Vec3> X;
    std::vector<std::uint16_t> body;
    ids_.clear(), mass_.clear(), fits_.clear();
    for (const ParticleState& p : particles) {
      X.push_back(p.X);
      body.push_back(p.body);
      ids_.push_back(p.id);
      mass_.push_back(p.mass);
    }
    const LocalFit fit(dimension_, X, body, spacing_);
    for (std::size_t p = 0; p < X.size(); ++p) fits_.push_back(fit.at(X[p], body[p]));
  }

  int dimension_;
  double spacing_;
  std::vector<std::uint32_t> ids_;  ///< of the particles that the fits are for
  std::vector<FitWeights> fits_;
  std::vector<double> mass_;
  double squares_[4] = {};
  int count_ = 0;
};

/// Looks at a run as it goes; stops it when it has blown up.
class Examiner final : public RunObserver {
 public:
  Examiner(const Scene& scene, const Reference* reference, const MeasureSettings& settings, Watchdog& watchdog)
      : scene_(scene),
        reference_(reference),
        settings_(settings),
        watchdog_(watchdog),
        times_(scene.time, settings.samples) {}

  void on_state(const Simulation& simulation) override {
    const Balance& balance = simulation.report().balance;
    if (const std::vector<ProbeReading> probes = simulation.probes(); !probes.empty() && probes.front().probe == 0)
      probe_.add(simulation.time(), place_of(probes.front()));
    if (!ledger_) {
      const std::vector<ParticleState> particles = simulation.particles();
      ledger_.emplace(scene_, particles, balance,
                      reference_ != nullptr ? reference_->initial(particles) : std::nullopt);
      noise_.emplace(scene_, particles);
      return;
    }
    ledger_->see(balance);
    if (conserves_energy(scene_)) ledger_->judge(balance, simulation.time(), std::nullopt);
    if (const int k = times_.due(simulation.time()); k > 0) compare(simulation, k);
    blown_up = blown_up || ledger_->gained() > settings_.thresholds.blown_up || !std::isfinite(balance.total());
    if (blown_up) watchdog_.stop();
  }

  void fill(StudyRow& row) const {
    if (!ledger_) return;
    ledger_->fill(row);
    probe_.fill(row);
    errors_.fill(row);
    noise_->fill(row);
    // Where next to nothing of the energy is in the material there is no stress that could be noisy.
    if (!(elastic_ > nothing * ledger_->at_play())) row.stress_noise = not_measured;
  }
  bool blown_up = false;

 private:
  static constexpr double nothing = 1e-6;  ///< of the energy at play
  /// Where the point is that a probe was put at: its particle is only the nearest one.
  Vec3 place_of(const ProbeReading& reading) const {
    return reading.x + reading.F * (scene_.probes[reading.probe].at - reading.X);
  }
  void compare(const Simulation& simulation, int k) {
    const std::vector<ParticleState> particles = simulation.particles();
    noise_->add(particles);
    elastic_ = std::max(elastic_, simulation.report().balance.elastic);
    if (reference_ == nullptr) return;
    const ExpectedState should = reference_->at(k, simulation.time(), particles);
    errors_.add(particles, should.particles);
    if (should.balance) ledger_->judge(simulation.report().balance, simulation.time(), should.balance);
  }

  const Scene& scene_;
  const Reference* reference_;
  const MeasureSettings& settings_;
  Watchdog& watchdog_;
  SamplingTimes times_;
  std::optional<Ledger> ledger_;
  std::optional<Noise> noise_;
  ProbeTrack probe_;
  Errors errors_;
  double elastic_ = 0;  ///< the most at the times of comparison [J]
};

/// What the run's end says beside its numbers.
void judge_end(const RunResult& result, const Watchdog& watchdog, const Examiner& examiner,
               const MeasureSettings& settings, StudyRow& row) {
  row.behaviour = classify(row, settings.thresholds);
  if (examiner.blown_up) {
    row.status = RowStatus::unstable;
    row.behaviour = RunClass::blown_up;
    char text[100];
    std::snprintf(text, sizeof text, "stopped: its energy had grown beyond %g times the energy at play",
                  settings.thresholds.blown_up);
    row.reason = text;
  } else if (watchdog.timed_out()) {
    row.status = RowStatus::timeout;
    row.behaviour = RunClass::failed;
    row.reason = "took longer than timeout_s";
  } else if (result.end == RunEnd::failed) {
    row.status = RowStatus::failed;
    if (row.behaviour != RunClass::blown_up) row.behaviour = RunClass::failed;
    row.reason = result.last_attempt.failure;
  } else if (row.behaviour == RunClass::growing) {
    row.status = RowStatus::unstable;
    row.reason = "its energy grew";
  }
}

/// Adaptive steps land on the times of comparison; fixed ones meet them as they are.
RunLimits limits_of(const Scene& scene, const MeasureSettings& settings) {
  RunLimits limits;
  for (int k = 1; k < settings.samples && scene.time.control != "fixed"; ++k)
    limits.landings.push_back(scene.time.end * k / settings.samples);
  return limits;
}

/// Seconds of the steps of one more run; NaN where it was stopped.
double time_again(const Scene& scene, const MeasureSettings& settings, const std::atomic<bool>* cancel) {
  Watchdog watchdog(settings.timeout_s, cancel);
  const std::unique_ptr<Simulation> simulation = make_simulation(scene, {.threads = settings.threads});
  Meter meter;
  Runner runner(*simulation);
  runner.add(meter);
  return runner.run(limits_of(scene, settings), watchdog.flag()).end == RunEnd::done ? meter.wall : not_measured;
}

void fill_wall(std::vector<double> walls, StudyRow& row) {
  std::sort(walls.begin(), walls.end());
  const std::size_t middle = walls.size() / 2;
  row.wall_min = walls.front();
  row.wall_max = walls.back();
  row.wall = walls.size() % 2 == 1 ? walls[middle] : 0.5 * (walls[middle - 1] + walls[middle]);
}

}  // namespace

StudyRow measure_run(const Scene& scene, const Reference* reference, const MeasureSettings& settings,
                     const std::atomic<bool>* cancel, bool& cancelled) {
  cancelled = false;
  StudyRow refused;
  refused.status = RowStatus::failed;
  refused.behaviour = RunClass::failed;
  refused.dt = scene.time.step;
  refused.dx = scene.grid.spacing;
  try {
    Watchdog watchdog(settings.timeout_s, cancel);
    const std::unique_ptr<Simulation> simulation = make_simulation(scene, {.threads = settings.threads});
    Meter meter;
    Examiner examiner(scene, reference, settings, watchdog);
    Runner runner(*simulation);
    runner.add(meter);
    runner.add(examiner);
    const RunResult result = runner.run(limits_of(scene, settings), watchdog.flag());
    cancelled = watchdog.cancelled();
    StudyRow row = meter.row;
    row.end_time = simulation->time();
    row.dt = scene.time.step;
    row.dx = scene.grid.spacing;
    row.particles = static_cast<double>(simulation->particle_count());
    const BasisInfo* basis = find_basis(scene.grid.basis);
    meter.fill(row, scene.dimension, basis != nullptr ? basis->nodes_per_axis : 3);
    examiner.fill(row);
    judge_end(result, watchdog, examiner, settings, row);
    std::vector<double> walls{meter.wall};
    for (int k = 1; k < settings.repeat && !cancelled && result.end == RunEnd::done; ++k) {
      const double wall = time_again(scene, settings, cancel);
      if (!std::isnan(wall)) walls.push_back(wall);
      cancelled = cancel != nullptr && cancel->load();
    }
    fill_wall(walls, row);
    return row;
  } catch (const InputError& error) {
    refused.reason = error.problems().empty() ? error.what() : to_string(error.problems().front());
  } catch (const std::bad_alloc&) {
    refused.reason = "out of memory";
  }
  return refused;
}

}  // namespace pf
