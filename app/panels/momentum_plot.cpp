// Momentum over time: linear, or angular with its loss split by cause.
#include <imgui.h>

#include <algorithm>
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
constexpr std::array<const char*, 3> axes{"x", "y", "z"};

struct Line {
  std::string name;
  const std::vector<double>* values;
  std::size_t color;
  bool dashed = false;
};

/// The component whose change is split by cause: the only one in 2D, the largest in 3D.
std::size_t main_axis(const Curves& c, int dimension) {
  std::size_t best = 2;
  if (dimension == 2 || c.size() == 0) return best;
  const auto size = [&](std::size_t a) {
    return std::max(std::abs(c.angular[a].front()), std::abs(c.angular[a].back()));
  };
  for (std::size_t a = 0; a < 2; ++a)
    if (size(a) > size(best)) best = a;
  return best;
}

std::vector<Line> linear_lines(const Curves& c, int dimension) {
  std::vector<Line> lines;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    lines.push_back({std::string("Linear ") + axes[a], &c.momentum[a], a});
  return lines;
}

/// Whether strokes have changed it.
bool worked_on(const Curves& c, std::size_t axis) {
  return !c.stroked[axis].empty() && c.stroked[axis].back() != 0;
}

std::vector<Line> angular_lines(const Curves& c, int dimension, bool split, std::size_t axis) {
  if (dimension == 2) {
    std::vector<Line> lines{{"Angular", &c.angular[2], 0}};
    if (split) lines.push_back({"Change by transfers", &c.lost_transfer[2], 1, true});
    if (split) lines.push_back({"Change by time steps", &c.lost_time[2], 2, true});
    if (split) lines.push_back({"Change by torques", &c.outside[2], 3, true});
    if (split && worked_on(c, 2)) lines.push_back({"Cut and painted", &c.stroked[2], 4, true});
    return lines;
  }
  std::vector<Line> lines;
  for (std::size_t a = 0; a < 3; ++a) lines.push_back({std::string("Angular ") + axes[a], &c.angular[a], a});
  const std::string of = std::string("Change of ") + axes[axis];
  if (split) lines.push_back({of + " by transfers", &c.lost_transfer[axis], 3, true});
  if (split) lines.push_back({of + " by time steps", &c.lost_time[axis], 4, true});
  if (split) lines.push_back({of + " by torques", &c.outside[axis], 5, true});
  if (split && worked_on(c, axis)) lines.push_back({"Cut and painted", &c.stroked[axis], 6, true});
  return lines;
}

void choose(PlotMemory& m) {
  int which = m.angular ? 1 : 0;
  outlined_radio("Linear", &which, 0);
  ImGui::SameLine();
  outlined_radio("Angular", &which, 1);
  if ((which == 1) != m.angular) m.view[1] = {};
  m.angular = which == 1;
  if (m.angular) {
    checkbox("split", "Split the change by cause", &m.split_loss);
    tooltip(
        "Summed from the start of the run. Transfers: particles to grid and back. Time steps: what the time scheme "
        "itself loses. Torques about the origin: gravity, loads, walls, constraints, the mouse.");
  }
}

}  // namespace

void draw_momentum_plot(AppContext& context) {
  PlotMemory& m = memory(context).plots;
  const int d = context.scene.dimension;
  const bool list = begin_run_list();
  if (list) choose(m);
  const char* unit = m.angular ? angular_unit : linear_unit;
  const std::size_t axis = main_axis(m.current, d);
  const auto lines_of = [&](const Curves& c) {
    return m.angular ? angular_lines(c, d, m.split_loss, axis) : linear_lines(c, d);
  };
  const std::vector<Line> lines = lines_of(m.current);
  if (list) {
    for (const Line& line : lines) {
      legend_entry(context, line.color, line.name, newest(*line.values, unit), nullptr, line.dashed);
    }
    pinned_runs(context);
    end_run_list();
  }

  Chart chart = time_chart(m.angular ? "Angular momentum" : "Linear momentum", unit);
  for (std::size_t i = 0; i < m.pinned.size() && i < context.pinned.size(); ++i)
    for (const Line& line : lines_of(m.pinned[i].curves))
      add_series(chart, line.name + ", " + context.pinned[i].label, m.pinned[i].curves.time, *line.values, line.color,
                 Role::pinned, line.dashed);
  for (const Line& line : lines)
    add_series(chart, line.name, m.current.time, *line.values, line.color, Role::current, line.dashed);
  plot(context, "momentum", std::move(chart), m.view[1]);
}

}  // namespace pf::app
