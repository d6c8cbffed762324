// The run is being recorded: states that are due stand still until the window has their picture, or are written to
// files. Nothing of the simulation is touched by it.
#include <memory>
#include <utility>

#include "app/worker.hpp"
#include "core/output/export.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

void Session::Worker::handle(const command::Record& order) {
  filming_.reset();
  if (!order.order || !simulation_) return end_record({});
  try {
    Filming filming{*order.order, {order.order->every, simulation_->report().step, simulation_->time()}, {}};
    if (order.order->format) filming.exporter = std::make_unique<Exporter>(*order.order->format, order.order->folder);
    filming_ = std::move(filming);
  } catch (const FileError& error) {
    return end_record(error.what());
  }
  {
    const std::lock_guard lock(mutex);
    record_progress = {true, 0, {}};
  }
  film_state(false);
}

void Session::Worker::end_record(const std::string& trouble) {
  filming_.reset();
  {
    const std::lock_guard lock(mutex);
    record_progress.on = false;
    record_progress.trouble = trouble;
    frame.reset();
  }
  call_window();
}

void Session::Worker::film_state(bool last) {
  if (!filming_ || target_) return;  // on the way back through what was recorded already
  const StepReport& report = simulation_->report();
  const bool due = filming_->clock.due(report.step, simulation_->time(), report.dt);
  if (!due && !(last && report.step > filming_->newest)) return;
  filming_->newest = report.step;
  if (filming_->exporter) {
    try {
      filming_->exporter->on_frame(*simulation_, filming_->frames);
    } catch (const FileError& error) {
      return end_record(error.what());
    }
  } else {
    filming_->waiting = true;
    publish();
  }
  ++filming_->frames;
  {
    const std::lock_guard lock(mutex);
    record_progress.frames = filming_->frames;
    if (filming_->waiting) frame = newest;
  }
  call_window();
}

void Session::Worker::handle(const command::FrameTaken& taken) {
  // Not of an earlier request for other fields.
  {
    const std::lock_guard lock(mutex);
    if (frame != taken.frame) return;
    frame.reset();
  }
  if (filming_) filming_->waiting = false;
}

}  // namespace pf::app
