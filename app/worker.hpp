// The thread behind Session: what both sides share, and what only the worker touches.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <variant>

#include "app/pacer.hpp"
#include "app/recording.hpp"
#include "app/session.hpp"
#include "app/snapshot_pool.hpp"
#include "core/keyframes.hpp"
#include "core/output/export.hpp"
#include "core/runner.hpp"

namespace pf::app {

namespace command {
struct Open {
  Scene scene;
  bool run;
};
struct Run {};
struct Pause {};
struct StepOnce {};
struct Reset {};
struct GoTo {
  long step;
};
struct Branch {};
struct Ledger {
  bool on;
};
struct Recount {};
struct Memory {
  std::size_t bytes;
};
struct EditTo {
  Scene scene;
  std::uint64_t number;
};
struct Suspend {
  bool on;
};
struct Rate {
  double value;
};
struct End {
  AtEnd what;
};
struct Hold {
  std::optional<Grab> grab;
};
struct Work {
  Stroke stroke;
  std::uint64_t gesture;
};
struct TakeBack {};
struct BringBack {};
struct Look {
  SnapshotRequest request;
};
struct Ask {
  LookQuestion question;
};
struct AskState {};
struct Watch {
  RecordLevel level;
};
struct TakeApart {};
struct Record {
  std::optional<RecordOrder> order;
};
struct FrameTaken {
  std::shared_ptr<const Snapshot> frame;
};
using Any =
    std::variant<Open, Run, Pause, StepOnce, Reset, GoTo, Branch, Ledger, Recount, Memory, EditTo, Suspend, Rate, End,
                 Hold, Work, TakeBack, BringBack, Look, Ask, AskState, Watch, TakeApart, Record, FrameTaken>;
}  // namespace command

struct Session::Worker {
  Worker(int threads, SimulationFactory how);
  ~Worker();

  /// UI thread. Appends the command, or replaces the last one when both are of the same coalescing kind. Runs
  /// `acknowledge` on the status under the same lock, so that the next frame shows it.
  void send(command::Any what, bool cancel_step, const std::function<void(SessionStatus&)>& acknowledge = {});

  // Shared. The mutex is held for copies and swaps only, never during a step, a build or a capture.
  mutable std::mutex mutex;
  std::condition_variable commands_came;
  std::vector<command::Any> commands;
  std::uint64_t edits = 0;
  SessionStatus status;
  std::shared_ptr<const Snapshot> newest;
  std::vector<HistorySample> history;
  std::optional<pf::Look> answer;
  std::optional<TrialStart> asked_state;
  std::shared_ptr<const StepRecord> record;
  std::optional<ApartStep> apart;
  RecordProgress record_progress;
  std::shared_ptr<const Snapshot> frame;  ///< waits for its picture to be taken
  Recording recording;
  std::function<void()> wake;
  std::atomic<bool> cancel{false};
  bool quitting = false;

 private:
  using Clock = Pacer::Clock;

  void loop();
  /// Nothing that is thrown ends the program: the run has failed then, and the window says why.
  void guarded(const std::function<void()>& work);
  /// Waits for commands (until `until`, if given) and takes them; false: quit.
  bool take(std::vector<command::Any>& into, std::optional<Clock::time_point> until);
  /// When take() may sleep till: now while there is a step to do, nothing when only a command can help.
  std::optional<Clock::time_point> next_moment();
  void advance();
  void take_step();
  void end_step();
  void accept(const StepReport& report, double step_ms);
  void finish();
  /// The scene's own events that are due, as soon as their state is reached: edits of that state come after them,
  /// in the record too.
  void apply_events();
  void fail(const std::string& why);
  /// `announce`: show that something is loading; not where one run follows another.
  void build(const Scene& scene, bool run, bool announce = true);
  bool stepping() const { return state_ == RunState::running && !suspended_; }
  void restart_pacing() { pacer_.start(simulation_ ? simulation_->time() : 0, Clock::now()); }
  void set_state(RunState state);
  /// Captures and hands over the newest state, and wakes the window.
  void publish();
  void call_window();
  void apply_end();

