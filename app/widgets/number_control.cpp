#include "app/widgets/number_control.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/widgets/setting_help.hpp"
#include "app/widgets/slider.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

constexpr float mark_width = 1.1F;  // em

/// An open circle with an arrow head: "takes effect after a reset".
void reset_mark(const ImVec2& centre, float radius, ImU32 color) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float from = -0.7F, to = 4.0F;
  draw.PathArcTo(centre, radius, from, to, 16);
  draw.PathStroke(color, 0, em(0.08F));
  const ImVec2 tip(centre.x + radius * std::cos(from), centre.y + radius * std::sin(from));
  const float h = radius * 0.7F;
  draw.AddTriangleFilled(ImVec2(tip.x - h, tip.y), ImVec2(tip.x + h * 0.5F, tip.y - h),
                         ImVec2(tip.x + h * 0.5F, tip.y + h * 0.6F), color);
}

/// The text field that stands in for the value while one is typed.
std::optional<double> typing_field(const NumberControl& c, double number) {
  Typing& typing = c.typing;
  const bool first = typing.focus;
  if (first) ImGui::SetKeyboardFocusHere();
  typing.focus = false;
  const bool entered = ImGui::InputText("##typed", &typing.text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  std::optional<double> result;
  if (entered || (ImGui::IsItemDeactivated() && !escaped)) {
    const std::string refusal = number_refusal(typing.text, c.setting);
    if (!refusal.empty()) {
      typing.refuse(c.key, refusal);
    } else {
      typing.forgive(c.key);
      const double typed = *parse_quantity(typing.text, c.setting.unit);
      if (typed != number) result = typed;
    }
    typing.key.clear();
  } else if (!first && !ImGui::IsItemActive()) {
    typing.key.clear();
  }
  return result;
}

/// The value as text that ends where the column ends; a line below it shows that it can be clicked.
void value_text_button(const NumberControl& c, const std::string& text, double number) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(text.c_str());
  const float pad = ImGui::GetStyle().FramePadding.y;
  if (ImGui::InvisibleButton("value", ImVec2(size.x, ImGui::GetFrameHeight()))) c.typing.begin(c.key, number);
  const bool hovered = ImGui::IsItemHovered();
  const ImU32 color = ImGui::GetColorU32(hovered ? ImGuiCol_CheckMark : ImGuiCol_Text);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddText(ImVec2(at.x, at.y + pad), color, text.c_str());
  if (hovered) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    const float y = at.y + pad + size.y;
    draw.AddLine(ImVec2(at.x, y), ImVec2(at.x + size.x, y), color, em(0.06F));
  }
  tooltip("Click to type a value: a number, with its unit or a prefix if you like (25 kPa), or a sum (1/60).");
  if (c.after_item) c.after_item();
}

}  // namespace

void Typing::begin(const std::string& whose, double number) {
  key = whose;
  text = plain_number(number);
  focus = true;
}
void Typing::refuse(const std::string& whose, std::string why) {
  refused_key = whose;
  refusal = std::move(why);
}
void Typing::forgive(const std::string& whose) {
  if (refused_key == whose) refused_key.clear();
}

void setting_label(const std::string& label, const std::string& help, bool needs_reset, float width) {
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - (needs_reset ? em(mark_width) : 0));
  ImGui::AlignTextToFramePadding();
  text_unformatted(label);
  ImGui::PopTextWrapPos();
  if (needs_reset) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::SameLine(0, 0);
    ImGui::Dummy(ImVec2(em(mark_width), em()));
    reset_mark(ImVec2(high.x + em(0.65F), low.y + em(0.5F) + ImGui::GetStyle().FramePadding.y * 0), em(0.27F),
               ImGui::GetColorU32(ImGuiCol_TextDisabled));
  }
  ImGui::EndGroup();
  tooltip(help);
}

std::optional<double> number_control(const NumberControl& c, double number) {
  const float available = ImGui::GetContentRegionAvail().x, left = ImGui::GetCursorPosX();
  const bool typing = c.typing.key == c.key;
  const std::string text = quantity(number, c.setting.unit);
  const float value_width = std::min(available, typing ? em(8) : ImGui::CalcTextSize(text.c_str()).x);
  const float label_width = ImGui::CalcTextSize(c.label.c_str()).x + (c.needs_reset ? em(mark_width) : 0) + 1;
  const bool one_line = label_width + em(0.5F) + value_width <= available;
  setting_label(c.label, c.help, c.needs_reset, one_line ? label_width : available);
  if (one_line) ImGui::SameLine();
  ImGui::SetCursorPosX(left + available - value_width);
  ImGui::SetNextItemWidth(value_width);
  std::optional<double> result;
  if (typing)
    result = typing_field(c, number);
  else
    value_text_button(c, text, number);

  SliderRange range{c.setting.slider_min, c.setting.slider_max, c.setting.logarithmic && c.setting.slider_min > 0,
                    c.setting.kind == SettingKind::integer};
  if (!(range.max > range.min)) return result;
  // The track belongs to the line above it: closer than two settings are to each other.
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
  double moved = number;
  const SliderResult slid = slider("##slider", moved, range, c.mark);
  if (slid.type) c.typing.begin(c.key, number);
  if (slid.changed) {
    result = moved;
    c.typing.forgive(c.key);
  }
  tooltip(c.help);
  if (c.after_item) c.after_item();
  return result;
}

}  // namespace pf::app
