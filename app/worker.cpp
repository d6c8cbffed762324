#include "app/worker.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/live_edit.hpp"

namespace pf::app {
namespace {

/// Shortest time between two published snapshots while running: display rate.
constexpr std::chrono::microseconds frame_time{16'600};

/// Only the newest of these counts.
template <typename T>
constexpr bool coalesces =
    std::is_same_v<T, command::EditTo> || std::is_same_v<T, command::Rate> || std::is_same_v<T, command::Hold> ||
    std::is_same_v<T, command::Look> || std::is_same_v<T, command::Ask> || std::is_same_v<T, command::Watch> ||
    std::is_same_v<T, command::GoTo>;

double milliseconds(Pacer::Clock::duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

}  // namespace

Session::Worker::Worker(int threads, SimulationFactory how) : factory_(std::move(how)) {
  options_.threads = threads;
  thread_ = std::jthread([this] { loop(); });
}

Session::Worker::~Worker() {
  {
    const std::lock_guard lock(mutex);
    quitting = true;
    cancel = true;
  }
  commands_came.notify_one();
  thread_.join();
}

void Session::Worker::send(command::Any what, bool cancel_step,
                           const std::function<void(SessionStatus&)>& acknowledge) {
  {
    const std::lock_guard lock(mutex);
    // Not across a build: an edit of the old scene must not slip behind the opening of the next.
    const auto barrier = std::find_if(commands.rbegin(), commands.rend(), [](const command::Any& c) {
      return std::holds_alternative<command::Open>(c) || std::holds_alternative<command::Reset>(c);
    });
    const bool coalescing = std::visit([](const auto& c) { return coalesces<std::decay_t<decltype(c)>>; }, what);
    const auto same = std::find_if(commands.rbegin(), barrier,
                                   [&](const command::Any& c) { return coalescing && c.index() == what.index(); });
    if (same != barrier)
      *same = std::move(what);
    else
      commands.push_back(std::move(what));
    if (cancel_step) cancel = true;
    if (acknowledge) acknowledge(status);
  }
  commands_came.notify_one();
}

void Session::Worker::loop() {
  std::vector<command::Any> taken;
  while (take(taken, next_moment())) {
    for (const command::Any& what : taken) guarded([&] { std::visit([this](const auto& c) { handle(c); }, what); });
    taken.clear();
    guarded([this] { advance(); });
  }
}

void Session::Worker::guarded(const std::function<void()>& work) {
  std::string what;
  try {
    return work();
  } catch (const std::exception& error) {
    what = error.what();
  } catch (...) {
    what = "an exception of unknown kind";
  }
  simulation_.reset();  // whatever was interrupted leaves nothing to rely on
  fail("The simulation stopped: " + what + ". Reset (R) begins anew.");
}

bool Session::Worker::take(std::vector<command::Any>& into, std::optional<Clock::time_point> until) {
  std::unique_lock lock(mutex);
  const auto something = [this] { return quitting || !commands.empty(); };
  if (until)
    commands_came.wait_until(lock, *until, something);
  else
    commands_came.wait(lock, something);
  if (quitting) return false;
  std::swap(into, commands);
  cancel = false;  // whoever asked for it sent a command, which is being taken now
  return true;
}

std::optional<Session::Worker::Clock::time_point> Session::Worker::next_moment() {
  const auto now = Clock::now();
  if (posing()) return stale_ ? std::optional(now) : std::nullopt;
  if (single_steps_ > 0 || (target_ && !suspended_)) return now;
  if (!stepping()) return std::nullopt;
  const auto due = pacer_.due(simulation_->time(), now);
  return stale_ ? std::min(due, published_ + frame_time) : due;
}

void Session::Worker::advance() {
  const auto now = Clock::now();
  if (stale_ && (posing() || (!stepping() && !target_) || now >= published_ + frame_time)) publish();
  if (posing()) return;
  if (single_steps_ > 0 || (target_ && !suspended_) || (stepping() && now >= pacer_.due(simulation_->time(), now)))
    take_step();
}

void Session::Worker::take_step() {
  {
    const std::lock_guard lock(mutex);
    status.step_in_flight = true;
  }
  const auto begin = Clock::now();
  try {
    const StepReport& report = simulation_->step(&cancel);
    const double ms = milliseconds(Clock::now() - begin);
    if (report.status == StepStatus::accepted) {
      accept(report, ms);
      apply_events();
      apply_recorded();
      film_state(false);
      arrive();
    }
    if (report.status == StepStatus::failed) fail(report.failure);
    if (report.status == StepStatus::finished) finish();
  } catch (...) {
    end_step();
    throw;
  }
  single_steps_ = std::max(0, single_steps_ - 1);
  end_step();
}

void Session::Worker::end_step() {
  const std::lock_guard lock(mutex);
  status.step_in_flight = false;
}

void Session::Worker::accept(const StepReport& report, double step_ms) {
  const auto now = Clock::now();
  pacer_.reached(report.time, now);
  stale_ = true;
  const std::vector<ProbeReading> readings = simulation_->probes();
  {
    const std::lock_guard lock(mutex);
    status.time = report.time;
    status.step = report.step;
    status.achieved_rate = state_ == RunState::running ? pacer_.achieved() : 0;
    status.step_ms = status.step_ms > 0 ? 0.8 * status.step_ms + 0.2 * step_ms : step_ms;
    if (!report.warnings.empty()) status.message = report.warnings.back();
    if (report.step > reached_) {
      history.push_back({status.run, false, report, readings});
      status.reached = reached_ = report.step;
    } else if (report.energy.known || !readings.empty()) {
      history.push_back({status.run, true, report, readings});
    }
    record = simulation_->record();
  }
  keep_keyframe();
  if ((state_ != RunState::running && !target_) || now >= published_ + frame_time) publish();
}

void Session::Worker::apply_events() {
  if (events_->apply_due(*simulation_) > 0) simulation_->set_end(end_);
}

void Session::Worker::finish() {
  target_.reset();
  film_state(true);
  if (at_end_ == AtEnd::loop && state_ == RunState::running && !filming_) return build(edited_, true, false);
  if (stale_) publish();
  set_state(RunState::finished);
}

void Session::Worker::fail(const std::string& why) {
  single_steps_ = 0;
  target_.reset();
  if (simulation_) {
    film_state(true);
    publish();
  }
  {
    const std::lock_guard lock(mutex);
    status.message = why;
  }
  set_state(RunState::failed);
}

void Session::Worker::build(const Scene& scene, bool run, bool announce) {
  if (announce) set_state(RunState::loading);
  single_steps_ = 0;
  grabbed_ = refused_ = false;
  built_ = edited_ = applied_ = scene;
  keyframes_.clear();
  if (filming_) end_record({});
  reached_ = 0;
  target_.reset();
  waiting_edit_.reset();
  simulation_.reset();  // first: two large scenes need not fit side by side
  std::string failure;
  try {
    simulation_ = factory_(scene, options_);
    simulation_->set_recording(watch_);
    simulation_->set_ledger(ledger_);
    events_.emplace(scene);
    end_ = first_end_ = at_end_ == AtEnd::go_on ? std::numeric_limits<double>::infinity() : scene.time.end;
    simulation_->set_end(end_);
    keep_keyframe();
    apply_events();
  } catch (const std::exception& error) {
    simulation_.reset();
    failure = error.what();
  }
  // First the picture, then the word that it is there.
  if (simulation_) publish();
  {
    const std::lock_guard lock(mutex);
    SessionStatus fresh;
    fresh.state = state_;
    fresh.suspended = suspended_;
    fresh.run = status.run + 1;
    fresh.edit = status.edit;
    fresh.edit.needs_reset = false;
    status = fresh;
    recording.begin(scene);
    record.reset();
    apart.reset();
    if (simulation_) {
      status.time = simulation_->time();
      status.solver_choice = simulation_->solver_choice();
      history.push_back({status.run, false, simulation_->report(), simulation_->probes()});
    }
  }
  if (!simulation_) return fail(failure);
  set_state(run ? RunState::running : RunState::paused);
  pacer_.set_rate(rate_, simulation_->time(), Clock::now());
}

void Session::Worker::set_state(RunState state) {
  state_ = state;
  {
    const std::lock_guard lock(mutex);
    status.state = state;
    if (state != RunState::running) status.achieved_rate = 0;
  }
  call_window();
}

void Session::Worker::publish() {
  stale_ = false;
  if (!simulation_) return;  // a step that threw took it along: the last picture stays
  std::shared_ptr<Snapshot> snapshot = pool_.take();
  simulation_->capture(request_, *snapshot);
  std::shared_ptr<const Snapshot> fresh = std::move(snapshot);
  std::string choice = simulation_->solver_choice();
  {
    const std::lock_guard lock(mutex);
    if (frame && frame->report.step == newest->report.step) frame = fresh;  // the same state, seen otherwise
    newest.swap(fresh);
    status.solver_choice.swap(choice);
  }
  published_ = Clock::now();
  call_window();
}

void Session::Worker::call_window() {
  std::function<void()> call;
  {
    const std::lock_guard lock(mutex);
    call = wake;
  }
  if (call) call();
}

void Session::Worker::handle(const command::Run&) {
  if (state_ == RunState::finished && at_end_ != AtEnd::go_on) return build(edited_, true, false);  // play again
  if (!simulation_ || state_ == RunState::loading) return;
  restart_pacing();
  set_state(RunState::running);
}

void Session::Worker::handle(const command::Pause&) {
  single_steps_ = 0;
  if (stale_) publish();
  set_state(state_ == RunState::running ? RunState::paused : state_);
}

void Session::Worker::handle(const command::StepOnce&) {
  target_.reset();
  if (!simulation_ || state_ == RunState::loading || state_ == RunState::finished || suspended_) return;
  set_state(RunState::paused);
  ++single_steps_;
}

void Session::Worker::handle(const command::Reset&) {
  const Scene scene = edited_;
  build(scene, state_ == RunState::running);
}

void Session::Worker::handle(const command::EditTo& edit) {
  if (target_) {  // the edit is one of the state that was asked for
    waiting_edit_ = edit;
    return;
  }
  place_probes(edit.scene.probes);
  const std::vector<Edit> applied = apply_live(edit.scene);
  if (!applied.empty()) branch();
  const bool needs_reset = refused_ || !only(difference(built_, edited_), Applies::reset).empty();
  {
    const std::lock_guard lock(mutex);
    if (simulation_) recording.add(simulation_->report().step, simulation_->time(), applied);
    status.edit.needs_reset = needs_reset;
    if (status.edit.edit == edit.number) status.edit.applies_at_step = -1;
  }
  // A changed setting may be what the failed or finished run was waiting for.
  const bool longer = state_ == RunState::finished && simulation_ && simulation_->time() < edited_.time.end;
  if (simulation_ && (state_ == RunState::failed || longer)) set_state(RunState::paused);
  if (simulation_ && state_ != RunState::running) publish();
  call_window();
}

std::vector<Edit> Session::Worker::apply_live(const Scene& scene) {
  // Against what was edited last, not against the simulation's scene: that one has the scene's own events in it.
  std::vector<Edit> changes = only(difference(applied_, scene), Applies::live);
  edited_ = scene;
  if (!simulation_ || changes.empty()) return {};
  applied_ = edited(applied_, changes);
  if (!try_apply(changes)) {
    refused_ = true;
    return {};
  }
  apply_end();
  return changes;
}

bool Session::Worker::try_apply(const std::vector<Edit>& changes) {
  // Where a list was replaced and waits for the reset, its indices mean something else to the running simulation.
  for (const Edit& waiting : only(difference(built_, edited_), Applies::reset))
    for (const Edit& change : changes)
      if (change.pointer.starts_with(waiting.pointer + "/")) return false;
  try {
    return simulation_->apply(edited_live(simulation_->scene(), changes));
  } catch (const InputError&) {
    return false;  // does not fit what the run's own events made of the scene
  }
}

void Session::Worker::handle(const command::Suspend& suspend) {
  suspended_ = suspend.on;
  single_steps_ = 0;
  restart_pacing();
  {
    const std::lock_guard lock(mutex);
    status.suspended = suspend.on;
    status.achieved_rate = 0;
  }
  call_window();
}

void Session::Worker::handle(const command::Rate& rate) {
  rate_ = rate.value;
  pacer_.set_rate(rate_, simulation_ ? simulation_->time() : 0, Clock::now());
}

void Session::Worker::handle(const command::End& end) {
  at_end_ = end.what;
  if (!simulation_) return;
  if (simulation_->report().step >= reached_) apply_end();  // else where the run goes on from
  if (at_end_ == AtEnd::go_on && state_ == RunState::finished) set_state(RunState::paused);
}

void Session::Worker::handle(const command::Look& look) {
  request_ = look.request;
  if (simulation_) stale_ = true;  // the same state, seen otherwise
}

}  // namespace pf::app
