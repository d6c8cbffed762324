// What the Compare drawer remembers: the lanes, what is being chosen for the next one, and the curves.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/compare/comparison.hpp"
#include "app/context.hpp"
#include "app/panels/runs.hpp"

namespace pf::app {

/// Of one lane, over time.
struct LaneCurves {
  std::vector<double> time, kinetic, elastic, total, momentum;  ///< a value a state
  std::vector<double> step_time, iterations, wall_ms, dt;       ///< a value a step
  std::vector<double> distance_time, rms, max;
};

/// A lane that one click makes.
struct LaneProposal {
  std::string pointer;
  nlohmann::json value;
};

struct CompareDesk {
  explicit CompareDesk(AppContext& context);

  bool active() const { return lanes.size() > 1; }
  /// Once a frame: takes over frames and curves; resets with the run, stands still where a study is timed.
  void follow(AppContext& context);
  /// Lane `from` with one setting changed, beside the others; the first click makes the run at hand the first lane.
  /// False where it is refused; `refusal` says why.
  bool add(AppContext& context, const std::string& pointer, const nlohmann::json& value);
  void remove(AppContext& context, std::size_t lane);
  /// Back to the one run.
  void close(AppContext& context);
  /// Another scene: compares no more, forgets what was chosen.
  void forget();
  /// The scene of a lane as edited.
  static Scene scene_of(const AppContext& context, const LaneSpec& lane);
  /// "Time step 5 ms".
  static std::string name_of(const Scene& scene, const std::string& pointer, const nlohmann::json& value);
  /// Those that say something about this scene and are not there yet.
  std::vector<LaneProposal> proposals(const Scene& scene) const;

  std::vector<LaneSpec> lanes;  ///< empty or one: nothing is compared
  std::vector<LaneCurves> curves;
  ComparisonStatus status;
  std::shared_ptr<const ComparisonFrame> frame;
  bool difference = false;      ///< coloured by the distance from the first lane
  std::size_t under_mouse = 0;  ///< the lane that the view's camera and mouse are in now

  // The next lane.
  std::vector<std::string> variable;  ///< settings that can be changed
  Scene listed_for;
  std::string pointer, typed, refusal;
  std::size_t from = 0;

  std::size_t metric = 0;
  bool show_plot = false;  ///< in a narrow drawer: the plot instead of the table
  PlotView view;

  Comparison comparison;

 private:
  std::uint64_t run_ = 0, session_run_ = 0;
  bool suspended_ = false;
  SnapshotRequest requested_;
  bool requested_difference_ = false;
};

/// The desk of the context, made on the first call.
CompareDesk& compare_of(AppContext& context);
inline bool comparing(const AppContext& context) {
  return context.compare && context.compare->active();
}

}  // namespace pf::app
