#include "app/panels/docks.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/theme.hpp"
#include "app/widgets/run_list.hpp"
#include "app/widgets/text.hpp"

namespace pf::app {

namespace {

/// A full-width header of the accordion; true when clicked.
bool panel_header(const char* title, bool open) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(em(0.5F), em(0.35F)));
  ImGui::SetNextItemOpen(open);
  ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_Button));
  ImGui::PushFont(bold_font());
  const bool now = ImGui::TreeNodeEx(title, ImGuiTreeNodeFlags_CollapsingHeader | ImGuiTreeNodeFlags_NoAutoOpenOnLog);
  ImGui::PopFont();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  return now != open;
}

bool fits_tabs(const std::vector<const Panel*>& plots) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float width = pin_width();
  for (const Panel* p : plots)
    width += ImGui::CalcTextSize(p->title).x + 2 * style.FramePadding.x + style.ItemInnerSpacing.x;
  return width <= ImGui::GetContentRegionAvail().x;
}

void choose_tab(AppContext& context, const std::vector<const Panel*>& plots, PanelMemory& m) {
  const bool force = m.show_plot || m.plot.empty();
  m.show_plot = false;
  if (m.plot.empty()) m.plot = plots.front()->title;
  std::string shown = m.plot;
  for (const Panel* p : plots) {
    const bool bring = force && m.plot == p->title;
    if (!ImGui::BeginTabItem(p->title, nullptr, bring ? ImGuiTabItemFlags_SetSelected : 0)) continue;
    if (!force) shown = p->title;
    ImGui::EndTabItem();
  }
  m.plot = shown;
  pin_tab(context);
}

/// Where the tabs would be cut.
void choose_plot(const std::vector<const Panel*>& plots, PanelMemory& m) {
  m.show_plot = true;  // the tabs, when they come back, follow
  if (m.plot.empty()) m.plot = plots.front()->title;
  ImGui::SetNextItemWidth(std::min(em(12), ImGui::GetContentRegionAvail().x));
  if (!ImGui::BeginCombo("##plot", m.plot.c_str())) return;
  for (const Panel* p : plots)
    if (ImGui::Selectable(p->title, m.plot == p->title)) m.plot = p->title;
  ImGui::EndCombo();
}

/// The panel below its header, as high as it needs to be, at most `room`; where that is next to nothing, as in a low
/// window with large text, the whole column scrolls instead.
void draw_open_panel(AppContext& context, const Panel& panel, float room) {
  PanelMemory& m = memory(context);
  const bool scrolls = room > em(14);
  const float most = std::max(em(10), room - ImGui::GetStyle().ItemSpacing.y);
  float& height = m.panel_heights[panel.title];
  // What a scroll bar makes narrower may become low enough to do without: then it keeps its width, so that the bar does
  // not come and go.
  bool& narrow = m.panel_narrow[panel.title];
  const bool high = scrolls && height > most;
  narrow = scrolls && (narrow ? height > most - em(4) : high);
  ImGui::BeginChild(panel.title,
                    ImVec2(narrow && !high ? -ImGui::GetStyle().ScrollbarSize : 0, height > 0 && !high ? height : most),
                    false,
                    high      ? ImGuiWindowFlags_AlwaysVerticalScrollbar
                    : scrolls ? ImGuiWindowFlags_NoScrollbar
                              : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  gap(0.4F);
  ImGui::Indent(em(0.25F));
  // A child-less way to keep the panel clear of the right edge: everything in it measures the available width.
  ImGui::BeginGroup();
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - em(0.25F));
  panel.draw(context);
  ImGui::PopItemWidth();
  ImGui::EndGroup();
  ImGui::Unindent(em(0.25F));
  gap(0.75F);
  height = ImGui::GetCursorPosY();
  ImGui::SetScrollX(0);  // what reaches a few pixels beyond the edge is no reason to move sideways
  ImGui::EndChild();
}

}  // namespace

void draw_left_column(AppContext& context) {
  PanelMemory& m = memory(context);
  std::vector<std::pair<const Panel*, int>> shown;
  int index = 0;
  for (const Panel& panel : panels()) {
    if (panel.dock != Dock::left) continue;
    if (panel.relevant(context)) shown.emplace_back(&panel, index);
    ++index;
  }
  // All headers stay in sight: what the open panel has too much is scrolled between them.
  const float header = ImGui::GetFontSize() + 2 * em(0.35F) + ImGui::GetStyle().ItemSpacing.y;
  const float room = ImGui::GetContentRegionAvail().y - static_cast<float>(shown.size()) * header;
  for (const auto& [panel, here] : shown) {
    const bool open = m.open_left == here;
    if (open && m.shown_left != here) {  // to be seen whole, once it is known how high it is
      ImGui::SetScrollHereY(0);
      if (m.panel_heights[panel->title] > 0) m.shown_left = here;
    }
    if (panel_header(panel->title, open)) m.open_left = open ? -1 : here;
    if (open) draw_open_panel(context, *panel, room);
  }
}

bool has_inspector(const AppContext& context) {
  for (const Panel& panel : panels())
    if (panel.dock == Dock::right && panel.relevant(context)) return true;
  return false;
}

bool has_wide_inspector(const AppContext& context) {
  return context.slow != nullptr || context.lesson != nullptr;
}

void draw_inspector(AppContext& context) {
  bool first = true;
  for (const Panel& panel : panels()) {
    if (panel.dock != Dock::right || !panel.relevant(context)) continue;
    if (!std::exchange(first, false)) gap(1);
    panel.draw(context);
  }
}

void draw_bottom_drawer(AppContext& context) {
  PanelMemory& m = memory(context);
  std::vector<const Panel*> plots;
  for (const Panel& panel : panels())
    if (panel.dock == Dock::bottom && panel.relevant(context)) plots.push_back(&panel);
  if (plots.empty()) return;
  m.plot_menu = !fits_tabs(plots);
  if (m.plot_menu) {
    choose_plot(plots, m);
  } else if (ImGui::BeginTabBar("plots")) {
    choose_tab(context, plots, m);
    ImGui::EndTabBar();
  }
  const auto shown = std::find_if(plots.begin(), plots.end(), [&](const Panel* p) { return m.plot == p->title; });
  // A closed drawer is its tabs alone.
  const float room = ImGui::GetContentRegionAvail().y;
  const bool open = shown != plots.end() && room > em(4);
  if (!open && room > em(1)) muted("Drag the drawer higher to see more.");
  context.session.set_ledger(open && (*shown)->draw == draw_balance_plot);
  if (open) {
    ImGui::PushID((*shown)->title);
    (*shown)->draw(context);
    ImGui::PopID();
  }
}

}  // namespace pf::app
