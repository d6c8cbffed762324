// The tools as buttons at the view's upper left corner, and beside them what can be chosen for the one in hand.
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <vector>

#include "app/compare/desk.hpp"
#include "app/theme.hpp"
#include "app/tools/tool.hpp"
#include "app/workbench.hpp"
#include "render/overlay.hpp"

namespace pf::app {
namespace {

/// Beside the bar, over none of it.
void explain(const ToolInfo& tool) {
  if (!ImGui::IsItemHovered()) return;
  const float em = ImGui::GetFontSize();
  const ImVec2 bar = ImGui::GetWindowPos();
  ImGui::SetNextWindowPos({bar.x + ImGui::GetWindowWidth() + 0.4F * em, ImGui::GetItemRectMin().y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.75F * em, 0.6F * em});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(24 * em);
  ImGui::TextUnformatted(tool.help);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

// In em.
constexpr float options_width = 13, narrow_options = 10.5F;
constexpr float button_width = 4.6F, from_edge = 0.8F;
constexpr float surface = 0.94F;  ///< opaque enough for text over bright colours

std::vector<const ToolInfo*> offered_tools(const Scene& scene) {
  std::vector<const ToolInfo*> offered;
  for (const ToolInfo& tool : tools())
    if (!tool.flat_only || scene.dimension == 2) offered.push_back(&tool);
  return offered;
}

}  // namespace

/// A column where there is room for it above scale and axes, else one button that opens it.
bool Workbench::tools_in_column() const {
  const float em = ImGui::GetFontSize();
  const auto count = static_cast<float>(offered_tools(context_.scene).size());
  return count * (ImGui::GetFrameHeight() + 0.25f * em) + 6 * em <= layout_.view.height;
}

/// Fitted content stands beside the tools.
ViewMargins Workbench::view_margins() const {
  const float em = ImGui::GetFontSize();
  const auto units = [&](float length) { return static_cast<double>(length / em * base_em); };
  const int dimension = context_.snapshot ? context_.snapshot->dimension : context_.scene.dimension;
  ViewMargins m = overlay_margins(dimension, units(layout_.view.width), units(layout_.view.height));
  if (context_.view.hide_panels) return m;
  if (tools_in_column())
    m.left = std::max(m.left, units((from_edge + button_width + 0.5F + 0.6F) * em));
  else if (view_ && view_->tool() != nullptr && view_->tool()->has_options())
    m.top = std::max(m.top, units(6.5F * em));
  return m;
}

void Workbench::draw_tool_button(const ToolInfo& tool) {
  const bool chosen = context_.tool == tool.key;
  if (chosen) push_accent_button();
  if (ImGui::Button(tool.label, {button_width * ImGui::GetFontSize(), 0})) context_.tool = tool.key;
  if (chosen) pop_accent_button();
  explain(tool);
}

void Workbench::draw_tool_bar() {
  if (comparing(context_) || context_.view.hide_panels) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({layout_.view.x + from_edge * em, layout_.view.y + from_edge * em});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.25f * em, 0.25f * em});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.25f * em, 0.25f * em});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.4f * em);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::SetNextWindowBgAlpha(surface);
  ImGui::Begin("tools", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  if (tools_in_column())
    for (const ToolInfo* tool : offered_tools(context_.scene)) draw_tool_button(*tool);
  else
    draw_tool_choice();
  const ImVec2 place = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ImGui::End();
  // Beside the bar, clear of a colour bar that stands there, or below it.
  const float beside = place.x + size.x + 0.4f * em;
  const Rect& v = layout_.view;
  const float height = v.height / em * base_em;
  const bool stands = height >= lowest_with_lying_legend && !legend_lies({0, 0}, {v.width / em * base_em, height});
  const float right = v.right() - (stands ? 10 : from_edge) * em;
  const float width = beside + options_width * em < right ? options_width : narrow_options;
  const bool room = beside + width * em < right;
  draw_tool_options(room ? Point2{beside, place.y} : Point2{place.x, place.y + size.y + 0.4f * em}, width);
  ImGui::PopStyleVar(4);
}

void Workbench::draw_tool_choice() {
  const std::vector<const ToolInfo*> offered = offered_tools(context_.scene);
  const char* now = offered.front()->label;
  for (const ToolInfo* tool : offered)
    if (context_.tool == tool->key) now = tool->label;
  ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
  if (!ImGui::BeginCombo("##tool", now, ImGuiComboFlags_HeightLarge)) {
    for (const ToolInfo* tool : offered)
      if (context_.tool == tool->key) explain(*tool);
    return;
  }
  for (const ToolInfo* tool : offered) {
    if (ImGui::Selectable(tool->label, context_.tool == tool->key)) context_.tool = tool->key;
    explain(*tool);
  }
  ImGui::EndCombo();
}

void Workbench::draw_tool_options(Point2 place, float width) {
  Tool* const tool = view_ ? view_->tool() : nullptr;
  if (tool == nullptr || !tool->has_options()) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.5f * em, 0.4f * em});
  ImGui::SetNextWindowBgAlpha(surface);
  ImGui::SetNextWindowSizeConstraints({width * em, 0}, {width * em, FLT_MAX});
  ImGui::Begin("tool options", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  tool->draw_options(context_);
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace pf::app
