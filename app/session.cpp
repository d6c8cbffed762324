#include "app/session.hpp"

#include <algorithm>
#include <utility>

#include "app/worker.hpp"

namespace pf::app {

Session::Session(int threads, SimulationFactory factory)
    : worker_(std::make_unique<Worker>(threads, std::move(factory))) {}
Session::~Session() = default;

void Session::open(const Scene& scene, bool run) {
  worker_->send(command::Open{scene, run}, true, [](SessionStatus& status) { status.state = RunState::loading; });
}

void Session::run() {
  worker_->send(command::Run{}, false, [](SessionStatus& status) {
    if (status.state == RunState::paused) status.state = RunState::running;
  });
}

void Session::pause() {
  worker_->send(command::Pause{}, true, [](SessionStatus& status) {
    if (status.state == RunState::running) status.state = RunState::paused;
  });
}

void Session::step_once() {
  worker_->send(command::StepOnce{}, false);
}

void Session::reset() {
  worker_->send(command::Reset{}, true);
}

void Session::go_to(long step) {
  worker_->send(command::GoTo{step}, true, [step](SessionStatus& status) {
    if (status.state == RunState::running || status.state == RunState::finished) status.state = RunState::paused;
    if (status.state != RunState::loading) status.target = std::clamp(step, 0L, status.reached);
  });
}

void Session::branch() {
  worker_->send(command::Branch{}, false);
}

void Session::set_ledger(bool on) {
  if (std::exchange(ledger_, on) != on) worker_->send(command::Ledger{on}, false);
}

void Session::recount() {
  worker_->send(command::Recount{}, true);
}

void Session::set_rewind_memory(std::size_t bytes) {
  worker_->send(command::Memory{bytes}, false);
}

void Session::edit(const Scene& scene) {
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(worker_->mutex);
    number = ++worker_->edits;
  }
  worker_->send(command::EditTo{scene, number}, false, [number](SessionStatus& status) {
    status.edit.edit = number;
    status.edit.applies_at_step = status.step + (status.step_in_flight ? 1 : 0);
  });
}

void Session::suspend(bool on) {
  worker_->send(command::Suspend{on}, on);
}

void Session::set_rate(double simulated_per_wall) {
  worker_->send(command::Rate{simulated_per_wall}, false);
}
void Session::set_at_end(AtEnd what) {
  worker_->send(command::End{what}, false);
}
void Session::set_grab(const std::optional<Grab>& grab) {
  worker_->send(command::Hold{grab}, false);
}
void Session::stroke(const Stroke& stroke, std::uint64_t gesture) {
  worker_->send(command::Work{stroke, gesture}, false);
}
void Session::take_back_strokes() {
  worker_->send(command::TakeBack{}, true);
}
void Session::bring_back_strokes() {
  worker_->send(command::BringBack{}, true);
}
void Session::request(const SnapshotRequest& what) {
  worker_->send(command::Look{what}, false);
}
void Session::look(const LookQuestion& question) {
  worker_->send(command::Ask{question}, false);
}
void Session::ask_state() {
  worker_->send(command::AskState{}, false);
}
void Session::watch(RecordLevel level) {
  worker_->send(command::Watch{level}, false);
}
void Session::take_apart() {
  worker_->send(command::TakeApart{}, true);
}

void Session::record(const std::optional<RecordOrder>& order) {
  {
    const std::lock_guard lock(worker_->mutex);
    RecordProgress& progress = worker_->record_progress;
    progress.on = order.has_value();
    if (order) progress = {true, 0, {}};
    worker_->frame.reset();
  }
  worker_->send(command::Record{order}, false);
}
void Session::frame_taken(const std::shared_ptr<const Snapshot>& frame) {
  worker_->send(command::FrameTaken{frame}, false);
}

RecordProgress Session::record_progress() const {
  const std::lock_guard lock(worker_->mutex);
  return worker_->record_progress;
}

std::shared_ptr<const Snapshot> Session::frame_due() const {
  const std::lock_guard lock(worker_->mutex);
  return worker_->frame;
}

void Session::set_wake(std::function<void()> wake) {
  const std::lock_guard lock(worker_->mutex);
  worker_->wake = std::move(wake);
}

std::shared_ptr<const Snapshot> Session::snapshot() const {
  const std::lock_guard lock(worker_->mutex);
  return worker_->newest;
}

SessionStatus Session::status() const {
  const std::lock_guard lock(worker_->mutex);
  SessionStatus status = worker_->status;
  status.stroke_is_newest = worker_->recording.ends_in_stroke();
  status.stroke_was_taken_back = worker_->recording.can_bring_back();
  return status;
}

void Session::drain_history(std::vector<HistorySample>& into) {
  std::vector<HistorySample> fresh;
  {
    const std::lock_guard lock(worker_->mutex);
    fresh.swap(worker_->history);
  }
  into.insert(into.end(), std::make_move_iterator(fresh.begin()), std::make_move_iterator(fresh.end()));
}

Scene Session::recorded() const {
  Recording copy;
  {
    const std::lock_guard lock(worker_->mutex);
    copy = worker_->recording;
  }
  return copy.scene();
}

std::vector<double> Session::edit_times() const {
  const std::lock_guard lock(worker_->mutex);
  std::vector<double> times;
  for (const Deed& deed : worker_->recording.deeds())
    if (times.empty() || times.back() < deed.time) times.push_back(deed.time);
  return times;
}

std::string Session::recording_warning() const {
  const std::lock_guard lock(worker_->mutex);
  return worker_->recording.grabbed()
             ? "The mouse pulled at the material during this run: that cannot be recorded, so the saved scene "
               "replays the settings but not the pull."
             : std::string{};
}

std::optional<Look> Session::looked() {
  const std::lock_guard lock(worker_->mutex);
  return std::exchange(worker_->answer, std::nullopt);
}

std::optional<TrialStart> Session::asked_state() {
  const std::lock_guard lock(worker_->mutex);
  return std::exchange(worker_->asked_state, std::nullopt);
}

std::shared_ptr<const StepRecord> Session::record() const {
  const std::lock_guard lock(worker_->mutex);
  return worker_->record;
}

std::optional<ApartStep> Session::taken_apart() {
  const std::lock_guard lock(worker_->mutex);
  return std::exchange(worker_->apart, std::nullopt);
}

}  // namespace pf::app
