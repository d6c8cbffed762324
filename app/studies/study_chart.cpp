// The chart of a study: dots that can be pointed at and opened, and where the live scene is among them.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/studies/describe.hpp"
#include "app/studies/pages.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/text.hpp"

namespace pf::app {

namespace {

/// The setting of a point or a cell; nothing for what shows no run.
std::optional<std::size_t> setting_at(const StudyFigure& figure, const PlotTarget& target) {
  if (target.cell && *target.cell < figure.cell.size()) return figure.cell[*target.cell];
  if (!target.point || target.point->series >= figure.point.size()) return std::nullopt;
  const auto& points = figure.point[target.point->series];
  return target.point->index < points.size() ? std::optional(points[target.point->index]) : std::nullopt;
}

void tell(const StudyDesk& desk, std::size_t setting) {
  const StudyRow* row = desk.row_of(setting);
  if (row == nullptr) return;
  const std::vector<std::string> lines = row_words(*desk.results->study, *row);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(em(24));
  text_unformatted(lines.front());
  std::string measured;
  for (std::size_t k = 1; k < lines.size(); ++k) measured += (k > 1 ? "\n" : "") + lines[k];
  muted(measured);
  ImGui::PushStyleColor(ImGuiCol_Text, accent_color());
  text_unformatted("Click to use these settings");
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

Color packed(const ImVec4& c) {
  return {c.x, c.y, c.z, 1};
}

/// A ring and a cross of hairs with a word beside it, readable over cells of any colour.
void mark_here(const Chart& chart, const ChartLayout& layout, const ChartTheme& theme, const ChartPlace& place,
               Painter& painter) {
  const Point2 at{static_cast<float>(layout.x.map.place(place.x)), static_cast<float>(layout.y.map.place(place.y))};
  if (!std::isfinite(at.x) || !std::isfinite(at.y) || !layout.plot.grown(1).contains(at)) return;
  const Color accent = packed(accent_color());
  Color back = theme.panel;
  back.a = 0.85F;
  const float size = theme.font_size, reach = 0.95F * size, radius = 0.55F * size;
  for (const auto& [color, width] : {std::pair(back, 0.36F * size), std::pair(accent, 0.14F * size)}) {
    painter.ring(at, radius, color, width);
    for (const auto& [x, y] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      const auto dx = static_cast<float>(x), dy = static_cast<float>(y);
      const Point2 hair[] = {{at.x + dx * radius, at.y + dy * radius}, {at.x + dx * reach, at.y + dy * reach}};
      painter.polyline(hair, color, width);
    }
  }
  const std::string words = place.measured ? "you are here" : "you are about here";
  const float width = painter.text_width(words, size, FontWeight::bold), pad = 0.3F * size;
  // Of the places around it the one that hides the fewest points.
  const float beside = reach + pad, across = -width / 2, up = -reach - 0.6F * size, down = reach + 1.2F * size;
  const Point2 offsets[] = {
      {beside, -0.6F * size}, {-beside - width, -0.6F * size}, {across, up},   {across, down},
      {beside, up},           {-beside - width, up},           {beside, down}, {-beside - width, down}};
  std::optional<Box> best;
  std::size_t fewest = 0;
  for (const Point2& offset : offsets) {
    const float x = at.x + offset.x, y = at.y + offset.y;
    const Box box{{x - pad, y - 0.95F * size}, {x + width + pad, y + 0.35F * size}};
    if (!layout.plot.contains(box.min) || !layout.plot.contains(box.max)) continue;
    std::size_t hidden = 0;
    for (std::size_t s = 0; s < chart.series.size(); ++s)
      for (std::size_t k = 0; k < chart.series[s].x.size(); ++k)
        hidden += box.grown(0.4F * size).contains(layout.place(chart, {s, k})) ? 1 : 0;
    if (best && hidden >= fewest) continue;
    best = box;
    fewest = hidden;
  }
  if (!best) return;
  painter.rectangle(best->min, best->max, back, 0.25F * size);
  painter.text({best->min.x + pad, best->min.y + 0.95F * size}, words, size, accent, TextAlign::left, FontWeight::bold);
}

/// A ring around the answer to "cheapest for an error below".
void mark_answer(const StudyFigure& figure, const Chart& chart, const ChartLayout& layout, const ChartTheme& theme,
                 std::size_t setting, Painter& painter) {
  for (std::size_t s = 0; s < figure.point.size() && s < chart.series.size(); ++s)
    for (std::size_t k = 0; k < figure.point[s].size(); ++k) {
      if (figure.point[s][k] != setting || chart.series[s].pinned) continue;
      const Point2 at = layout.place(chart, {s, k});
      if (layout.plot.grown(1).contains(at))
        painter.ring(at, 0.75F * theme.font_size, packed(accent_color()), 0.16F * theme.font_size);
    }
}

/// A line at the error that is good enough.
void mark_bound(const StudyDesk& desk, const StudyFigure& figure, Chart& chart) {
  const std::optional<double> bound = desk.bound();
  if (figure.is_map() || !bound) return;
  if (chart.y.title == column_title(*desk.results->study, "error_l2").first)
    chart.references.push_back({.at = *bound, .label = "good enough"});
}

}  // namespace

void draw_study_chart(AppContext& context, StudyDesk& desk) {
  const StudyFigure* figure = desk.shown_figure();
  const bool empty = figure == nullptr || (figure->chart.series.empty() && figure->chart.cells.empty());
  if (empty) {
    muted(desk.status.active() ? "The first dot comes with the first finished run." : "No run has finished yet.");
    return;
  }
  Chart chart = figure->chart;
  PlotLook look;
  look.own_legend = true;
  look.title = chart.title;
  look.subtitle = chart.subtitle;
  const Study& study = *desk.results->study;
  look.about = {{"Title", chart.title}, {"Study", study.source}, {"Study hash", desk.identity}};
  chart.title.clear();
  chart.subtitle.clear();
  if (ImGui::GetContentRegionAvail().x < em(38)) chart.legend = figure->is_map() ? LegendPlace::none : chart.legend;
  mark_bound(desk, *figure, chart);
  const std::optional<Cheapest> answer = desk.answer();
  const std::optional<ChartPlace> here =
      desk.place ? place_on(*figure, study, *desk.place) : std::optional<ChartPlace>();
  look.overlay = [&](const ChartLayout& layout, const ChartTheme& theme, Painter& painter) {
    if (answer && !figure->is_map()) mark_answer(*figure, chart, layout, theme, answer->best->point, painter);
    if (here) mark_here(chart, layout, theme, *here, painter);
  };
  look.hover = [&](const PlotTarget& target) {
    if (const auto setting = setting_at(*figure, target)) tell(desk, *setting);
  };
  look.click = [&](const PlotTarget& target) {
    if (const auto setting = setting_at(*figure, target)) load_setting(context, *setting);
  };
  plot(context, "study", chart, desk.view, look);
}

}  // namespace pf::app
