// Convergence of the newest step's Newton iterations, the steps before it faint.
#include <imgui.h>

#include <algorithm>

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

void iteration_table(const StepReport& report) {
  if (!ImGui::BeginTable("newton", 4, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings)) return;
  for (const char* head : {"", "Residual", "Step length", "Linear"}) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", head);
  }
  for (std::size_t k = 0; k < report.newton.size(); ++k) {
    const NewtonIteration& it = report.newton[k];
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%zu%s", k, it.projected ? " +" : "");
    if (it.projected) tooltip("The tangent was made positive definite for this iteration.");
    ImGui::TableNextColumn();
    text_unformatted(quantity(it.residual, "", 2));
    ImGui::TableNextColumn();
    text_unformatted(it.step_length > 0 ? quantity(it.step_length, "", 3) : "-");
    ImGui::TableNextColumn();
    text_unformatted(std::to_string(it.linear_iterations));
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
    if (!report.newton[k].projected) continue;
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
  PlotMemory& m = memory(context).plots;
  const auto& reports = context.current.reports;
  const StepReport* const report = newest_solved(reports);
  if (begin_run_list()) {
    if (report == nullptr) {
      muted("No step has been solved yet.");
    } else {
      legend_entry(context, 0, "Step " + std::to_string(report->step), quantity(report->residual, "", 2));
      iteration_table(*report);
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
