// Going back: from the nearest keyframe, or from the start, forward again with all that was done on the way.
#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

#include "app/worker.hpp"
#include "core/live_edit.hpp"

namespace pf::app {

void Session::Worker::keep_keyframe() {
  const long step = simulation_->report().step;
  // What the mouse holds was chosen at an earlier state, and is no part of this one's bytes.
  if (grabbed_ || !keyframes_.wants(step)) return;
  Keyframe keyframe{.step = step, .events = events_->applied(), .end = end_};
  std::ostringstream out;
  simulation_->save_state(out);
  keyframe.state = std::move(out).str();
  // Scenes change rarely: as a rule all keyframes share them.
  const auto shared = [&](const Scene& scene, std::shared_ptr<const Scene> Keyframe::*which) {
    const auto& all = keyframes_.all();
    if (!all.empty() && *(all.back().*which) == scene) return all.back().*which;
    return std::make_shared<const Scene>(scene);
  };
  keyframe.scene = shared(simulation_->scene(), &Keyframe::scene);
  keyframe.edited = shared(applied_, &Keyframe::edited);
  keyframes_.add(std::move(keyframe));
  const std::lock_guard lock(mutex);
  status.rewind_bytes = keyframes_.bytes();
}

bool Session::Worker::return_to(const Keyframe& keyframe) {
  simulation_->set_grab(std::nullopt);
  grabbed_ = false;
  try {
    // A body that entered since then does not leave: without it the simulation is built anew.
    if (!simulation_->apply(*keyframe.scene)) {
      return_to_start();
      if (!simulation_->apply(*keyframe.scene)) return false;
    }
    std::istringstream in(keyframe.state);
    simulation_->load_state(in);
  } catch (const InputError&) {
    return false;
  }
  applied_ = *keyframe.edited;
  place_probes(edited_.probes);
  events_.emplace(built_, keyframe.events);
  simulation_->set_end(end_ = keyframe.end);
  return true;
}

void Session::Worker::return_to_start() {
  grabbed_ = false;
  simulation_.reset();
  simulation_ = factory_(built_, options_);
  simulation_->set_recording(watch_);
  simulation_->set_ledger(ledger_);
  applied_ = built_;  // with the newest probes
  events_.emplace(built_);
  simulation_->set_end(end_ = first_end_);
}

void Session::Worker::apply_recorded() {
  const long step = simulation_->report().step;
  const std::vector<Deed>& deeds = recording.deeds();  // only this thread changes them
  auto deed = std::partition_point(deeds.begin(), deeds.end(), [&](const Deed& d) { return d.step < step; });
  for (; deed != deeds.end() && deed->step == step; ++deed) {
    if (deed->end) {
      simulation_->set_end(end_ = *deed->end);
      continue;
    }
    if (deed->hold) {
      grabbed_ = deed->grab.has_value();
      simulation_->set_grab(deed->grab);
      continue;
    }
    if (deed->stroke) {
      simulation_->stroke(*deed->stroke);
      continue;
    }
    applied_ = edited(applied_, deed->edits);
    simulation_->apply(edited_live(simulation_->scene(), deed->edits));
    simulation_->set_end(end_);
  }
  if (step >= reached_) apply_end();
}

void Session::Worker::apply_end() {
  const double end = at_end_ == AtEnd::go_on ? std::numeric_limits<double>::infinity() : applied_.time.end;
  simulation_->set_end(end);
  if (end == std::exchange(end_, end)) return;
  const std::lock_guard lock(mutex);
  recording.add_end(simulation_->report().step, simulation_->time(), end);
}

void Session::Worker::tell_target() {
  const std::lock_guard lock(mutex);
  const bool newer = std::any_of(commands.begin(), commands.end(),
                                 [](const command::Any& c) { return std::holds_alternative<command::GoTo>(c); });
  if (!newer) status.target = target_.value_or(-1);
}

void Session::Worker::arrive() {
  if (!target_ || simulation_->report().step < *target_) return;
  target_.reset();
  publish();  // first the picture, then the word that it is there
  tell_target();
  restart_pacing();
  if (waiting_edit_) handle(*std::exchange(waiting_edit_, std::nullopt));
}

void Session::Worker::branch() {
  if (!simulation_) return;
  const long step = simulation_->report().step;
  if (step >= reached_) return;
  reached_ = step;
  keyframes_.forget_after(step);
  const std::lock_guard lock(mutex);
  recording.forget_after(step);
  status.reached = step;
  status.rewind_bytes = keyframes_.bytes();
  ++status.branches;
}

void Session::Worker::handle(const command::GoTo& go) {
  if (state_ == RunState::loading || (!simulation_ && reached_ == 0)) return tell_target();
  single_steps_ = 0;
  target_ = std::clamp(go.step, 0L, reached_);
  // A failed or finished run stands at its end; elsewhere it may go on.
  set_state(RunState::paused);
  const long now = simulation_ ? simulation_->report().step : -1;
  const Keyframe* nearest = keyframes_.before(*target_);
  const bool back = *target_ < now || now < 0, shortcut = nearest && nearest->step > now;
  if (back || shortcut) return go_from(nearest, *target_);
  tell_target();
  arrive();
}

void Session::Worker::go_from(const Keyframe* keyframe, long target) {
  target_ = target;
  single_steps_ = 0;
  if (!simulation_ || !keyframe || !return_to(*keyframe)) return_to_start();
  apply_events();
  apply_recorded();
  {
    const std::lock_guard lock(mutex);
    status.step = simulation_->report().step;
    status.time = simulation_->time();
  }
  stale_ = true;
  tell_target();
  arrive();
}

void Session::Worker::handle(const command::Branch&) {
  if (!simulation_ || state_ == RunState::loading) return;
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex);
    number = edits;
  }
  target_.reset();
  tell_target();
  branch();
  handle(command::EditTo{edited_, number});
}

void Session::Worker::handle(const command::Ledger& ledger) {
  ledger_ = ledger.on;
  if (simulation_) simulation_->set_ledger(ledger_);
}

void Session::Worker::handle(const command::Recount&) {
  if (!simulation_ || state_ == RunState::loading || reached_ == 0) return;
  set_state(RunState::paused);
  go_from(nullptr, reached_);
}

void Session::Worker::handle(const command::Memory& memory) {
  keyframes_.set_budget(memory.bytes);
  const std::lock_guard lock(mutex);
  status.rewind_bytes = keyframes_.bytes();
}

}  // namespace pf::app
