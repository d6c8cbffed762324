// The tools as buttons at the view's upper left corner, and beside them what can be chosen for the one in hand.
#include <imgui.h>

#include <cfloat>
#include <vector>

#include "app/compare/desk.hpp"
#include "app/theme.hpp"
#include "app/tools/tool.hpp"
#include "app/workbench.hpp"

namespace pf::app {
namespace {

void explain(const ToolInfo& tool) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(24 * ImGui::GetFontSize());
  ImGui::TextUnformatted(tool.help);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

constexpr float options_width = 13;  ///< [em]

}  // namespace

void Workbench::draw_tool_button(const ToolInfo& tool) {
  const bool chosen = context_.tool == tool.key;
  if (chosen) push_accent_button();
  if (ImGui::Button(tool.label, {4.6f * ImGui::GetFontSize(), 0})) context_.tool = tool.key;
  if (chosen) pop_accent_button();
  explain(tool);
}

void Workbench::draw_tool_bar() {
  if (comparing(context_) || layout_.left.empty()) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({layout_.view.x + 0.8f * em, layout_.view.y + 0.8f * em});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.25f * em, 0.25f * em});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.25f * em, 0.25f * em});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.4f * em);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::Begin("tools", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  std::vector<const ToolInfo*> offered;
  for (const ToolInfo& tool : tools())
    if (!tool.flat_only || context_.scene.dimension == 2) offered.push_back(&tool);
  // A column where there is room for it above scale and axes, else one button that opens it.
  const float needed = static_cast<float>(offered.size()) * (ImGui::GetFrameHeight() + 0.25f * em) + 6 * em;
  if (needed <= layout_.view.height) {
    for (const ToolInfo* tool : offered) draw_tool_button(*tool);
  } else {
    const char* now = offered.front()->label;
    for (const ToolInfo* tool : offered)
      if (context_.tool == tool->key) now = tool->label;
    ImGui::SetNextItemWidth(6 * em);
    if (ImGui::BeginCombo("##tool", now, ImGuiComboFlags_HeightLarge)) {
      for (const ToolInfo* tool : offered) {
        if (ImGui::Selectable(tool->label, context_.tool == tool->key)) context_.tool = tool->key;
        explain(*tool);
      }
      ImGui::EndCombo();
    }
  }
  const ImVec2 place = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ImGui::End();
  // Beside the bar, or below it where the colours' bar would be in the way.
  const float beside = place.x + size.x + 0.4f * em;
  const bool room = beside + (options_width + 10) * em < layout_.view.right();
  draw_tool_options(room ? Point2{beside, place.y} : Point2{place.x, place.y + size.y + 0.4f * em});
  ImGui::PopStyleVar(4);
}

void Workbench::draw_tool_options(Point2 place) {
  Tool* const tool = view_ ? view_->tool() : nullptr;
  if (tool == nullptr || !tool->has_options()) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.5f * em, 0.4f * em});
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::SetNextWindowSizeConstraints({options_width * em, 0}, {options_width * em, FLT_MAX});
  ImGui::Begin("tool options", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  tool->draw_options(context_);
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace pf::app
