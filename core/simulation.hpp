// The simulation as the rest of the program sees it: no dimension, no templates.
#pragma once

#include <atomic>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/snapshot.hpp"
#include "core/step_record.hpp"
#include "core/step_report.hpp"

namespace pf {

/// The mouse holds material: particles within `radius` of `from` when it began are pulled towards `to` by a
/// spring energy in the implicit solve (core/energies/grab.hpp).
struct Grab {
  Vec3 from = Vec3::Zero();  ///< where it was taken [m]
  Vec3 to = Vec3::Zero();    ///< where the mouse is [m]
  double radius = 0;         ///< [m]
};

/// Everything about one particle, by id: the inspector and the exporters.
struct ParticleState {
  std::uint32_t id = 0;
  std::uint16_t body = 0, material = 0;
  double mass = 0, volume0 = 0;
  Vec3 X = Vec3::Zero(), x = Vec3::Zero(), v = Vec3::Zero();
  Mat3 F = Mat3::Identity(), sigma = Mat3::Zero();
  double energy_density = 0;
};

struct SimulationOptions {
  int threads = 0;     ///< 0: all hardware threads; never changes a result
  std::string file{};  ///< the scene's, for messages
};

struct Look;  // core/look.hpp
struct LookQuestion;

/// Owns particles and grid. Not thread-safe: one thread calls it; only `cancel` may be set from another.
class Simulation {
 public:
  virtual ~Simulation() = default;

  virtual const Scene& scene() const = 0;
  virtual std::size_t particle_count() const = 0;
  /// Of all particles [kg].
  virtual double mass() const = 0;
  virtual double time() const = 0;
  /// Report of the newest accepted state; of the initial one before the first step.
  virtual const StepReport& report() const = 0;

  /// One accepted step of at most `time.step` (shorter at the end, or after retries). On anything but
  /// `accepted` the particles are what they were before the call, to the byte. `finished`: t >= end.
  virtual const StepReport& step(const std::atomic<bool>* cancel = nullptr) = 0;
  /// Lets step() go on past scene().time.end.
  virtual void set_end(double end) = 0;
  /// Applies a changed scene between steps. False, and nothing done, when the change needs a reset (Setting::applies).
  /// Throws InputError when the changed conditions contradict each other; nothing is done then either.
  virtual bool apply(const Scene& scene) = 0;
  /// Whether steps fill in StepReport::energy: about one gradient a stage more. Changes no result.
  virtual void set_ledger(bool /*on*/) {}
  virtual void set_grab(const std::optional<Grab>& grab) = 0;
  /// Cuts or paints the particles within the stroke's shape, between steps; how many that were. Those that are cut away
  /// leave their ids unused. Throws InputError, and nothing is done, where none would be left, where the motion is
  /// known beforehand, or where the material is unknown.
  virtual std::size_t stroke(const Stroke& stroke);

  virtual void capture(const SnapshotRequest& request, Snapshot& into) const = 0;
  /// Of those probes whose particle is there: it may have been cut away.
  virtual std::vector<ProbeReading> probes() const = 0;
  /// All particles ordered by id. Where some were cut away ids have gaps.
  virtual std::vector<ParticleState> particles() const = 0;
  virtual ParticleState particle(std::uint32_t id) const = 0;
  /// Whether there is one of this id now.
  virtual bool has_particle(std::uint32_t id) const { return id < particle_count(); }
  /// A particle and a node looked at from inside: weights, forces, who contributes (core/look.hpp). Costs nothing while
  /// nobody asks. Here: the particle's state alone.
  virtual Look look(const LookQuestion& question) const;
  /// What is kept of the steps from now on; changes no bit of them.
  virtual void set_recording(RecordLevel /*level*/) {}
  /// Of the newest step() call, its last attempt; null where nothing was kept.
  virtual std::shared_ptr<const StepRecord> record() const { return nullptr; }
  /// The longest step that symplectic Euler could take from the present state [s]: that of the grid with the lumped
  /// mass and of the transfer (core/energies/stable_step.hpp). Costs some 20 Hessian products and a hundred averages;
  /// nothing is changed by asking.
  virtual double stable_step() const = 0;
  /// What the solver chose and why ("auto"), for the interface and summary.json.
  virtual std::string solver_choice() const = 0;

  /// The complete state, byte for byte; load refuses another scene's (InputError).
  virtual void save_state(std::ostream& out) const = 0;
  virtual void load_state(std::istream& in) = 0;
};

/// Bytes that the scene will need at its peak, estimated without building it.
double estimated_memory(const Scene& scene);
/// The only place that switches on dimension and names. Throws InputError (pointer, found, allowed), also when
/// estimated_memory exceeds the machine's.
std::unique_ptr<Simulation> make_simulation(const Scene& scene, const SimulationOptions& options = {});

}  // namespace pf
