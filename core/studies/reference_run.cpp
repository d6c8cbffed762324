// A fine run as a reference: particles of the same reference place are compared one by one, others through a local fit.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/params/problem.hpp"
#include "core/runner.hpp"
#include "core/scene/scene_io.hpp"
#include "core/studies/local_fit.hpp"
#include "core/studies/reference.hpp"
#include "core/studies/sampling_times.hpp"

namespace pf {

namespace {

namespace fs = std::filesystem;

class Recorder final : public RunObserver {
 public:
  Recorder(const Scene& scene, int samples, const std::function<void(double)>& progress)
      : times_(scene.time, samples), progress_(progress) {
    run.dimension = scene.dimension;
    run.spacing = scene.grid.spacing;
  }
  void on_state(const Simulation& simulation) override {
    if (simulation.report().step == 0) run.initial = simulation.report().balance;
    if (times_.due(simulation.time()) > 0) {
      run.balance.push_back(simulation.report().balance);
      run.particles.push_back(simulation.particles());
    }
    if (progress_) progress_(simulation.time() / simulation.scene().time.end);
  }
  ReferenceRun run;

 private:
  SamplingTimes times_;
  const std::function<void(double)>& progress_;
};

class RunReference final : public Reference {
 public:
  explicit RunReference(std::shared_ptr<const ReferenceRun> run) : run_(std::move(run)) {
    for (const std::vector<ParticleState>& particles : run_->particles) {
      const bool others = fits_.empty() || !same(particles, run_->particles[fits_.size() - 1]);
      fits_.push_back(others ? fit_of(particles) : fits_.back());
    }
  }

  std::optional<Balance> initial(std::span<const ParticleState>) const override { return run_->initial; }

  ExpectedState at(int k, double /*time*/, std::span<const ParticleState> particles) const override {
    const auto index = static_cast<std::size_t>(k - 1);
    if (index >= run_->particles.size()) return {};
    const std::vector<ParticleState>& fine = run_->particles[index];
    ExpectedState state;
    state.balance = run_->balance[index];
    const double near = 1e-9 * run_->spacing;
    for (const ParticleState& particle : particles) {
      const auto q = std::lower_bound(fine.begin(), fine.end(), particle.id,
                                      [](const ParticleState& a, std::uint32_t id) { return a.id < id; });
      const bool same = q != fine.end() && q->id == particle.id && (q->X - particle.X).norm() < near;
      state.particles.push_back(same ? Expected{q->x, q->v, q->F, q->sigma} : fitted(*fits_[index], fine, particle));
    }
    return state;
  }

 private:
  static bool same(const std::vector<ParticleState>& a, const std::vector<ParticleState>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const ParticleState& p, const ParticleState& q) { return p.id == q.id; });
  }
  std::shared_ptr<const LocalFit> fit_of(const std::vector<ParticleState>& particles) const {
    std::vector<Vec3> X;
    std::vector<std::uint16_t> body;
    for (const ParticleState& particle : particles) {
      X.push_back(particle.X);
      body.push_back(particle.body);
    }
    return std::make_shared<LocalFit>(run_->dimension, std::move(X), std::move(body), run_->spacing);
  }
  /// Displacement rather than position: what is fitted shall be small.
  static Expected fitted(const LocalFit& fit, const std::vector<ParticleState>& fine, const ParticleState& at) {
    Expected sum{Vec3::Zero(), Vec3::Zero(), Mat3::Zero(), Mat3::Zero()};
    const FitWeights weights = fit.at(at.X, at.body);
    if (weights.empty()) sum.x.setConstant(std::nan(""));
    for (const auto& [q, weight] : weights) {
      sum.x += weight * (fine[q].x - fine[q].X);
      sum.v += weight * fine[q].v;
      sum.F += weight * fine[q].F;
      sum.sigma += weight * fine[q].sigma;
    }
    sum.x += at.X;
    return sum;
  }

