// Energy over time, by kind.
#include <imgui.h>

#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/panels/series.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/run_list.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

void draw_energy_plot(AppContext& context) {
  PlotMemory& m = memory(context).plots;
  struct Line {
    const char* name;
    std::vector<double> Curves::*values;
    bool* on;
    std::size_t color;
  };
  std::vector<Line> lines{{"Total", &Curves::total, &m.total, 0},
                          {"Kinetic", &Curves::kinetic, &m.kinetic, 1},
                          {"Elastic", &Curves::elastic, &m.elastic, 2}};
  if (!context.scene.gravity.isZero(0)) lines.push_back({"Potential", &Curves::potential, &m.potential, 3});
  if (begin_run_list()) {
    for (const Line& line : lines)
      legend_entry(context, line.color, line.name, newest(m.current.*line.values, "J"), line.on);
    pinned_runs(context);
    end_run_list();
  }

  Chart chart = time_chart("Energy", "J");
  chart.y.include_zero = true;
  for (const Line& line : lines) {
    if (!*line.on) continue;
    for (std::size_t i = 0; i < m.pinned.size() && i < context.pinned.size(); ++i)
      add_series(chart, std::string(line.name) + ", " + context.pinned[i].label, m.pinned[i].curves.time,
                 m.pinned[i].curves.*line.values, line.color, Role::pinned);
    add_series(chart, line.name, m.current.time, m.current.*line.values, line.color, Role::current);
  }
  plot(context, "energy", std::move(chart), m.view[0]);
}

}  // namespace pf::app
