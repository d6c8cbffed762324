#include "app/widgets/plot.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <stdexcept>

#include "app/imgui_painter.hpp"
#include "app/widgets/run_list.hpp"
#include "app/widgets/text.hpp"
#include "core/charts/draw.hpp"
#include "core/files.hpp"

namespace pf::app {

namespace fs = std::filesystem;

namespace {

ChartTheme chart_theme(const AppContext& context, float font_size) {
  return context.view.theme == Theme::dark ? dark_theme(font_size) : light_theme(font_size);
}

void load_view(Chart& chart, const PlotView& view) {
  if (view.x_min) chart.x.min = view.x_min;
  if (view.x_max) chart.x.max = view.x_max;
  if (view.y_min) chart.y.min = view.y_min;
  if (view.y_max) chart.y.max = view.y_max;
}
void store_view(const Chart& chart, PlotView& view) {
  view = {chart.x.min, chart.x.max, chart.y.min, chart.y.max};
}

/// What is exported stands alone: all of the data or the zoomed part, with title and legend, on white.
void export_chart(AppContext& context, const Chart& chart, const PlotLook& look, const std::string& stem,
                  const std::string& kind) {
  Chart alone = chart;
  alone.title = look.title.empty() ? context.scene.name : look.title;
  alone.subtitle = look.subtitle;
  if (!look.own_legend) alone.legend = LegendPlace::automatic;
  const fs::path file = free_file(context.save_folder, stem, "." + kind);
  const ImageText usual{{"Title", context.scene.name}, {"Scene", scene_hash(context.scene)}};
  const ImageText& about = look.about.empty() ? usual : look.about;
  try {
    if (kind == "csv")
      write_chart_csv(alone, file);
    else if (kind == "svg")
      write_chart_svg(alone, light_theme(), 800, 450, file, about);
    else
      write_chart_png(alone, light_theme(), 800, 450, file, 2, about);
    if (context.notify) context.notify("Saved " + file.string());
  } catch (const std::runtime_error& failure) {
    if (context.notify) context.notify(failure.what());
  }
}

void menu(AppContext& context, const Chart& chart, const PlotLook& look, const char* stem, PlotView& view) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(em(0.5F), em(0.5F)));
  if (ImGui::BeginPopupContextItem("plot-menu")) {
    if (ImGui::MenuItem("Show all", "double click")) view = {};
    ImGui::Separator();
    if (ImGui::MenuItem("Save numbers (CSV)")) export_chart(context, chart, look, stem, "csv");
    if (ImGui::MenuItem("Save drawing (SVG)")) export_chart(context, chart, look, stem, "svg");
    if (ImGui::MenuItem("Save picture (PNG)")) export_chart(context, chart, look, stem, "png");
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

void handle_mouse(Chart& chart, const ChartLayout& layout, PlotView& view) {
  const ImGuiIO& io = ImGui::GetIO();
  const Point2 mouse{io.MousePos.x, io.MousePos.y};
  if (ImGui::IsItemHovered()) {
    if (ImGui::IsMouseDoubleClicked(0)) {
      view = {};
      return;
    }
    if (io.MouseWheel != 0) {
      zoom(chart, layout, mouse, std::pow(0.85, io.MouseWheel), true, !io.KeyShift);
      store_view(chart, view);
    }
  }
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, em(0.25F))) {
    pan(chart, layout, {io.MouseDelta.x, io.MouseDelta.y});
    store_view(chart, view);
  }
}

/// The point or cell under the mouse is marked and told of; a click on it is handed on.
void handle_target(const Chart& chart, const ChartTheme& theme, const ChartLayout& layout, const PlotLook& look,
                   Painter& painter) {
  const ImGuiIO& io = ImGui::GetIO();
  const Point2 mouse{io.MousePos.x, io.MousePos.y};
  std::optional<ChartHit> hit = hit_test(chart, layout, mouse, em(1.5F));
  if (!look.hover) {
    if (hit) draw_hover(chart, theme, layout, *hit, painter);
    return;
  }
  PlotTarget target;
  if (!chart.cells.empty()) hit.reset();  // on a map it is the cells that count, not the lines over them
  if (hit) target.point = hit->point;
  if (!hit) target.cell = cell_at(chart, layout, mouse);
  if (!target.point && !target.cell) return;
  if (hit) {
    painter.ring(hit->at, 5.5F, theme.text, 1.3F);
  } else {
    const Cell& cell = chart.cells[*target.cell];
    const auto x = [&](double v) { return static_cast<float>(layout.x.map.place(v)); };
    const auto y = [&](double v) { return static_cast<float>(layout.y.map.place(v)); };
    const Point2 frame[] = {{x(cell.x_min), y(cell.y_min)},
                            {x(cell.x_max), y(cell.y_min)},
                            {x(cell.x_max), y(cell.y_max)},
                            {x(cell.x_min), y(cell.y_max)},
                            {x(cell.x_min), y(cell.y_min)}};
    painter.push_clip(layout.plot.min, layout.plot.max);
    painter.polyline(frame, theme.text, em(0.16F));
    painter.pop_clip();
  }
  look.hover(target);
  if (look.click) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const bool dragged = ImGui::GetMouseDragDelta(0, em(0.25F)).x != 0 || ImGui::GetMouseDragDelta(0, em(0.25F)).y != 0;
  if (look.click && ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(0) && !dragged) look.click(target);
}

}  // namespace

void plot(AppContext& context, const char* stem, Chart chart, PlotView& view, const PlotLook& look) {
  const ImVec2 size = ImGui::GetContentRegionAvail();
  if (size.x < em(8) || size.y < em(4)) return muted("Drag the drawer higher to see the chart.");
  // Before the first step there is one time, and none before it.
  bool one = !chart.series.empty() && !chart.series.front().x.empty();
  for (const Series& s : chart.series)
    for (const double x : s.x) one = one && x == chart.series.front().x.front();
  if (one && chart.x.scale == AxisScale::linear && !chart.x.min && !chart.x.max) {
    chart.x.min = chart.series.front().x.front();
    chart.x.max = *chart.x.min + 1;
  }
  load_view(chart, view);
  const Chart whole = chart;
  // The list beside it is its legend; a small plot has room for none: hovering names the curves.
  if ((room_for_list() && !look.own_legend) || size.x < em(18)) chart.legend = LegendPlace::none;
  // The tab says what it is; turned, a long name would not fit beside a low plot.
  if (size.y < em(look.own_legend ? 9 : 16)) chart.y.title.clear();
  ChartTheme theme = chart_theme(context, em(0.85F));
  theme.surface.a = 0;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Point2 low{at.x, at.y}, high{at.x + size.x, at.y + size.y};
  ImGui::InvisibleButton(stem, size);
  ImGuiPainter painter(*ImGui::GetWindowDrawList());
  ImGui::SetItemUsingMouseWheel();  // the panel does not scroll instead
  const ChartLayout layout = draw(chart, theme, low, high, painter);
  chart.y.title = whole.y.title;  // for the note under the mouse
  if (look.overlay) look.overlay(layout, theme, painter);
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) handle_target(chart, theme, layout, look, painter);
  handle_mouse(chart, layout, view);
  menu(context, whole, look, stem, view);
}

}  // namespace pf::app
