// What a study varies: a row for each setting, with its values.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/studies/describe.hpp"
#include "app/studies/pages.hpp"
#include "app/studies/values.hpp"
#include "app/widgets/choices.hpp"
#include "app/widgets/setting_help.hpp"
#include "app/widgets/text.hpp"
#include "core/params/setting.hpp"

namespace pf::app {

namespace {

constexpr float name_width = 10;  // em
constexpr float one_line = 30;    // em: a setting and its values stand side by side

void changed(StudyDesk& desk) {
  desk.touched = true;
}

/// A combo of all settings that can be varied; the one chosen, or "".
std::string choose_setting(const AppContext& context, const StudyDesk& desk, const char* id, const char* preview,
                           const std::string& now) {
  std::string chosen;
  if (!ImGui::BeginCombo(id, preview, ImGuiComboFlags_HeightLarge)) return chosen;
  for (const std::string& pointer : desk.variable) {
    const bool used = std::any_of(desk.draft.axes.begin(), desk.draft.axes.end(),
                                  [&](const DraftAxis& a) { return a.pointer == pointer; });
    if (used && pointer != now) continue;
    ImGui::PushID(pointer.c_str());
    if (ImGui::Selectable(setting_title(context.scene, pointer).c_str(), pointer == now)) chosen = pointer;
    if (const Setting* setting = find_setting(pointer)) tooltip(setting->help);
    ImGui::PopID();
  }
  ImGui::EndCombo();
  return chosen;
}

/// A check box for each word of a choice; at least one stays.
void draw_choices(StudyDesk& desk, DraftAxis& axis, const Setting& setting) {
  const bool flag = setting.kind == SettingKind::flag;
  const std::vector<nlohmann::json> all =
      flag ? std::vector<nlohmann::json>{false, true}
           : std::vector<nlohmann::json>(setting.choices.begin(), setting.choices.end());
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  bool first = true;
  for (const nlohmann::json& value : all) {
    const std::string word = flag ? "" : value.get<std::string>();
    const std::string label = flag ? (value.get<bool>() ? "on" : "off") : choice_label(axis.pointer, word);
    const float width =
        ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(label.c_str()).x;
    if (!first && ImGui::GetItemRectMax().x + em(1) + width <= right) ImGui::SameLine(0, em(1));
    first = false;
    const auto found = std::find(axis.values.begin(), axis.values.end(), value);
    bool on = found != axis.values.end();
    if (tick_box(label.c_str(), &on)) {
      changed(desk);
      if (on) {
        axis.values.push_back(value);
        // In the order of the table, so that colours do not depend on the order of clicks.
        std::sort(axis.values.begin(), axis.values.end(), [&](const auto& a, const auto& b) {
          return std::find(all.begin(), all.end(), a) < std::find(all.begin(), all.end(), b);
        });
      } else if (axis.values.size() > 1) {
        axis.values.erase(found);
      }
    }
    if (!flag) tooltip(choice_help(axis.pointer, word));
  }
}

/// What stands behind the numbers: two buttons, and the cross.
float behind_numbers() {
  return 2 * (ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x) + em(2.4F);
}

/// The text in a field's frame, over as many lines as it needs; true when clicked.
bool framed_text(const std::string& text, float width) {
  const ImVec2 pad = ImGui::GetStyle().FramePadding, at = ImGui::GetCursorScreenPos();
  const float wrap = width - 2 * pad.x;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
  const bool clicked = ImGui::InvisibleButton("values", ImVec2(width, size.y + 2 * pad.y));
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, ImGui::GetItemRectMax(),
                     ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                     ImGui::GetStyle().FrameRounding);
  draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), ImVec2(at.x + pad.x, at.y + pad.y),
               ImGui::GetColorU32(ImGuiCol_Text), text.c_str(), nullptr, wrap);
  return clicked;
}

