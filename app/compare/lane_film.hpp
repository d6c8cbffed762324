// Leads the lanes of a comparison from one common time to the next, so that each that is due can have its picture.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "app/compare/desk.hpp"
#include "app/record/order.hpp"

namespace pf::app {

class LaneFilm {
 public:
  /// From the common time at hand, or from t = 0. `every` counts common times where it counts steps.
  LaneFilm(CompareDesk& desk, const FrameSchedule& every, bool from_start);

  /// Once a turn, after CompareDesk::follow: what is to have its picture now, null: nothing yet. Until `taken` it is
  /// the same state, though perhaps with other fields.
  std::shared_ptr<const ComparisonFrame> due(CompareDesk& desk, Field shown);
  void taken(CompareDesk& desk);
  /// The lanes have reached the end, or were closed, and all has its picture.
  bool done() const { return done_; }
  /// Waits at the next common time, or goes on.
  void toggle_pause(CompareDesk& desk);
  bool paused() const { return paused_; }

 private:
  void go_on(CompareDesk& desk);

  FrameSchedule every_;
  std::uint64_t run_;  ///< of the lanes; frames of another are not of this film
  bool any_run_;       ///< the beginning that was asked for has not been seen
  std::optional<FrameClock> clock_;
  long seen_ = -1;  ///< newest common time that was looked at
  bool waiting_ = false, last_ = false, paused_ = false, done_ = false;
};

}  // namespace pf::app
