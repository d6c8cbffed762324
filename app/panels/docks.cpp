#include "app/panels/docks.hpp"

#include <imgui.h>

#include "app/panels/memory.hpp"
#include "app/widgets/text.hpp"

namespace pf::app {

namespace {

/// A full-width header of the accordion; true when clicked.
bool panel_header(const char* title, bool open) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(em(0.5F), em(0.35F)));
  ImGui::SetNextItemOpen(open);
  const bool now = ImGui::TreeNodeEx(title, ImGuiTreeNodeFlags_CollapsingHeader | ImGuiTreeNodeFlags_NoAutoOpenOnLog);
  ImGui::PopStyleVar();
  return now != open;
}

}  // namespace

void draw_left_column(AppContext& context) {
  PanelMemory& m = memory(context);
  int index = 0;
  for (const Panel& panel : panels()) {
    if (panel.dock != Dock::left) continue;
    const int here = index++;
    if (!panel.relevant(context)) continue;
    const bool open = m.open_left == here;
    if (panel_header(panel.title, open)) m.open_left = open ? -1 : here;
    if (!open) continue;
    ImGui::PushID(panel.title);
    gap(0.4F);
    ImGui::Indent(em(0.25F));
    const float right = ImGui::GetContentRegionAvail().x - em(0.25F);
    // A child-less way to keep the panel clear of the right edge: everything in it measures the available width.
    ImGui::BeginGroup();
    ImGui::PushItemWidth(right);
    panel.draw(context);
    ImGui::PopItemWidth();
    ImGui::EndGroup();
    ImGui::Unindent(em(0.25F));
    gap(0.75F);
    ImGui::PopID();
  }
}

bool has_inspector(const AppContext& context) {
  for (const Panel& panel : panels())
    if (panel.dock == Dock::right && panel.relevant(context)) return true;
  return false;
}

void draw_inspector(AppContext& context) {
  for (const Panel& panel : panels())
    if (panel.dock == Dock::right && panel.relevant(context)) panel.draw(context);
}

void draw_bottom_drawer(AppContext& context) {
  PanelMemory& m = memory(context);
  if (!ImGui::BeginTabBar("plots", ImGuiTabBarFlags_FittingPolicyScroll)) return;
  const int show = m.show_plot;
  m.show_plot = -1;
  int index = 0;
  for (const Panel& panel : panels()) {
    if (panel.dock != Dock::bottom) continue;
    const int here = index++;
    if (!panel.relevant(context)) continue;
    if (!ImGui::BeginTabItem(panel.title, nullptr, show == here ? ImGuiTabItemFlags_SetSelected : 0)) continue;
    // A closed drawer is its tabs alone.
    if (ImGui::GetContentRegionAvail().y > em(4)) panel.draw(context);
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

}  // namespace pf::app