/// The field that stands in for the text while it is typed.
void typing_field(StudyDesk& desk, DraftAxis& axis, const Setting& setting, float width) {
  const bool first = desk.focus_typed;
  if (first) ImGui::SetKeyboardFocusHere();
  desk.focus_typed = false;
  ImGui::SetNextItemWidth(width);
  const bool entered = ImGui::InputText("##values", &desk.typed, ImGuiInputTextFlags_EnterReturnsTrue);
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  const bool done = entered || ImGui::IsItemDeactivated();
  if (done && !escaped) {
    axis.values = typed_values(desk.typed, setting, axis.values, desk.refusal);
    desk.refused_axis = desk.refusal.empty() ? "" : axis.pointer;
    changed(desk);
  }
  if (done || (!first && !ImGui::IsItemActive())) desk.typed_axis.clear();
}

/// The numbers as text, and a value more at either end.
void draw_numbers(StudyDesk& desk, DraftAxis& axis, const Setting& setting) {
  const std::string text = values_text(axis.values, setting);
  const float available = ImGui::GetContentRegionAvail().x;
  const bool room_behind = available >= em(14);
  const float width = room_behind ? available - behind_numbers() : available - em(0.5F);
  if (desk.typed_axis == axis.pointer) {
    typing_field(desk, axis, setting, width);
  } else {
    if (framed_text(text, width)) {
      desk.typed_axis = axis.pointer;
      desk.typed = text;
      desk.focus_typed = true;
    }
    tooltip("The values to run. Click to type others, separated by commas.\nAllowed: " + range_text(setting) + ".");
  }
  for (const bool smaller : {true, false}) {
    if (room_behind || !smaller) ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::Button(smaller ? "<" : ">", ImVec2(ImGui::GetFrameHeight(), 0))) {
      axis.values = extended(axis.values, setting, smaller);
      changed(desk);
    }
    tooltip(smaller ? "One value more, smaller than these." : "One value more, larger than these.");
  }
}

/// False when the user took it away.
bool draw_axis(AppContext& context, StudyDesk& desk, DraftAxis& axis) {
  const Setting* setting = find_setting(axis.pointer);
  if (setting == nullptr) return false;
  const bool numbers = setting->kind == SettingKind::number || setting->kind == SettingKind::integer;
  const float available = ImGui::GetContentRegionAvail().x;
  const float needed = numbers ? ImGui::CalcTextSize(values_text(axis.values, *setting).c_str()).x + em(2) : 0;
  const bool side_by_side = available >= em(one_line) && em(name_width + 1) + needed + behind_numbers() <= available;
  const float cross = em(1.6F);
  ImGui::SetNextItemWidth(side_by_side ? em(name_width) : available - cross - em(0.5F));
  const std::string title = setting_title(context.scene, axis.pointer);
  const std::string other = choose_setting(context, desk, "##setting", title.c_str(), axis.pointer);
  if (!ImGui::IsPopupOpen("##setting")) tooltip(setting->help);
  bool stays = true;
  const auto remove = [&] {
    if (text_button("×")) stays = false;
    tooltip("Do not vary this setting.");
  };
  ImGui::SameLine();
  if (!side_by_side) remove();
  ImGui::BeginGroup();
  if (numbers)
    draw_numbers(desk, axis, *setting);
  else
    draw_choices(desk, axis, *setting);
  ImGui::EndGroup();
  if (side_by_side) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - cross);
    remove();
  }
  if (desk.refused_axis == axis.pointer) warning(desk.refusal);
  if (!other.empty() && other != axis.pointer) {
    axis = proposed_axis(context.scene, other, desk.draft.kind);
    changed(desk);
  }
  return stays;
}

}  // namespace

void draw_axes(AppContext& context, StudyDesk& desk) {
  muted("Vary");
  auto& axes = desk.draft.axes;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    ImGui::PushID(static_cast<int>(a));
    const bool stays = draw_axis(context, desk, axes[a]);
    ImGui::PopID();
    if (stays) continue;
    axes.erase(axes.begin() + static_cast<std::ptrdiff_t>(a));
    changed(desk);
    break;
  }
  if (axes.size() >= 8) return;
  ImGui::SetNextItemWidth(em(name_width));
  const std::string more = choose_setting(context, desk, "##more", axes.empty() ? "Choose…" : "And…", "");
  if (more.empty()) return;
  axes.push_back(proposed_axis(context.scene, more, desk.draft.kind));
  changed(desk);
}

}  // namespace pf::app
