#include "app/widgets/text.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/theme.hpp"

namespace pf::app {

namespace {

bool dark_surface() {
  const ImVec4 c = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
  return 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z < 0.5F;
}

void wrapped(std::string_view text, const ImVec4& color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos(0);
  text_unformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

ImVec2 size_of(std::string_view text, float wrap = -1) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, wrap);
}

}  // namespace

ImVec4 warning_color() {
  return dark_surface() ? ImVec4(1, 0.72F, 0.32F, 1) : ImVec4(0.54F, 0.28F, 0, 1);
}
ImVec4 accent_color() {
  return ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
}

void paragraph(std::string_view text) {
  wrapped(text, ImGui::GetStyleColorVec4(ImGuiCol_Text));
}
void muted(std::string_view text) {
  wrapped(text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
}
void warning(std::string_view text) {
  wrapped(text, warning_color());
}

void heading(const char* text) {
  gap();
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void gap(float height) {
  ImGui::Dummy(ImVec2(0, std::max(0.0F, em(height) - ImGui::GetStyle().ItemSpacing.y)));
}

void tooltip(std::string_view text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsAnyMouseDown()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(), pad(em(0.75F), em(0.75F));
  const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, em(24));
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  if (high.y - low.y < em(3)) {  // below it, not over it; above where there is no room
    const float height = size.y + 2 * pad.y, apart = em(0.3F);
    const float y = high.y + apart + height < display.y ? high.y + apart : low.y - apart - height;
    const float x = std::min(low.x, display.x - size.x - 2 * pad.x);
    if (x >= 0 && y >= 0) ImGui::SetNextWindowPos(ImVec2(x, y));
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, pad);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(pad.x + em(24));
  text_unformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void property(std::string_view label, std::string_view value) {
  const float width = ImGui::GetContentRegionAvail().x, value_width = size_of(value).x;
  const bool one_line = size_of(label).x + value_width + em() <= width;
  const float left = ImGui::GetCursorPosX();
  muted(label);
  if (one_line) ImGui::SameLine();
  ImGui::SetCursorPosX(left + std::max(0.0F, width - value_width));
  paragraph(value);
}

bool text_button(const char* label) {
  // At the beginning of a line its text is where all text begins.
  const float begin = ImGui::GetCursorStartPos().x;
  if (ImGui::GetCursorPosX() - begin < 1) ImGui::SetCursorPosX(begin - ImGui::GetStyle().FramePadding.x);
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  const bool pressed = ImGui::SmallButton(label);
  ImGui::PopStyleColor();
  return pressed;
}

bool flow_button(const char* label, bool first) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = size_of(label).x + 2 * style.FramePadding.x;
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (!first && ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) ImGui::SameLine();
  return ImGui::Button(label);
}

namespace {
/// Without it an empty box or circle is hardly seen.
void push_outline() {
  ImVec4 color = ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
  color.w *= 0.8F;
  ImGui::PushStyleColor(ImGuiCol_Border, color);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, std::max(1.0F, std::floor(em(0.07F))));
}
void pop_outline() {
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}
}  // namespace

bool tick_box(const char* label, bool* value) {
  push_outline();
  const bool changed = ImGui::Checkbox(label, value);
  pop_outline();
  return changed;
}

bool outlined_radio(const char* label, bool chosen) {
  push_outline();
  const bool pressed = ImGui::RadioButton(label, chosen);
  pop_outline();
  return pressed;
}

bool outlined_radio(const char* label, int* choice, int value) {
  const bool pressed = outlined_radio(label, *choice == value);
  if (pressed) *choice = value;
  return pressed;
}

bool checkbox(const char* id, std::string_view label, bool* value) {
  ImGui::PushID(id);
  ImGui::BeginGroup();
  bool changed = tick_box("##box", value);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::AlignTextToFramePadding();
  paragraph(label);
  if (ImGui::IsItemClicked()) {
    *value = !*value;
    changed = true;
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return changed;
}

bool foldable(const char* label, bool open) {
  gap(0.25F);
  ImGui::PushStyleColor(ImGuiCol_Header, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  const bool shown = ImGui::TreeNodeEx(label, ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth |
                                                  (open ? ImGuiTreeNodeFlags_DefaultOpen : 0));
  ImGui::PopStyleColor(2);
  return shown;
}

void progress_bar(double share) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = em(0.3F);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto done = static_cast<float>(std::clamp(share, 0.0, 1.0)) * width;
  draw.AddRectFilled(at, ImVec2(at.x + width, at.y + height), ImGui::GetColorU32(ImGuiCol_Border), height / 2);
  if (done >= height)
    draw.AddRectFilled(at, ImVec2(at.x + done, at.y + height), ImGui::GetColorU32(ImGuiCol_CheckMark), height / 2);
  ImGui::Dummy(ImVec2(width, height));
}

bool begin_titled_modal(const char* title, int flags) {
  // Not PushFont: what it leaves on one window's list of drawing would have to be taken from the same.
  ImFont* const letters = ImGui::GetFont();
  ImGui::SetCurrentFont(bold_font());
  const bool open = ImGui::BeginPopupModal(title, nullptr, flags);
  ImGui::SetCurrentFont(letters);
  return open;
}

}  // namespace pf::app
