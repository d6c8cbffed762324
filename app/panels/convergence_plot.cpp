// Convergence of the newest step's Newton iterations, the steps before it faint.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/memory.hpp"
#include "app/panels/numbers.hpp"
#include "app/panels/panels.hpp"
#include "app/panels/series.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/run_list.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/charts/theme.hpp"

namespace pf::app {

namespace {

constexpr std::size_t steps_before = 8;

Series residuals(const StepReport& report) {
  Series s;
  for (const NewtonIteration& it : report.newton) {
    s.x.push_back(static_cast<double>(s.x.size()));
    s.y.push_back(it.residual);
  }
  // The last entry is the start of the last iteration; what it left is the report's own residual.
  if (!report.newton.empty() && report.newton.back().residual != report.residual) {
    s.x.push_back(static_cast<double>(s.x.size()));
    s.y.push_back(report.residual);
  }
  return s;
}

/// The order with which the newest three residuals fall: r_(k+1) ~ r_k^order; 0 where they do not say.
double observed_order(const Series& s) {
  const std::size_t n = s.y.size();
  if (n < 3 || !(s.y[n - 1] > 0 && s.y[n - 2] < s.y[n - 3] && s.y[n - 1] < s.y[n - 2])) return 0;
  return std::log(s.y[n - 1] / s.y[n - 2]) / std::log(s.y[n - 2] / s.y[n - 3]);
}

/// Where most of an iterate's residual is: a click selects that node.
void worst_cell(AppContext& context, const StepReport& report, std::size_t k) {
  const StepRecord* record = context.record.get();
  if (record == nullptr || record->step != report.step || k >= record->iterates.size()) return ImGui::TextDisabled("-");
  const IterateRecord& it = record->iterates[k];
  if (it.worst < 0) return ImGui::TextDisabled("-");
  NodeIndex node{};
  const auto d = static_cast<std::size_t>(record->dimension);
  std::copy_n(record->node_index.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(it.worst) * d), d,
              node.begin());
  ImGui::PushID(static_cast<int>(k));
  if (ImGui::Selectable(index_text(node, record->dimension).c_str(), context.selected_node == node))
    context.selected_node = node;
  tooltip(quantity(100 * it.worst_share, "", 2) + " % of the squared residual is at this node. A click selects it.");
  ImGui::PopID();
}

void iteration_table(AppContext& context, const StepReport& report) {
  if (!ImGui::BeginTable("newton", 5, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings)) return;
  for (const char* head : {"", "Residual", "Length", "Linear", "Most at"}) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", head);
  }
  for (std::size_t k = 0; k < report.newton.size(); ++k) {
    const NewtonIteration& it = report.newton[k];
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%zu%s", k, it.projected > 0 ? " +" : "");
    if (it.projected > 0)
      tooltip("The tangent was made positive definite at " + quantity(100 * it.projected, "%", 2) + " of the nodes.");
    ImGui::TableNextColumn();
    text_unformatted(quantity(it.residual, "", 2));
    ImGui::TableNextColumn();
    text_unformatted(it.step_length > 0 ? quantity(it.step_length, "", 3) : "-");
    ImGui::TableNextColumn();
    text_unformatted(std::to_string(it.linear_iterations));
    ImGui::TableNextColumn();
    worst_cell(context, report, k);
  }
  ImGui::EndTable();
}

/// A cross on each iteration whose tangent was projected.
void mark_projected(Chart& chart, const StepReport& report) {
  Series marks;
  marks.label = "Tangent made positive definite";
  marks.style = SeriesStyle::points;
  marks.mark = MarkShape::cross;
  marks.color_index = 1;
  for (std::size_t k = 0; k < report.newton.size(); ++k) {
    if (!(report.newton[k].projected > 0)) continue;
    marks.x.push_back(static_cast<double>(k));
    marks.y.push_back(report.newton[k].residual);
  }
  if (!marks.x.empty()) chart.series.push_back(std::move(marks));
}

const StepReport* newest_solved(const std::vector<StepReport>& reports) {
  const auto it = std::find_if(reports.rbegin(), reports.rend(), [](const StepReport& r) { return !r.newton.empty(); });
  return it == reports.rend() ? nullptr : &*it;
}

}  // namespace

void draw_convergence_plot(AppContext& context) {
  context.wants_record = true;
  PlotMemory& m = memory(context).plots;
  const auto& reports = context.current.reports;
  const StepReport* const report = newest_solved(reports);
  if (begin_run_list()) {
    if (report == nullptr) {
      muted("No step has been solved yet.");
    } else {
      legend_entry(context, 0, "Step " + std::to_string(report->step), quantity(report->residual, "", 2));
      if (const double order = observed_order(residuals(*report)); order > 0)
        property("Observed order", quantity(order, "", 2));
      tooltip("2: quadratic, as Newton's method with exact linear solves; these are solved only as well as helps.");
      iteration_table(context, *report);
    }
    end_run_list();
  }

  Chart chart;
  const ChartTheme theme = context.view.theme == Theme::dark ? dark_theme() : light_theme();
  chart.x.title = "Newton iteration";
  chart.y.title = "Residual";
  chart.y.scale = AxisScale::logarithmic;
  chart.x.min = 0;
  const std::size_t first = reports.size() > steps_before + 1 ? reports.size() - steps_before - 1 : 0;
  double longest = 1;
  for (std::size_t k = first; k < reports.size(); ++k) {
    if (reports[k].newton.empty()) continue;
    Series s = residuals(reports[k]);
    longest = std::max(longest, s.x.back());
    const bool newest_one = &reports[k] == report;
    s.label = "Step " + std::to_string(reports[k].step);
    if (newest_one) {
      s.color_index = 0;
    } else {
      s.color = theme.series[0];
      s.color->a = 0.3F;
    }
    s.style = newest_one ? SeriesStyle::line_and_points : SeriesStyle::line;
    chart.series.push_back(std::move(s));
  }
  chart.x.max = longest;
  const int every = longest > 12 ? 5 : 1;
  for (int k = 0; k <= static_cast<int>(longest); k += every) chart.x.ticks.emplace_back(k, std::to_string(k));
  if (report != nullptr) mark_projected(chart, *report);
  chart.references.push_back({context.scene.solver.newton_tolerance, false, "Tolerance"});
  plot(context, "convergence", std::move(chart), m.view[2]);
}

}  // namespace pf::app
