#include "app/widgets/run_list.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/panels/memory.hpp"
#include "app/widgets/text.hpp"
#include "core/charts/theme.hpp"

namespace pf::app {

namespace {

constexpr const char* pin_label = "Pin this run";

ImU32 packed(const Color& c) {
  return ImGui::ColorConvertFloat4ToU32(ImVec4(c.r, c.g, c.b, c.a));
}

ChartTheme theme_of(const AppContext& context) {
  return context.view.theme == Theme::dark ? dark_theme() : light_theme();
}

void swatch(ImU32 color, bool dashed) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float y = std::floor(at.y + ImGui::GetTextLineHeight() / 2), thick = em(0.15F);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float ends[] = {at.x, at.x + em(0.4F), at.x + em(0.65F), at.x + em(1.05F)};
  draw.AddRectFilled(ImVec2(ends[0], y - thick / 2), ImVec2(dashed ? ends[1] : ends[3], y + thick / 2), color);
  if (dashed) draw.AddRectFilled(ImVec2(ends[2], y - thick / 2), ImVec2(ends[3], y + thick / 2), color);
  ImGui::Dummy(ImVec2(em(1.05F), ImGui::GetTextLineHeight()));
  ImGui::SameLine(0, em(0.4F));
}

/// A small cross; true when clicked.
bool cross(const char* id) {
  const float size = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(id, ImVec2(size, size));
  const ImU32 color = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
  const float a = size * 0.3F, b = size * 0.7F, thick = em(0.09F);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddLine(ImVec2(at.x + a, at.y + a), ImVec2(at.x + b, at.y + b), color, thick);
  draw.AddLine(ImVec2(at.x + a, at.y + b), ImVec2(at.x + b, at.y + a), color, thick);
  return pressed;
}

}  // namespace

bool room_for_list() {
  return ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x > em(28);
}

bool begin_run_list() {
  if (!room_for_list()) {
    ImGui::SameLine();  // beside the plots' menu
    if (ImGui::Button("Curves")) ImGui::OpenPopup("curves");
    const float most = 0.7F * ImGui::GetIO().DisplaySize.y;
    ImGui::SetNextWindowSizeConstraints(ImVec2(em(16), 0), ImVec2(em(16), most));
    return ImGui::BeginPopup("curves");
  }
  // The table of Newton's iterations needs as much as the least.
  const float width = std::clamp(ImGui::GetContentRegionAvail().x * 0.4F, em(15.4F), em(16));
  ImGui::BeginChild("legend", ImVec2(width, 0), false, ImGuiWindowFlags_NoBackground);
  return true;
}

void end_run_list() {
  if ((ImGui::GetCurrentWindow()->Flags & ImGuiWindowFlags_Popup) != 0) return ImGui::EndPopup();
  ImGui::EndChild();
  ImGui::SameLine(0, em());
}

void legend_entry(const AppContext& context, std::size_t color_index, std::string_view label, std::string_view value,
                  bool* on, bool dashed) {
  const ChartTheme theme = theme_of(context);
  ImGui::PushID(label.data(), label.data() + label.size());
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool shown = on == nullptr || *on;
  const ImU32 color = packed(theme.series[color_index % theme.series.size()]);
  ImGui::BeginGroup();
  swatch(shown ? color : ImGui::GetColorU32(ImGuiCol_Border), dashed);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(shown ? ImGuiCol_Text : ImGuiCol_TextDisabled));
  property(label, value);
  ImGui::PopStyleColor();
  ImGui::EndGroup();
  if (on != nullptr) {
    const ImVec2 after = ImGui::GetCursorScreenPos();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::SetCursorScreenPos(start);
    if (ImGui::InvisibleButton("switch", ImVec2(width, high.y - low.y))) *on = !*on;
    tooltip(*on ? "Click to hide this curve." : "Click to show this curve.");
    ImGui::SetCursorScreenPos(after);
  }
  ImGui::PopID();
}

void pin_tab(AppContext& context) {
  const bool any = context.current.reports.size() > 1;
  ImGui::PushStyleColor(ImGuiCol_Text, any ? accent_color() : ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  if (ImGui::TabItemButton(pin_label, ImGuiTabItemFlags_Trailing) && any && context.pin) context.pin();
  ImGui::PopStyleColor();
  tooltip(any ? "Keeps these curves in grey behind those of the next runs: change a setting, reset and compare."
              : "There is nothing to pin before the first step.");
}

float pin_width() {
  return ImGui::CalcTextSize(pin_label).x + 4 * ImGui::GetStyle().FramePadding.x;
}

void pinned_runs(AppContext& context) {
  PanelMemory& m = memory(context);
  if (context.pinned.empty()) return;
  gap();
  if (!context.current.label.empty()) muted("This run: " + context.current.label);
  for (std::size_t i = 0; i < context.pinned.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const float size = ImGui::GetTextLineHeight();
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    swatch(packed(theme_of(context).pinned), false);
    ImGui::PushTextWrapPos(right - size - em(0.25F));
    std::string label = context.pinned[i].label;
    if (!label.empty() && label[0] >= 'a' && label[0] <= 'z') label[0] = static_cast<char>(label[0] - 'a' + 'A');
    text_unformatted(label);
    ImGui::PopTextWrapPos();
    ImGui::SameLine(right - size);
    const bool unpin = cross("unpin");
    tooltip("Forget this run.");
    ImGui::PopID();
    if (!unpin) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    context.pinned.erase(context.pinned.begin() + at);
    if (i < m.plots.pinned.size()) m.plots.pinned.erase(m.plots.pinned.begin() + at);
    m.plots.relabel = true;
    break;
  }
}

}  // namespace pf::app
