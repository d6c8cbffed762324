// Lanes of a comparison on a thread of their own: the window sends commands and reads frames; neither waits.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/compare/lanes.hpp"
#include "app/pacer.hpp"
#include "app/snapshot_pool.hpp"

namespace pf::app {

struct LaneFrame {
  std::string name, failure;
  long steps = 0;
  std::shared_ptr<const Snapshot> snapshot;
  std::optional<LaneDistance> distance;  ///< from the first lane; absent where the particles are not the same
};
/// All lanes at one time; where one has failed it stands where it was.
struct ComparisonFrame {
  double time = 0, interval = 0;  ///< [s]
  std::uint64_t run = 0;          ///< ComparisonStatus::run
  long number = 0;                ///< of common times since t = 0
  bool at_end = false;            ///< no lane goes further
  std::vector<LaneFrame> lanes;
};

enum class CompareState { closed, loading, paused, running, finished };
struct ComparisonStatus {
  CompareState state = CompareState::closed;
  std::uint64_t run = 0;  ///< counts beginnings: samples of another run are stale
  double time = 0, interval = 0;
  long frame = 0;
  std::size_t lane = 0;  ///< that is being simulated
  bool catching_up = false;
  bool waits_for_reset = false;
  std::string refusal;  ///< why the lanes asked for last were not taken; "": they were
};

/// Samples since the last call, by run.
struct ComparisonNews {
  std::uint64_t run = 0;
  std::vector<LaneSample> samples;
  std::vector<LaneDistance> distances;
};

/// Thread-safe towards one UI thread.
class Comparison {
 public:
  explicit Comparison(int threads = 0, SimulationFactory factory = make_simulation);
  ~Comparison();  ///< cancels what runs and joins
  Comparison(const Comparison&) = delete;
  Comparison& operator=(const Comparison&) = delete;

  /// One lane or more; none: closes. Lanes that stay keep their state where that can be (LaneSet::change).
  void set_lanes(const Scene& base, const std::vector<LaneSpec>& lanes);
  void run();
  void pause();
  void step();  ///< to the next common time
  void reset();
  void edit(const Scene& base);
  /// Stands still for somebody else, whatever its state.
  void suspend(bool on);
  void set_rate(double simulated_per_wall);
  /// `distance`: Field::error holds the distance from the first lane.
  void request(const SnapshotRequest& what, bool distance);
  /// Called on the worker's thread whenever there is something new to show.
  void set_wake(std::function<void()> wake);

  ComparisonStatus status() const;
  std::shared_ptr<const ComparisonFrame> frame() const;
  ComparisonNews news();

 private:
  using Clock = Pacer::Clock;
  void post(std::function<void()> what, bool cancel);
  void loop();
  bool may_advance() const;
  void advance();
  void begin(bool keep_running);
  /// A frame for the window; `news`: of a time that has just been reached.
  void publish(bool news);
  /// Everything measured so far is news again: lanes have come, gone or begun anew.
  void renew();
  void tell(const std::function<void()>& what);

  mutable std::mutex mutex_;  ///< held for copies and swaps only
  std::condition_variable came_;
  std::vector<std::function<void()>> posted_;
  std::optional<Scene> edit_;
  bool quitting_ = false;
  std::atomic<bool> cancel_{false};
  ComparisonStatus status_;
  std::shared_ptr<const ComparisonFrame> frame_;
  ComparisonNews news_;
  std::function<void()> wake_;

  // The worker's own.
  LaneSet lanes_;
  CompareState state_ = CompareState::closed;
  bool suspended_ = false, single_ = false, distance_ = false;
  SnapshotRequest request_;
  SnapshotPool pool_;
  Pacer pacer_;
  double rate_ = 1;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace pf::app
