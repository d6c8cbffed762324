// What a hand does to the material of the running simulation: it holds it, cuts it, paints it, reads it by probes.
#include "app/worker.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

void Session::Worker::handle(const command::Hold& hold) {
  if (!simulation_ || (!hold.grab && !grabbed_)) return;
  target_.reset();  // what is held is what is seen
  branch();
  {
    const std::lock_guard lock(mutex);
    recording.add_grab(simulation_->report().step, simulation_->time(), hold.grab);
  }
  grabbed_ = hold.grab.has_value();
  simulation_->set_grab(hold.grab);
  if (state_ != RunState::running) publish();
}

void Session::Worker::handle(const command::Work& work) {
  if (!simulation_) return;
  std::string refused;
  try {
    if (simulation_->stroke(work.stroke) == 0) return;
  } catch (const InputError& error) {
    const Problem& problem = error.problems().front();
    refused = "This was not done: " + problem.found + ". Allowed: " + problem.allowed + ".";
  }
  if (refused.empty()) {
    target_.reset();  // what is cut is what is seen
    tell_target();
    branch();
  }
  {
    const std::lock_guard lock(mutex);
    if (refused.empty())
      recording.add_stroke(simulation_->report().step, simulation_->time(), work.stroke, work.gesture);
    else
      status.message = refused;
  }
  if (refused.empty() && state_ == RunState::failed) set_state(RunState::paused);
  stale_ = true;
  if (state_ != RunState::running) publish();
}

void Session::Worker::handle(const command::TakeBack&) {
  if (!simulation_ || state_ == RunState::loading) return;
  std::optional<Deed> first;
  {
    const std::lock_guard lock(mutex);
    first = recording.take_back_strokes();
  }
  // Back to the state that they were done to, and on from there as if they had never been.
  if (first) begin_again(first->step, first->step);
}

void Session::Worker::handle(const command::BringBack&) {
  if (!simulation_ || state_ == RunState::loading) return;
  std::optional<std::pair<long, long>> steps;
  {
    const std::lock_guard lock(mutex);
    steps = recording.bring_back_strokes();
  }
  // A drag may have gone on over several steps.
  if (steps) begin_again(steps->first, steps->second);
}

void Session::Worker::begin_again(long step, long target) {
  keyframes_.forget_after(step);
  {
    const std::lock_guard lock(mutex);
    if (step < reached_) ++status.branches;
    status.reached = reached_ = step;
    status.rewind_bytes = keyframes_.bytes();
  }
  set_state(RunState::paused);
  go_from(keyframes_.before(step), target);
}

void Session::Worker::place_probes(const std::vector<Probe>& probes) {
  built_.probes = edited_.probes = applied_.probes = probes;
  if (!simulation_) return;
  Scene scene = simulation_->scene();
  if (scene.probes == probes) return;
  scene.probes = probes;
  simulation_->apply(scene);
  const std::lock_guard lock(mutex);
  recording.set_probes(probes);
  history.push_back({status.run, true, simulation_->report(), simulation_->probes()});
}

}  // namespace pf::app