  void handle(const command::Open& open) { build(open.scene, open.run); }
  void handle(const command::Run&);
  void handle(const command::Pause&);
  void handle(const command::StepOnce&);
  void handle(const command::Reset&);
  void handle(const command::GoTo& go);
  void handle(const command::Branch&);
  void handle(const command::Ledger& ledger);
  void handle(const command::Recount&);
  void handle(const command::Memory& memory);
  void handle(const command::EditTo& edit);
  void handle(const command::Suspend& suspend);
  void handle(const command::Rate& rate);
  void handle(const command::End& end);
  // worker_hand.cpp
  void handle(const command::Hold& hold);
  void handle(const command::Work& work);
  void handle(const command::TakeBack&);
  void handle(const command::BringBack&);
  /// The run begins again at the state after `step`, as recorded, and goes to `target`; what came later is forgotten.
  void begin_again(long step, long target);
  void handle(const command::Look& look);
  void handle(const command::Ask& ask);
  void handle(const command::AskState&);
  void handle(const command::Watch& watch);
  void handle(const command::TakeApart&);
  void handle(const command::Record& order);
  void handle(const command::FrameTaken& taken);
  /// Applies what differs between the scene last edited and `scene` and is live. Returns what was applied.
  std::vector<Edit> apply_live(const Scene& scene);
  bool try_apply(const std::vector<Edit>& changes);
  /// Probes are read whatever state is shown: they are no edits of the run, and the past has the newest ones, too.
  void place_probes(const std::vector<Probe>& probes);

  // worker_record.cpp: what is recorded
  struct Filming {
    RecordOrder order;
    FrameClock clock;
    std::unique_ptr<Exporter> exporter;
    long frames = 0, newest = -1;
    bool waiting = false;  ///< the state stands still until the window has its picture
  };
  bool posing() const { return filming_ && filming_->waiting; }
  /// The state at hand, if it is due; `last`: in any case.
  void film_state(bool last);
  void end_record(const std::string& trouble);

  // worker_rewind.cpp: going back to earlier states, and forward again to where the run has been
  void keep_keyframe();
  bool return_to(const Keyframe& keyframe);
  void return_to_start();
  /// From there, or from the start, on the way to `target`.
  void go_from(const Keyframe* keyframe, long target);
  void apply_recorded();
  void arrive();
  void tell_target();
  /// Something else is done to this state than was done before: what came after it is forgotten.
  void branch();

  // The worker's own.
  SimulationFactory factory_;
  SimulationOptions options_;
  std::unique_ptr<Simulation> simulation_;
  std::optional<EventSchedule> events_;
  Scene built_, edited_;
  Scene applied_;  ///< what the state at hand has had of the edits: behind `edited_` in the past
  Keyframes keyframes_;
  double end_ = 0, first_end_ = 0;               ///< when the run ends, as the simulation was told; as it was built [s]
  long reached_ = 0;                             ///< the newest state of this run
  std::optional<long> target_;                   ///< on the way to this state of it
  std::optional<command::EditTo> waiting_edit_;  ///< until the target is reached
  bool refused_ = false;  ///< a live edit could not be applied to this run: it waits for the reset
  RunState state_ = RunState::loading;
  bool suspended_ = false, ledger_ = false;
  AtEnd at_end_ = AtEnd::pause;
  Pacer pacer_;
  double rate_ = 1;
  int single_steps_ = 0;
  bool grabbed_ = false;
  SnapshotRequest request_;
  RecordLevel watch_ = RecordLevel::none;
  std::optional<Filming> filming_;
  SnapshotPool pool_;
  bool stale_ = false;  ///< the newest state was not published yet
  Clock::time_point published_{};
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace pf::app
