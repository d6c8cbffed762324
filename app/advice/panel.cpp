// Advice: no more than this scene needs, each piece with what was measured, one click to follow it and one to take it
// back; beside it all trials, cost against error.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/advice/desk.hpp"
#include "app/advice/words.hpp"
#include "app/panels/panels.hpp"
#include "app/theme.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

constexpr float wide = 44;        // em: the chart stands beside the list
constexpr float side_width = 24;  // em

void draw_ask(AppContext& context, AdviceDesk& desk) {
  if (desk.busy()) {
    paragraph("Trials from the state at hand: " + std::to_string(std::lround(100 * desk.progress())) + " %");
    progress_bar(desk.progress());
    if (ImGui::Button("Cancel")) desk.cancel();
    return;
  }
  const bool first = desk.report() == nullptr;
  if (first)
    muted(
        "What could be left out or done more cheaply, at the same accuracy? Trials go on from the state at hand, each "
        "with something changed, beside a run with finer steps. The run itself is not touched.");
  const bool possible = context.status.state != RunState::loading && context.status.state != RunState::failed &&
                        !context.status.suspended;
  ImGui::BeginDisabled(!possible);
  push_accent_button();
  if (ImGui::Button(first ? "Measure" : "Measure again")) desk.ask(context);
  pop_accent_button();
  ImGui::EndDisabled();
  tooltip(
      "Measures what longer steps, other integrators, explicit steps, smaller bases, looser tolerances would cost "
      "and how far they would be off, from the state at hand.");
}

void draw_trial(AppContext& context, const AdviceDesk& desk, std::size_t k) {
  const AdviceReport& report = *desk.report();
  const Trial& trial = report.trials[k];
  ImGui::PushID(static_cast<int>(k));
  gap(0.25F);
  ImGui::PushFont(bold_font());
  paragraph(trial.sentence + ".");
  ImGui::PopFont();
  muted(evidence(report, trial));
  switch (desk.use_of(context, trial)) {
    case AdviceDesk::Use::offered:
      if (ImGui::Button("Apply")) desk.take(context, trial);
      tooltip("Puts these settings into the scene, from the next step on. Ctrl+Z takes them back.");
      break;
    case AdviceDesk::Use::taken:
      if (ImGui::Button("Take back")) desk.take_back(context, trial);
      tooltip("The settings as they were.");
      break;
    case AdviceDesk::Use::stale:
      ImGui::BeginDisabled();
      ImGui::Button("Apply");
      ImGui::EndDisabled();
      tooltip("This was measured with other settings than the scene has now: measure again.");
      break;
  }
  ImGui::PopID();
}

void draw_list(AppContext& context, AdviceDesk& desk) {
  draw_ask(context, desk);
  if (!desk.failure().empty()) warning(desk.failure());
  if (desk.report() == nullptr || desk.busy()) return;
  const AdviceReport& report = *desk.report();
  if (const std::string none = no_advice(report); !none.empty()) paragraph(none);
  for (const std::size_t k : report.advice) draw_trial(context, desk, k);
  gap(0.5F);
  if (const std::string resting = resting_words(report); !resting.empty()) muted(resting);
  if (const std::string how = basis_of_judgement(report); !how.empty()) muted(how);
}

/// Which trial a point of the chart is, by series.
using Shown = std::vector<std::vector<std::size_t>>;

Chart chart_of(const AdviceReport& report, Shown& shown) {
  Chart chart;
  chart.x = {.title = "Work, as it is = 1", .scale = AxisScale::logarithmic};
  chart.y = {.title = "Error", .unit = "m", .scale = AxisScale::logarithmic};
  struct Kind {
    const char* label;
    MarkShape mark;
    std::optional<std::size_t> color;  ///< of the theme; none: grey
  };
  static constexpr std::array kinds{Kind{"As it is", MarkShape::diamond, 0}, Kind{"Worth doing", MarkShape::circle, 2},
                                    Kind{"Tried", MarkShape::circle, {}}};
  static constexpr Color grey{0.5F, 0.52F, 0.55F, 1};
  shown.assign(kinds.size(), {});
  chart.series.resize(kinds.size());
  const double unit = report.trials.front().work;
  for (std::size_t k = 0; k < report.trials.size(); ++k) {
    const Trial& trial = report.trials[k];
    if (!trial.came_through || trial.work == 0) continue;
    const bool worth = std::find(report.advice.begin(), report.advice.end(), k) != report.advice.end();
    const std::size_t kind = k == 0 ? 0 : worth ? 1 : 2;
    chart.series[kind].x.push_back(trial.work / unit);
    chart.series[kind].y.push_back(trial.error);
    shown[kind].push_back(k);
  }
  for (std::size_t s = 0; s < kinds.size(); ++s) {
    chart.series[s].label = kinds[s].label;
    chart.series[s].style = SeriesStyle::points;
    chart.series[s].mark = kinds[s].mark;
    chart.series[s].color_index = kinds[s].color;
    if (!kinds[s].color) chart.series[s].color = grey;
  }
  std::erase_if(chart.series, [](const Series& s) { return s.x.empty(); });
  std::erase_if(shown, [](const auto& s) { return s.empty(); });
  if (report.grid_open > 0) chart.references.push_back({.at = report.grid_open, .label = "grid"});
  chart.mark_pareto = true;
  return chart;
}

void draw_chart(AppContext& context, AdviceDesk& desk) {
  const AdviceReport* report = desk.report();
  if (report == nullptr || !report->why_none.empty()) return;
  Shown shown;
  Chart chart = chart_of(*report, shown);
  PlotLook look;
  look.own_legend = true;
  look.title = "Advice for " + (context.scene.name.empty() ? "the scene" : context.scene.name);
  look.subtitle = "Work and error over " + quantity(report->span, "s", 3) +
                  " from t = " + quantity(report->time, "s", 4) + ", work of the run as it is = 1";
  look.hover = [&](const PlotTarget& target) -> std::string {
    if (!target.point) return {};
    const Trial& trial = report->trials[shown[target.point->series][target.point->index]];
    return trial.title + "\n" + evidence(*report, trial);
  };
  plot(context, "advice", std::move(chart), desk.view, look);
}

}  // namespace

void draw_advice_panel(AppContext& context) {
  AdviceDesk& desk = advice_of(context);
  const bool beside = ImGui::GetContentRegionAvail().x >= em(wide), any = desk.report() != nullptr;
  if (!beside && any) {
    ImGui::PushStyleColor(ImGuiCol_Text, accent_color());
    if (text_button(desk.show_chart ? "List" : "Chart")) desk.show_chart = !desk.show_chart;
    ImGui::PopStyleColor();
  }
  if (beside || !any || !desk.show_chart) {
    ImGui::BeginChild("list", ImVec2(beside ? em(side_width) : 0, 0), false, ImGuiWindowFlags_NoBackground);
    draw_list(context, desk);
    ImGui::EndChild();
    if (!beside) return;
    ImGui::SameLine(0, em());
  }
  ImGui::BeginChild("chart", ImVec2(0, 0), false, ImGuiWindowFlags_NoBackground);
  draw_chart(context, desk);
  ImGui::EndChild();
}

}  // namespace pf::app
