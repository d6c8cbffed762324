// When a run is compared: at the first step that reaches each of some evenly spaced times, the last one the end.
#pragma once

#include "core/scene/scene.hpp"

namespace pf {

class SamplingTimes {
 public:
  SamplingTimes(const TimeSettings& time, int count) : time_(time), count_(count) {}
  /// The number (from 1) of the newest time of comparison that `time` has reached and that was not due before; 0 where
  /// there is none. A step over several of them counts for the last.
  int due(double time) {
    int reached = 0;
    while (next_ <= count_ && time >= time_.end * next_ / count_ - 1e-9 * time_.step) reached = next_++;
    return reached;
  }

 private:
  TimeSettings time_;
  int count_, next_ = 1;
};

}  // namespace pf
