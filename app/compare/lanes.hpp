// Runs of one scene that differ in named settings, kept at the same time: no thread, no window.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session.hpp"
#include "core/runner.hpp"
#include "core/scene/scene.hpp"
#include "core/simulation.hpp"

namespace pf::app {

inline constexpr std::size_t most_lanes = 4;

/// A run beside others: the scene with these settings of its own.
struct LaneSpec {
  std::string name;  ///< "Time step 5 ms"
  std::vector<Edit> edits;
};

/// What the table and the plot say of one step of a lane.
struct LaneSample {
  std::size_t lane = 0;
  double time = 0, dt = 0;                                    ///< [s]
  double kinetic = 0, elastic = 0, potential = 0, total = 0;  ///< [J]
  double momentum = 0;                                        ///< |sum m v| [kg m/s]
  int iterations = 0;                                         ///< Newton's
  double wall_ms = 0;
};

/// How far the particles of a lane are from those of the first one, by id [m].
struct LaneDistance {
  std::size_t lane = 0;
  double time = 0;          ///< [s]
  double rms = 0, max = 0;  ///< rms over the volume
};

struct Lane {
  LaneSpec spec;
  Scene scene;    ///< as edited
  Scene applied;  ///< what the simulation has had of it
  std::unique_ptr<Simulation> simulation;
  std::optional<EventSchedule> events;
  long frame = 0;       ///< the newest common time that it has reached
  std::string failure;  ///< why it stands still; "": it does not
  bool waits_for_reset = false;
  std::vector<LaneSample> history;  ///< of the initial state, where dt = 0, then of each step
  std::vector<LaneDistance> apart;  ///< one a common time, filled in by who measures it
};

/// Not thread-safe.
class LaneSet {
 public:
  explicit LaneSet(int threads = 0, SimulationFactory factory = make_simulation);

  /// Builds them all, at t = 0. Throws InputError where an edit does not fit the scene, or where the lanes together
  /// need more memory than the machine should give.
  void open(const Scene& base, const std::vector<LaneSpec>& lanes);
  /// Lanes with another scene come and go, the first one stays. Those that stay keep their state, the new ones are
  /// simulated up to them; where that cannot be (other common times, edits on the way) all begin anew.
  void change(const Scene& base, const std::vector<LaneSpec>& lanes);
  /// From t = 0 with the scenes as edited.
  void reset();
  /// The scene that all lanes share was edited: what is live applies from the time reached on, a lane's own settings
  /// stay its own. What needs a reset waits for it.
  void edit(const Scene& base);

  /// Takes the lane that is furthest behind to the next common time. False: cancelled on the way, or nothing to do.
  bool advance(const std::atomic<bool>* cancel);
  /// How far a lane is from the first one at the time reached.
  void measured(const LaneDistance& apart) { lanes_[apart.lane].apart.push_back(apart); }
  /// Whether all lanes that go on stand at the same time.
  bool level() const;
  bool finished() const;
  /// The common time that all have reached [s].
  double time() const;
  long frame() const;
  /// Between two common times [s]: a multiple of the longest time step.
  double interval() const { return interval_; }
  bool waits_for_reset() const;
  const std::vector<Lane>& lanes() const { return lanes_; }

 private:
  Lane made(const Scene& base, const LaneSpec& spec) const;
  void start(Lane& lane) const;
  /// Says in their samples which lane they are of.
  void number();
  double end() const;
  const Lane* behind() const;

  SimulationOptions options_;
  SimulationFactory factory_;
  std::vector<Lane> lanes_;
  double interval_ = 0;
  bool edited_ = false;  ///< on the way
};

/// A common time is due so often [s]: the longest of the scenes' frames, a multiple of the longest step.
double common_interval(const std::vector<Scene>& scenes);

/// Distances of the particles of `snapshot` from those of `reference` with the same id, in the order of `snapshot`;
/// empty where they are not the same particles.
std::vector<float> distances(const Snapshot& snapshot, const Snapshot& reference);
/// Over the particles' volumes.
LaneDistance summed(const Snapshot& snapshot, const std::vector<float>& distance, std::size_t lane);

}  // namespace pf::app
