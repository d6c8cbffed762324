// Looking inside: the inspector's questions, and one step recorded as it is taken, to be looked at slowly.
#include <sstream>

#include "app/worker.hpp"

namespace pf::app {

void Session::Worker::handle(const command::Ask& ask) {
  if (!simulation_) return;
  pf::Look found = simulation_->look(ask.question);
  {
    const std::lock_guard lock(mutex);
    answer = std::move(found);
  }
  call_window();
}

void Session::Worker::handle(const command::AskState&) {
  if (!simulation_) return;
  TrialStart start{
      .scene = std::make_shared<const Scene>(simulation_->scene()), .state = {}, .step = simulation_->report().dt};
  std::ostringstream out;
  simulation_->save_state(out);
  start.state = std::move(out).str();
  {
    const std::lock_guard lock(mutex);
    asked_state = std::move(start);
  }
  call_window();
}

void Session::Worker::handle(const command::Watch& watch) {
  watch_ = watch.level;
  if (simulation_) simulation_->set_recording(watch_);
}

void Session::Worker::handle(const command::TakeApart&) {
  if (!simulation_ || state_ == RunState::loading || state_ == RunState::finished || suspended_ || posing()) return;
  set_state(RunState::paused);
  single_steps_ = 0;
  target_.reset();
  tell_target();
  const std::shared_ptr<Snapshot> before = pool_.take();
  simulation_->capture(request_, *before);
  simulation_->set_recording(RecordLevel::all);
  take_step();
  simulation_->set_recording(watch_);
  const std::shared_ptr<const StepRecord> made = simulation_->record();
  if (!made || !made->accepted) return;
  {
    const std::lock_guard lock(mutex);
    apart = ApartStep{before, newest, made};
  }
  call_window();
}

}  // namespace pf::app