  std::shared_ptr<const ReferenceRun> run_;
  std::vector<std::shared_ptr<const LocalFit>> fits_;  ///< one a time; times of the same particles share one
};

// The cache's own bytes: this program on this machine reads what it wrote, nobody else does.
template <class T>
void put(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
bool get(const std::string& bytes, std::size_t& at, T& value) {
  if (bytes.size() - at < sizeof value) return false;
  std::memcpy(static_cast<void*>(&value), bytes.data() + at, sizeof value);
  at += sizeof value;
  return true;
}

std::string to_bytes(const ReferenceRun& run) {
  std::string bytes;
  put(bytes, run.dimension);
  put(bytes, run.spacing);
  put(bytes, run.initial);
  put(bytes, run.particles.size());
  for (std::size_t k = 0; k < run.particles.size(); ++k) {
    put(bytes, run.balance[k]);
    put(bytes, run.particles[k].size());
    for (const ParticleState& particle : run.particles[k]) put(bytes, particle);
  }
  return content_hash(bytes) + bytes;
}

bool from_bytes(const std::string& text, ReferenceRun& run) {
  if (text.size() < 16 || content_hash(std::string_view(text).substr(16)) != text.substr(0, 16)) return false;
  std::size_t at = 16, times = 0, count = 0;
  if (!get(text, at, run.dimension) || !get(text, at, run.spacing) || !get(text, at, run.initial) ||
      !get(text, at, times))
    return false;
  for (std::size_t k = 0; k < times; ++k) {
    if (!get(text, at, run.balance.emplace_back()) || !get(text, at, count)) return false;
    std::vector<ParticleState>& particles = run.particles.emplace_back(count);
    for (ParticleState& particle : particles)
      if (!get(text, at, particle)) return false;
  }
  return at == text.size() && !run.particles.empty();
}

}  // namespace

std::optional<ReferenceRun> run_reference(const Scene& scene, int samples, int threads, const std::atomic<bool>* cancel,
                                          const std::function<void(double)>& progress) {
  const std::unique_ptr<Simulation> simulation = make_simulation(scene, {.threads = threads});
  Recorder recorder(scene, samples, progress);
  Runner runner(*simulation);
  runner.add(recorder);
  const RunResult result = runner.run({}, cancel);
  if (result.end == RunEnd::interrupted) return std::nullopt;
  if (result.end == RunEnd::failed)
    throw InputError("", {{"/reference", "a run that could not go on: " + result.last_attempt.failure,
                           "overrides with which the scene runs to its end", 0}});
  return std::move(recorder.run);
}

std::optional<ReferenceRun> cached_reference(const Scene& scene, int samples, int threads, const fs::path& folder,
                                             const std::atomic<bool>* cancel,
                                             const std::function<void(double)>& progress) {
  const std::string key = content_hash(to_json(scene).dump() + program_identity() + std::to_string(samples));
  const fs::path file = folder / (key + ".reference");
  std::error_code ignored;
  ReferenceRun kept;
  if (fs::exists(file, ignored) && from_bytes(read_file(file), kept)) return kept;
  std::optional<ReferenceRun> run = run_reference(scene, samples, threads, cancel, progress);
  if (!run) return run;
  make_folder(folder);
  write_atomically(file, to_bytes(*run));
  return run;
}

std::unique_ptr<Reference> make_run_reference(std::shared_ptr<const ReferenceRun> run) {
  return std::make_unique<RunReference>(std::move(run));
}

fs::path cache_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value != nullptr ? value : "");
  };
  if (const fs::path chosen = variable("PUSHFORWARD_CACHE"); !chosen.empty()) return chosen;
  if (const fs::path cache = variable("XDG_CACHE_HOME"); !cache.empty()) return cache / "pushforward";
  if (const fs::path home = variable("HOME"); !home.empty()) return home / ".cache" / "pushforward";
  return fs::temp_directory_path() / "pushforward-cache";
}

}  // namespace pf
