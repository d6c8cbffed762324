// Where the time of each step goes: phases stacked on one another.
#include <imgui.h>

#include <algorithm>
#include <numeric>

#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/panels/series.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/run_list.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

/// Mean of the last steps: single ones flicker too much to be read.
double recent_mean(const std::vector<double>& values) {
  const std::size_t n = std::min<std::size_t>(values.size(), 20);
  if (n == 0) return 0;
  return std::accumulate(values.end() - static_cast<std::ptrdiff_t>(n), values.end(), 0.0) / static_cast<double>(n);
}

void list_phases(const AppContext& context, const Curves& c) {
  double sum = 0;
  for (const auto& values : c.phase) sum += recent_mean(values);
  for (std::size_t i = c.phase.size(); i-- > 0;) {
    const double mean = recent_mean(c.phase[i]);
    const std::string share = sum > 0 ? "  " + quantity(100 * mean / sum, "", 2) + " %" : "";
    legend_entry(context, i, phase_names[i], quantity(1e-3 * mean, "s", 3) + share);
  }
}

}  // namespace

void draw_phases_plot(AppContext& context) {
  PlotMemory& m = memory(context).plots;
  const Curves& c = m.current;
  if (begin_run_list()) {
    list_phases(context, c);
    end_run_list();
  }

  Chart chart = time_chart("Time a step", "s");
  chart.y.include_zero = true;
  std::vector<double> stacked(c.size(), 0.0);
  std::vector<double> time = c.time;
  for (std::size_t i = 0; i < c.phase.size(); ++i) {
    for (std::size_t k = 0; k < stacked.size(); ++k) stacked[k] += 1e-3 * c.phase[i][k];
    add_series(chart, phase_names[i], time, stacked, i, Role::current);
  }
  plot(context, "phases", std::move(chart), m.view[3]);
}

}  // namespace pf::app
