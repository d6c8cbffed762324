// "No more than this scene needs": what of a run's settings could be cheaper, shown by trials that go on from a state
// of it, each with something changed, and are measured against a finer one.
//
// Errors. The reference goes on with the scene's own grid and basis, a fraction of its steps, and TR-BDF2 (the scene's
// own integrator where that is explicit or quasi-static), and FLIP with a ratio of 1, whose transfers lose nothing
// however many steps there are. The error of a trial is a bound, the sum of
//   - its distance from the reference, the root mean square over the mass [m], the largest at the ends of the quarters
//     of the span (with long steps: at its end);
//   - what the reference leaves open: its distance from one with steps of double length;
//   - what the grid leaves open: the distance of two references that differ in the basis alone. Where two bases on the
//     same nodes do not agree, no time step makes either of them right. A trial with the other basis is measured from
//     the reference with that one.
// Costs are counted work (core/work_weights.hpp): no clock, the same whatever else the machine does.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation.hpp"

namespace pf {

/// A state of a run to go on from.
struct TrialStart {
  std::shared_ptr<const Scene> scene;  ///< the simulation's at that moment
  std::string state;                   ///< by Simulation::save_state
  double step = 0;                     ///< the newest one's length, where steps are adaptive [s]; 0: time.step
};

/// One way to go on, and what came of it.
struct Trial {
  std::string rule;         ///< that proposed it (core/advice/rules.hpp); "" for the settings as they are
  std::string title;        ///< "implicit midpoint, steps 4 times as long"
  std::string sentence;     ///< what to do: "Change the integrator: implicit midpoint, steps 4 times as long"
  std::vector<Edit> edits;  ///< of the scene; none: as it is
  bool came_through = false;
  std::string trouble;  ///< why not
  double error = 0;     ///< [m]; see above
  double distance = 0;  ///< from its reference alone [m]
  double work = 0;      ///< counted, of the whole span, in units of core/work_weights.hpp
  double wall_ms = 0;   ///< of the whole span [ms]
  long steps = 0;
};

struct AdviceReport {
  double time = 0;            ///< of the state at which all trials begin [s]
  double span = 0;            ///< how far they go [s]
  double grid_open = 0;       ///< what the grid leaves open [m]
  double reference_open = 0;  ///< what the reference leaves open [m]
  std::string other_basis;    ///< that the grid was judged by; "": none came through
  double resting = 0;         ///< share of the cells in which nothing moves, 0 to 1
  std::vector<Trial> trials;  ///< the first one: as it is
  std::vector<std::size_t>
      advice;            ///< trials worth doing: cheaper and as exact, or as cheap and more exact; best first
  std::string why_none;  ///< nothing could be judged; "": it could
};

struct AdviceOptions {
  int threads = 1;          ///< of one trial
  double allowed = 1.2;     ///< as exact: an error of at most this times the error as it is
  double worthwhile = 0.9;  ///< cheaper: at most this times the work as it is
};

/// Makes the trials and judges them. Nothing when cancelled. `progress` is told the share done, 0 to 1. Throws
/// InputError where the state is not one of the scene.
std::optional<AdviceReport> advise(const TrialStart& start, const AdviceOptions& options = {},
                                   const std::atomic<bool>* cancel = nullptr,
                                   const std::function<void(double)>& progress = {});

/// The scene's own values of what the edits change: takes them back.
std::vector<Edit> inverse(const Scene& scene, const std::vector<Edit>& edits);

}  // namespace pf
