// The tools as buttons at the view's upper left corner.
#include <imgui.h>

#include <string>

#include "app/compare/desk.hpp"
#include "app/theme.hpp"
#include "app/tools/tool.hpp"
#include "app/workbench.hpp"

namespace pf::app {

void Workbench::draw_tool_bar() {
  if (comparing(context_) || layout_.left.empty() || layout_.view.height < 16 * ImGui::GetFontSize()) return;
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
  for (const ToolInfo& tool : tools()) {
    if (tool.flat_only && context_.scene.dimension != 2) continue;
    const bool chosen = context_.tool == tool.key;
    if (chosen) push_accent_button();
    if (ImGui::Button(tool.label, {4.6f * em, 0})) context_.tool = tool.key;
    if (chosen) pop_accent_button();
    if (ImGui::IsItemHovered()) {
      ImGui::BeginTooltip();
      ImGui::PushTextWrapPos(24 * em);
      ImGui::TextUnformatted(tool.help);
      ImGui::PopTextWrapPos();
      ImGui::EndTooltip();
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(4);
}

}  // namespace pf::app
