#include "app/compare/lane_film.hpp"

#include <algorithm>

namespace pf::app {

namespace {

/// Frames that were made before the window asked for other fields do not have them.
bool shows(const ComparisonFrame& frame, Field field) {
  return std::all_of(frame.lanes.begin(), frame.lanes.end(), [&](const LaneFrame& lane) {
    if (!lane.snapshot) return true;
    const std::size_t values = field_info(field).on_nodes ? lane.snapshot->nodes : lane.snapshot->particles;
    return lane.snapshot->field[static_cast<std::size_t>(field)].size() == values;
  });
}

}  // namespace

LaneFilm::LaneFilm(CompareDesk& desk, const FrameSchedule& every, bool from_start)
    : every_(every), run_(desk.comparison.status().run), any_run_(!from_start) {
  desk.comparison.pause();
  if (from_start) desk.comparison.reset();
}

std::shared_ptr<const ComparisonFrame> LaneFilm::due(CompareDesk& desk, Field shown) {
  const auto frame = desk.frame;
  if (done_ || !frame) return nullptr;
  if (frame->run != run_) {
    if (clock_) {  // they began anew: that is another run
      done_ = true;
      return nullptr;
    }
    if (frame->run < run_) return nullptr;
    run_ = frame->run;
    any_run_ = true;
  }
  if (!any_run_) return nullptr;
  if (!clock_) clock_.emplace(every_, frame->number, frame->time);
  if (frame->number > seen_) {
    seen_ = frame->number;
    last_ = frame->at_end;
    waiting_ = clock_->due(frame->number, frame->time, frame->interval) || last_;
    if (!waiting_) go_on(desk);
  }
  return waiting_ && shows(*frame, shown) ? frame : nullptr;
}

void LaneFilm::taken(CompareDesk& desk) {
  waiting_ = false;
  go_on(desk);
}

void LaneFilm::toggle_pause(CompareDesk& desk) {
  paused_ = !paused_;
  if (!paused_ && !waiting_ && clock_) go_on(desk);
}

void LaneFilm::go_on(CompareDesk& desk) {
  if (last_)
    done_ = true;
  else if (!paused_)
    desk.comparison.step();
}

}  // namespace pf::app
