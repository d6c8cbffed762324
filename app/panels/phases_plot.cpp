// Where the time of each step goes: phases stacked on one another.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/panels/series.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/run_list.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/charts/theme.hpp"

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
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0, ImGui::GetStyle().ItemSpacing.y / 2));
  const bool table = ImGui::BeginTable("shares", 2);
  ImGui::PopStyleVar();
  if (!table) return;
  ImGui::TableSetupColumn("phase", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("share", ImGuiTableColumnFlags_WidthFixed, em(3.2F));
  for (std::size_t i = c.phase.size(); i-- > 0;) {
    const double mean = recent_mean(c.phase[i]);
    ImGui::TableNextColumn();
    legend_entry(context, i, phase_names[i], quantity(1e-3 * mean, "s", 3));
    ImGui::TableNextColumn();
    const int share = static_cast<int>(std::lround(sum > 0 ? 100 * mean / sum : 0));
    const std::string text = (mean > 0 && share == 0 ? "< 1" : std::to_string(share)) + " %";
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x -
                         ImGui::CalcTextSize(text.c_str()).x);
    muted(text);
  }
  ImGui::EndTable();
}

constexpr std::size_t most_bars = 100;

/// A value holds over the whole of its step: the line over bars of single steps goes along their tops.
struct Steps {
  std::vector<double> x, y;
};
Steps along_steps(const std::vector<double>& time, const std::vector<double>& values) {
  if (values.size() > most_bars) return {time, values};
  Steps s;
  for (std::size_t k = 1; k < values.size(); ++k)
    for (const double t : {time[k - 1], time[k]}) {
      s.x.push_back(t);
      s.y.push_back(values[k]);
    }
  return s;
}

/// Bars of the phases on one another, each the mean of as many steps as fit a bar of some pixels.
void add_bars(Chart& chart, const Curves& c, const ChartTheme& theme) {
  const std::size_t n = c.size(), first = n > 0 && c.step_ms[0] == 0 ? 1 : 0;  // no work before the first step
  if (n < first + 2) return;
  const std::size_t bars = std::min(most_bars, n - first);
  for (std::size_t b = 0; b < bars; ++b) {
    const std::size_t from = first + b * (n - first) / bars, to = first + (b + 1) * (n - first) / bars;
    const double begin = from > 0 ? c.time[from - 1] : c.time[from], end = c.time[to - 1];
    double height = 0;
    for (std::size_t i = 0; i < c.phase.size(); ++i) {
      const double sum = std::accumulate(c.phase[i].begin() + static_cast<std::ptrdiff_t>(from),
                                         c.phase[i].begin() + static_cast<std::ptrdiff_t>(to), 0.0);
      const double top = height + 1e-3 * sum / static_cast<double>(to - from);
      Cell cell;
      cell.x_min = begin;
      cell.x_max = end;
      cell.y_min = height;
      cell.y_max = top;
      cell.fill = theme.series[i % theme.series.size()];
      cell.fill.a = 0.55F;
      chart.cells.push_back(cell);
      height = top;
    }
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

  Chart chart = time_chart("Time per step", "s");
  chart.y.include_zero = true;
  std::vector<double> stacked(c.size(), 0.0);
  for (std::size_t i = 0; i < c.phase.size(); ++i) {
    for (std::size_t k = 0; k < stacked.size(); ++k) stacked[k] += 1e-3 * c.phase[i][k];
    // What takes no time, as line searches do while whole steps are right, would hide the line below it.
    if (std::all_of(c.phase[i].begin(), c.phase[i].end(), [](double ms) { return ms == 0; })) continue;
    const Steps steps = along_steps(c.time, stacked);
    add_series(chart, phase_names[i], steps.x, steps.y, i, Role::current);
  }
  add_bars(chart, c, context.view.theme == Theme::dark ? dark_theme() : light_theme());
  plot(context, "phases", std::move(chart), m.view[3]);
}

}  // namespace pf::app
