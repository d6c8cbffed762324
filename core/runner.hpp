// Runs a simulation from where it is to its end: events, frames and limits, and who is told what. Shared by the
// command line, the lab and the tests, so that all of them run a scene the same way.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation.hpp"

namespace pf {

/// How far a run has come besides the simulation's own state: what a checkpoint keeps of it.
struct RunCursor {
  long frames = 0;         ///< frames that were due so far; the next one has this number
  long next_due = 0;       ///< k of the next frame: due when t >= k time.frame
  std::size_t events = 0;  ///< events applied so far, in order of their times
};

enum class RunEnd { done, interrupted, failed };

struct RunResult {
  RunEnd end = RunEnd::done;
  StepReport last_attempt;  ///< of the step that failed or was interrupted, else of the last accepted one
  RunCursor cursor;
};

/// Is told about a run. Calls come in the order of the members. Whatever an observer throws ends the run.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  /// The state at the run's beginning, and the state after every accepted step.
  virtual void on_state(const Simulation& /*simulation*/) {}
  /// A picture or an export of this state is due. Numbers have no gaps. The last state is always shown: where it
  /// was not due, its number is that of the next due frame of a run that would go on.
  virtual void on_frame(const Simulation& /*simulation*/, long /*number*/) {}
  /// Every observer has seen the state; the run can be continued from here.
  virtual void on_settled(const Simulation& /*simulation*/, const RunCursor& /*cursor*/) {}
  /// The run is over, for whatever reason.
  virtual void on_end(const Simulation& /*simulation*/, const RunResult& /*result*/) {}
};

/// The events of a scene, applied when they are due (INTERFACE, "events": at the first step at or after `time`).
class EventSchedule {
 public:
  /// `applied` events, in order of time, are taken for done.
  explicit EventSchedule(const Scene& scene, std::size_t applied = 0);
  /// Applies what is due at the simulation's time; returns how many that were. Throws InputError where an edit is
  /// invalid or needs a reset.
  std::size_t apply_due(Simulation& simulation);
  std::size_t applied() const { return applied_; }
  /// Applies the first `count` events whatever the time, but for their strokes: before a later state is loaded, which
  /// has what they left of the particles.
  void apply_first(Simulation& simulation, std::size_t count);

 private:
  struct Entry {
    std::size_t index;  ///< in Scene::events
    Event event;
  };
  void apply_next(Simulation& simulation, bool strokes);

  std::vector<Entry> entries_;  ///< by time; those of one time in file order
  std::size_t applied_ = 0;
};

/// Is frame k due at `time`? (INTERFACE fine print 2.)
bool frame_due(const TimeSettings& settings, double time, long k);
/// After frame k was shown at `time`: the next one that is not due yet. A step longer than several intervals is one
/// frame.
long next_frame(const TimeSettings& settings, double time, long k);

struct RunLimits {
  std::optional<long> steps;  ///< stop after this many more accepted steps
  /// Times before the end on which a step shall end, too, in order: where a study looks at adaptive runs.
  std::vector<double> landings = {};
};

class Runner {
 public:
  /// The simulation stands at the run's first state, or at the one that `cursor` belongs to.
  explicit Runner(Simulation& simulation, const RunCursor& cursor = {});
  /// Not owned; told in the order in which they were added.
  void add(RunObserver& observer) { observers_.push_back(&observer); }
  /// Steps until time.end, the limit, a failure, or until `cancel` is set.
  RunResult run(const RunLimits& limits = {}, const std::atomic<bool>* cancel = nullptr);

 private:
  void show_state();
  RunResult finish(RunEnd end, const StepReport& last_attempt);

  Simulation& simulation_;
  RunCursor cursor_;
  EventSchedule events_;
  std::vector<RunObserver*> observers_;
  bool shown_ = false;  ///< the newest state was a frame
};

}  // namespace pf
