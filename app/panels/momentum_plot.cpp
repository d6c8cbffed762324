// Momentum over time: linear, or angular with its loss split by cause.
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/panels/series.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/run_list.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

constexpr const char* angular_unit = "kg m\xc2\xb2/s";
constexpr const char* linear_unit = "kg m/s";

struct Line {
  std::string name;
  const std::vector<double>* values;
  std::size_t color;
  bool dashed = false;
};

/// The components that a scene of this dimension has: in 2D only the spin in the plane.
std::vector<Line> lines_of(const Curves& c, bool angular, bool split, int dimension) {
  const std::array<const char*, 3> axes{"x", "y", "z"};
  std::vector<Line> lines;
  for (std::size_t a = 0; a < 3; ++a) {
    const bool there = angular ? dimension == 3 || a == 2 : a < static_cast<std::size_t>(dimension);
    if (!there) continue;
    const std::string axis = angular && dimension == 2 ? "" : std::string(" ") + axes[a];
    const std::size_t color = angular && dimension == 2 ? 0 : a;
    lines.push_back({(angular ? "Angular" : "Linear") + axis, angular ? &c.angular[a] : &c.momentum[a], color});
    if (!angular || !split || dimension == 3) continue;
    lines.push_back({"Change by transfers", &c.lost_transfer[a], 1, true});
    lines.push_back({"Change by time steps", &c.lost_time[a], 2, true});
  }
  return lines;
}

void choose(PlotMemory& m, int dimension) {
  int which = m.angular ? 1 : 0;
  ImGui::RadioButton("Linear", &which, 0);
  ImGui::SameLine();
  ImGui::RadioButton("Angular", &which, 1);
  if ((which == 1) != m.angular) m.view[1] = {};
  m.angular = which == 1;
  if (m.angular && dimension == 2) {
    checkbox("split", "Split the change by cause", &m.split_loss);
    tooltip(
        "Summed from the start of the run. Transfers: particles to grid and back. Time steps: what the step on the "
        "grid does, with walls, loads and gravity.");
  }
}

}  // namespace

void draw_momentum_plot(AppContext& context) {
  PlotMemory& m = memory(context).plots;
  const int d = context.scene.dimension;
  const bool list = begin_run_list();
  if (list) choose(m, d);
  const char* unit = m.angular ? angular_unit : linear_unit;
  const std::vector<Line> lines = lines_of(m.current, m.angular, m.split_loss, d);
  if (list) {
    for (const Line& line : lines) {
      legend_entry(context, line.color, line.name, newest(*line.values, ""), nullptr, line.dashed);
    }
    pinned_runs(context);
    end_run_list();
  }

  Chart chart = time_chart(m.angular ? "Angular momentum" : "Linear momentum", unit);
  for (std::size_t i = 0; i < m.pinned.size() && i < context.pinned.size(); ++i)
    for (const Line& line : lines_of(m.pinned[i].curves, m.angular, m.split_loss, d))
      add_series(chart, line.name + ", " + context.pinned[i].label, m.pinned[i].curves.time, *line.values, line.color,
                 Role::pinned, line.dashed);
  for (const Line& line : lines)
    add_series(chart, line.name, m.current.time, *line.values, line.color, Role::current, line.dashed);
  plot(context, "momentum", std::move(chart), m.view[1]);
}

}  // namespace pf::app
