// The worker: it alone owns the Simulation. The window sends commands and reads snapshots; neither waits.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/record/order.hpp"
#include "core/advice/advice.hpp"
#include "core/look.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/scene_io.hpp"
#include "core/simulation.hpp"
#include "core/snapshot.hpp"

namespace pf::app {

enum class RunState { loading, paused, running, finished, failed };
enum class AtEnd { pause, go_on, loop };

/// How far the newest edit has come: shown in the next frame, while the step that it waits for still runs.
struct Acknowledgement {
  std::uint64_t edit = 0;     ///< number of the newest edit accepted for application
  long applies_at_step = -1;  ///< step after which it applies; -1: nothing pending
  bool needs_reset = false;   ///< the edited scene differs in settings that only a reset applies
};

struct SessionStatus {
  RunState state = RunState::loading;
  std::uint64_t run = 0;  ///< counts opens and resets: history of another run is stale
  double time = 0;        ///< [s]
  long step = 0;
  long reached = 0;            ///< the newest step of this run; later than `step` after going back
  long target = -1;            ///< on the way to the state after this step; -1: where it is meant to be
  std::uint64_t branches = 0;  ///< counts how often a run went on otherwise than before: its history ends at `reached`
  std::size_t rewind_bytes = 0;  ///< memory that holds states to go back to
  double achieved_rate = 0;      ///< simulated seconds per wall second, smoothed
  double step_ms = 0;            ///< smoothed wall time of a step
  bool step_in_flight = false;
  bool suspended = false;  ///< stands still for somebody else, whatever its state
  Acknowledgement edit;
  bool stroke_is_newest = false;       ///< take_back_strokes() has something to take back
  bool stroke_was_taken_back = false;  ///< bring_back_strokes() has something to bring back
  std::string message;                 ///< failure or newest warning, in the user's words
  std::string solver_choice;
};

/// What the plots keep of each accepted step.
struct HistorySample {
  std::uint64_t run = 0;
  bool again = false;  ///< the same step as before: its energies are counted now, or other probes are read
  StepReport report;
  std::vector<ProbeReading> probes;
};

/// One step as it was made, to be looked at slowly.
struct ApartStep {
  std::shared_ptr<const Snapshot> before, after;  ///< with the same fields
  std::shared_ptr<const StepRecord> record;       ///< at RecordLevel::all
};

/// How the worker comes by a Simulation; make_simulation but in tests.
using SimulationFactory = std::function<std::unique_ptr<Simulation>(const Scene&, const SimulationOptions&)>;

/// Thread-safe towards one UI thread; every call returns at once (no lock is held during a step).
class Session {
 public:
  explicit Session(int threads = 0, SimulationFactory factory = make_simulation);
  ~Session();  ///< cancels the running step and joins
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Cancels the running step, builds this scene, shows its first state; runs on when `run`.
  void open(const Scene& scene, bool run);
  void run();
  void pause();  ///< cancels the running step: the state stays the last accepted one
  void step_once();
  /// To the state after `step` of this run, at most SessionStatus::reached, and pauses: what was is simulated again
  /// from the nearest state kept, with all that was edited and pulled then, to the same bytes.
  void go_to(long step);
  /// Goes on from the state at hand with the scene as edited: what came after it is forgotten. An edit does so, too.
  void branch();
  /// Memory for states to go back to; with less of it, going back takes longer.
  void set_rewind_memory(std::size_t bytes);
  void reset();  ///< rebuilds from the edited scene; keeps running if it ran
  /// The whole edited scene, checked already; coalesced to the newest, applied at the step's end where it is live,
  /// kept for the next reset where it is not. Never cancels a step.
  void edit(const Scene& scene);
  /// Stands still until called with false, for runs that are being timed: no step is taken, what is under way is
  /// cancelled, the state stays. SessionStatus::suspended says when it has come to that. From any thread.
  void suspend(bool on);
  /// Counts where energy comes from and goes to (StepReport::energy) from the next step on, or no more. To be called
  /// as often as one likes.
  void set_ledger(bool on);
  /// Simulates the run again from its start to where it has been, and counts.
  void recount();
  void set_rate(double simulated_per_wall);  ///< 1: real time; 0: as fast as possible
  void set_at_end(AtEnd what);
  void set_grab(const std::optional<Grab>& grab);
  /// Cuts or paints the material where it is now. What cannot be done is said in SessionStatus::message. Strokes of the
  /// same gesture are taken back together.
  void stroke(const Stroke& stroke, std::uint64_t gesture);
  /// Where the last thing that was done to this run is a stroke: back to the state that it was done to, paused, as if
  /// its gesture had never been. What came after it is forgotten.
  void take_back_strokes();
  /// Does the gesture again that was taken back last, at the states that it was done to, unless something else was done
  /// since; paused after its last stroke. What came after them is forgotten.
  void bring_back_strokes();
  void request(const SnapshotRequest& what);
  /// Called by the worker, on its thread, whenever there is something new to show. Set it before the first open().
  void set_wake(std::function<void()> wake);

  /// The newest state; never null after the first open() has been built.
  std::shared_ptr<const Snapshot> snapshot() const;
  SessionStatus status() const;
  /// Moves samples that came since the last call to the end of `into`.
  void drain_history(std::vector<HistorySample>& into);
  /// The initial scene with everything that was changed live as `events`: replays byte-equal with `run`.
  Scene recorded() const;
  /// Empty, or why recorded() does not replay this run: the mouse pulled at the material.
  std::string recording_warning() const;
  /// When something was edited or pulled at in this run [s].
  std::vector<double> edit_times() const;
  /// The inspector's question; answered by a later call, when the worker is between steps.
  void look(const LookQuestion& question);
  std::optional<Look> looked();
  /// Asks for the newest state, for trials that go on from it; answered by a later call of asked_state(). A pull of the
  /// mouse is no part of it.
  void ask_state();
  std::optional<TrialStart> asked_state();
  /// What is kept of each step, for record(); takes effect from the next step on.
  void watch(RecordLevel level);
  /// Of the newest accepted step; null where nothing was kept.
  std::shared_ptr<const StepRecord> record() const;
  /// Pauses, and makes one step that is recorded in full; taken_apart() has it when it was accepted.
  void take_apart();
  std::optional<ApartStep> taken_apart();
  /// Records the run from the state at hand on, until it ends, another begins or this is called without an order.
  void record(const std::optional<RecordOrder>& order);
  RecordProgress record_progress() const;
  /// A state whose picture is due: the run stands still until it is taken. Null: none is.
  std::shared_ptr<const Snapshot> frame_due() const;
  void frame_taken(const std::shared_ptr<const Snapshot>& frame);

 private:
  struct Worker;
  bool ledger_ = false;  ///< as was asked last
  std::unique_ptr<Worker> worker_;
};

}  // namespace pf::app
