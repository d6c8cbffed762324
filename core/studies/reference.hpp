// What a run is measured against: the exact motion, or a fine run of the same scene.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/simulation.hpp"
#include "core/studies/study.hpp"

namespace pf {

/// What a particle should be.
struct Expected {
  Vec3 x = Vec3::Zero(), v = Vec3::Zero();
  Mat3 F = Mat3::Identity(), sigma = Mat3::Zero();
};

/// The whole body at one time.
struct ExpectedState {
  std::vector<Expected> particles;  ///< one for each particle asked for; empty: nothing is known
  std::optional<Balance> balance;   ///< energies and momenta that the run should have
};

class Reference {
 public:
  virtual ~Reference() = default;
  /// What these particles should be at the k-th time of comparison (k from 1), which the run has reached at `time` [s].
  virtual ExpectedState at(int k, double time, std::span<const ParticleState> particles) const = 0;
  /// Energies and momenta at the beginning.
  virtual std::optional<Balance> initial(std::span<const ParticleState> particles) const = 0;
};

/// The motion that the scene's "exact" says.
std::unique_ptr<Reference> make_exact_reference(const Scene& scene);

/// A fine run, kept as its states at the times of comparison.
struct ReferenceRun {
  int dimension = 2;
  double spacing = 0;  ///< [m]
  Balance initial;
  std::vector<Balance> balance;                       ///< one a time
  std::vector<std::vector<ParticleState>> particles;  ///< one a time, by id
};

/// Runs the scene. Nothing when cancelled. Throws InputError where the run does not reach its end.
std::optional<ReferenceRun> run_reference(const Scene& scene, int samples, int threads, const std::atomic<bool>* cancel,
                                          const std::function<void(double)>& progress);
/// The same, from `folder` where this very program has run this scene before; kept there otherwise.
std::optional<ReferenceRun> cached_reference(const Scene& scene, int samples, int threads,
                                             const std::filesystem::path& folder, const std::atomic<bool>* cancel,
                                             const std::function<void(double)>& progress);
std::unique_ptr<Reference> make_run_reference(std::shared_ptr<const ReferenceRun> run);

/// $PUSHFORWARD_CACHE, else pushforward in $XDG_CACHE_HOME or ~/.cache.
std::filesystem::path cache_folder();

}  // namespace pf
