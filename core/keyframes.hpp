// Moments of a run from which it can be simulated again, exactly, spread over all of it within a budget of memory.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace pf {

/// The complete state after a step, before anything was done to it there.
struct Keyframe {
  long step = 0;
  std::string state = {};                         ///< by Simulation::save_state
  std::shared_ptr<const Scene> scene = nullptr;   ///< the simulation's at that moment
  std::shared_ptr<const Scene> edited = nullptr;  ///< the scene as it had been edited until then, without its events
  std::size_t events = 0;                         ///< of the scene's own that had been applied
  double end = 0;                                 ///< when the run was to end [s]
};

/// Keyframes at multiples of an interval. Where memory gets short every other one is given up and the interval doubles,
/// so that no part of a run is further than an interval from a keyframe, however long it gets.
class Keyframes {
 public:
  static constexpr std::size_t default_budget = std::size_t{512} << 20;
  static constexpr std::size_t most = 512;  ///< keyframes, however small they are

  /// `budget`: bytes of the states kept, at most. 0 keeps none.
  explicit Keyframes(std::size_t budget = default_budget) : budget_(budget) {}
  /// Gives up what is too much now.
  void set_budget(std::size_t bytes);
  std::size_t budget() const { return budget_; }

  void clear();
  /// Whether the state after `step`, which comes after all that are kept, should be added.
  bool wants(long step) const;
  /// Keeps it, or gives it up where even thinning leaves no room. `keyframe.step` comes after all that are kept.
  void add(Keyframe keyframe);
  /// The newest one before `step`; for step 0 the one of step 0. nullptr: there is none.
  const Keyframe* before(long step) const;
  /// Another run begins there: forgets those after `step`.
  void forget_after(long step);

  const std::vector<Keyframe>& all() const { return kept_; }
  std::size_t bytes() const { return bytes_; }
  long interval() const { return interval_; }

 private:
  void thin();

  std::vector<Keyframe> kept_;  ///< by ascending step
  std::size_t budget_, bytes_ = 0;
  static constexpr long first_interval = 4;
  long interval_ = first_interval;
};

}  // namespace pf
