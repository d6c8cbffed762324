// The curves of this run and of the pinned ones, grown step by step, and what tells the runs apart.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/context.hpp"

namespace pf::app {

inline constexpr int phase_count = 7;
/// Plain names of PhaseTimes' members, in their order ("Sort particles", ...).
extern const std::array<const char*, phase_count> phase_names;
std::array<double, phase_count> phase_values(const PhaseTimes& ms);

/// One value a report; angular momentum lost is summed from the start of the run.
struct Curves {
  std::vector<double> time, kinetic, elastic, potential, total;
  std::array<std::vector<double>, 3> momentum, angular, lost_transfer, lost_time, outside, stroked;
  std::array<std::vector<double>, phase_count> phase;
  std::vector<double> step_ms, error;
  /// Appends the reports that are new; starts again when `reports` is another run's.
  void follow(const std::vector<StepReport>& reports);
  std::size_t size() const { return time.size(); }
};

struct PinnedRun {
  nlohmann::ordered_json scene;
  Curves curves;
};

/// Zoom of one plot; unset: all of the data.
struct PlotView {
  std::optional<double> x_min, x_max, y_min, y_max;
};

struct PlotMemory {
  Curves current;
  std::vector<PinnedRun> pinned;  ///< beside AppContext::pinned, in its order
  bool kinetic = true, elastic = true, potential = true, total = true;
  bool angular = true;  ///< momentum plot: angular, else linear
  bool split_loss = true;
  PlotView view[4];
  PlotView balance_view, probe_view;
  std::size_t probe_quantity = 0;  ///< of the probes' plot
  bool relabel = false;            ///< a run was unpinned: the labels may get shorter
};

/// A label for each scene from the settings in which they differ: "PIC", "FLIP, step 5 ms". Equal ones: "same
/// settings".
std::vector<std::string> distinguishing_labels(std::span<const nlohmann::ordered_json* const> scenes);

/// At most about `limit` points that show the same curve: first, last, least and greatest of each stretch.
void thin(std::vector<double>& x, std::vector<double>& y, std::size_t limit);

}  // namespace pf::app
