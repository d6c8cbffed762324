// Playback: when the next step is due at a given rate, and which rate is reached.
#pragma once

#include <chrono>
#include <deque>

namespace pf::app {

class Pacer {
 public:
  using Clock = std::chrono::steady_clock;
  using Moment = Clock::time_point;

  /// Simulated seconds per wall second; 0: as fast as possible. Takes effect from the state at `time`.
  void set_rate(double rate, double time, Moment now) {
    rate_ = rate;
    start(time, now);
  }
  /// Begins to run from the state at `time` [s].
  void start(double time, Moment now) {
    anchor_time_ = time;
    anchor_ = now;
    history_.clear();
    history_.push_back({time, now});
  }
  /// When the step that leaves the state at `time` shall begin. Lost time is not caught up: a slow step must not
  /// be followed by a sprint.
  Moment due(double time, Moment now) {
    if (rate_ <= 0) return now;
    const auto ahead = std::chrono::duration<double>((time - anchor_time_) / rate_);
    const Moment wanted = anchor_ + std::chrono::duration_cast<Clock::duration>(ahead);
    if (now - wanted > most_catch_up) {
      anchor_time_ = time;
      anchor_ = now;
      return now;
    }
    return wanted;
  }
  /// A state at `time` was reached.
  void reached(double time, Moment now) {
    history_.push_back({time, now});
    while (history_.size() > 2 && now - history_[1].wall > window) history_.pop_front();
  }
  /// Simulated seconds per wall second over about the last second; 0 before the first step.
  double achieved() const {
    if (history_.size() < 2) return 0;
    const double wall = std::chrono::duration<double>(history_.back().wall - history_.front().wall).count();
    return wall > 0 ? (history_.back().time - history_.front().time) / wall : 0;
  }

 private:
  static constexpr std::chrono::milliseconds most_catch_up{100};
  static constexpr std::chrono::seconds window{1};
  struct Sample {
    double time;
    Moment wall;
  };
  double rate_ = 1;
  double anchor_time_ = 0;
  Moment anchor_{};
  std::deque<Sample> history_;
};

}  // namespace pf::app
