#include "app/widgets/setting_widget.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/compare/desk.hpp"
#include "app/panels/memory.hpp"
#include "app/panels/relevance.hpp"
#include "app/widgets/choices.hpp"
#include "app/widgets/number_control.hpp"
#include "app/widgets/setting_help.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/params/setting.hpp"

namespace pf::app {

namespace {

using nlohmann::ordered_json;

const ordered_json* value_at(const ordered_json& json, const std::string& pointer) {
  const ordered_json::json_pointer p(pointer);
  return json.contains(p) ? &json.at(p) : nullptr;
}

/// Everything one widget needs while it is drawn.
struct Widget {
  AppContext& context;
  PanelMemory& m;
  const Setting& setting;
  const std::string& pointer;
  const ordered_json& value;
  const SettingLook& look;
  std::string label;

  bool apply(const nlohmann::json& to) { return apply_at(pointer, to); }
  /// `at`: the setting itself or a component of it.
  bool apply_at(const std::string& at, const nlohmann::json& to) {
    const bool accepted = context.change(look.edits ? look.edits(to) : std::vector<Edit>{{at, to}});
    if (accepted)
      m.typing.forgive(pointer);
    else
      m.typing.refuse(pointer, problem_text(context.problems));
    return accepted;
  }
  std::string help() const { return help_text(setting, waits_for_reset()); }
  void draw_label() const {
    // Fields of several components have no room for the unit.
    const std::string unit = setting.unit.empty() ? std::string() : " [" + pretty_unit(setting.unit) + "]";
    setting_label(label + unit, help(), setting.applies == Applies::reset, ImGui::GetContentRegionAvail().x);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - 0.75F * ImGui::GetStyle().ItemSpacing.y);
  }
  const ordered_json* opened() const { return value_at(m.opened, pointer); }
  bool waits_for_reset() const {
    if (setting.applies != Applies::reset) return false;
    const ordered_json* running = value_at(m.running, pointer);
    return running == nullptr || *running != value;
  }
};

/// Middle click: back to the value as opened. Right click: a menu.
bool restore_menu(Widget& w) {
  bool changed = false;
  const ordered_json* opened = w.opened();
  const bool differs = opened != nullptr && *opened != w.value;
  if (differs && ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) changed = w.apply(*opened);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(em(0.5F), em(0.5F)));
  if (ImGui::BeginPopupContextItem("restore")) {
    const std::string back = opened ? "Back to " + value_text(*opened, w.setting) : std::string("Back");
    if (ImGui::MenuItem(back.c_str(), "middle click", false, differs)) changed = w.apply(*opened);
    if (const auto usual = default_value(w.setting, w.value)) {
      const std::string text = "Default: " + value_text(*usual, w.setting);
      if (ImGui::MenuItem(text.c_str(), nullptr, false, *usual != w.value)) changed = w.apply(*usual);
    }
    if (w.context.scene.time.end > 0 && ImGui::MenuItem("Compare with another value…")) {
      CompareDesk& desk = compare_of(w.context);
      desk.pointer = w.pointer;
      desk.typed = w.value.is_number() ? value_text(w.value, w.setting) : std::string();
      w.context.show_plot("Compare");
    }
    if (ImGui::MenuItem("Copy for the command line"))
      ImGui::SetClipboardText(("--set '" + w.pointer + "=" + w.value.dump() + "'").c_str());
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return changed;
}

/// "Reset to apply" under a setting whose edited value the run does not use yet.
void reset_offer(Widget& w) {
  if (!w.waits_for_reset()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, warning_color());
  if (ImGui::Button("Reset to apply")) w.context.session.reset();
  ImGui::PopStyleColor();
  tooltip("This value is used from the start of a run. Click to start again with it.");
}

void refusal_line(Widget& w) {
  if (w.m.typing.refused_key == w.pointer) warning(w.m.typing.refusal);
}

bool draw_number(Widget& w) {
  const double number = w.value.is_number() ? w.value.get<double>() : 0;
  const ordered_json* opened = w.opened();
  bool changed = false;
  const NumberControl control{w.m.typing,
                              w.setting,
                              w.pointer,
                              w.label,
                              w.help(),
                              opened && opened->is_number() ? opened->get<double>() : std::nan(""),
                              w.setting.applies == Applies::reset,
                              [&] { changed |= restore_menu(w); }};
  if (const auto to = number_control(control, number)) changed |= w.apply(number_json(*to, w.setting));
  return changed;
}

bool draw_choice(Widget& w) {
  w.draw_label();
  const std::string now = w.value.is_string() ? w.value.get<std::string>() : std::string();
  bool changed = false;
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo("##choice", choice_label(w.pointer, now).c_str());
  if (!open) {
    std::string help = choice_help(w.pointer, now);
    if (!help.empty()) help += "\n\n";
    tooltip(help + w.help());
  }
  if (open) {
    for (const std::string& choice : w.setting.choices) {
      if (choice != now && !choice_offered(w.pointer, choice)) continue;
      if (ImGui::Selectable(choice_label(w.pointer, choice).c_str(), choice == now) && choice != now)
        changed = w.apply(choice);
      tooltip(choice_help(w.pointer, choice));
    }
    ImGui::EndCombo();
  }
  return restore_menu(w) || changed;
}

bool draw_flag(Widget& w) {
  bool on = w.value.is_boolean() && w.value.get<bool>();
  const bool pressed = checkbox("flag", w.label, &on);
  tooltip(w.help());
  const bool changed = pressed && w.apply(on);
  return restore_menu(w) || changed;
}

/// What an edit starts from: all digits of a number, so that none is lost.
std::string field_text(const ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number() ? plain_number(value.get<double>()) : value.dump();
}

/// One text field for a text, a number or a formula; `at` is the pointer of the component.
bool text_field(Widget& w, const std::string& at, const ordered_json& value, float width) {
  Typing& typing = w.m.typing;
  const bool mine = typing.key == at;
  std::string text = mine ? typing.text : field_text(value);
  ImGui::SetNextItemWidth(width);
  ImGui::InputText("##text", &text, ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemActive()) {
    typing.key = at;
    typing.text = text;
  }
  bool changed = false;
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    const nlohmann::json typed = typed_component(text, w.setting);
    if (typed != nlohmann::json(value)) {
      changed = w.apply_at(at, typed);
    }
  }
  if (mine && !ImGui::IsItemActive()) typing.key.clear();
  tooltip(w.help());
  return changed;
}

bool draw_components(Widget& w) {
  w.draw_label();
  if (!w.value.is_array() || w.value.empty()) return false;
  const std::size_t n = std::min<std::size_t>(w.value.size(), 3);
  const bool formulae = w.setting.kind == SettingKind::formula_vector;
  const char* const names[] = {"x", "y", "z"};
  const float space = ImGui::GetStyle().ItemInnerSpacing.x, name = em(0.9F);
  const float available = ImGui::GetContentRegionAvail().x;
  // Formulae get a line each; numbers share one.
  const float each = formulae ? available : (available - space * static_cast<float>(n - 1)) / static_cast<float>(n);
  bool changed = false;
  for (std::size_t i = 0; i < n; ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (!formulae && i > 0) ImGui::SameLine(0, space);
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", names[i]);
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + name - ImGui::CalcTextSize(names[i]).x);
    changed |= text_field(w, w.pointer + "/" + std::to_string(i), w.value[i], each - name);
    ImGui::EndGroup();
    changed |= restore_menu(w);
    ImGui::PopID();
  }
  return changed;
}

/// A check box a component.
bool draw_flags(Widget& w) {
  w.draw_label();
  if (!w.value.is_array()) return false;
  const char* const names[] = {"x", "y", "z"};
  bool changed = false;
  for (std::size_t i = 0; i < std::min<std::size_t>(w.value.size(), 3); ++i) {
    bool on = w.value[i].is_boolean() && w.value[i].get<bool>();
    if (i > 0) ImGui::SameLine(0, em(1));
    if (tick_box(names[i], &on)) changed |= w.apply_at(w.pointer + "/" + std::to_string(i), on);
    tooltip(w.help());
  }
  return changed;
}

bool draw_control(Widget& w) {
  switch (w.setting.kind) {
    case SettingKind::number:
    case SettingKind::integer:
      return draw_number(w);
    case SettingKind::choice:
      return draw_choice(w);
    case SettingKind::flag:
      return draw_flag(w);
    case SettingKind::vector:
    case SettingKind::formula_vector:
      return draw_components(w);
    case SettingKind::flag_vector:
      return draw_flags(w);
    case SettingKind::text:
    case SettingKind::formula:
      w.draw_label();
      return text_field(w, w.pointer, w.value, ImGui::GetContentRegionAvail().x) || restore_menu(w);
  }
  return false;
}

/// A frame about what has been drawn since `corner`: a lesson speaks of it.
void point_at(ImVec2 corner) {
  const float pad = em(0.3F), right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const ImVec2 low(corner.x - pad, corner.y - pad), high(right, ImGui::GetItemRectMax().y + pad);
  ImGui::GetWindowDrawList()->AddRect(low, high, ImGui::GetColorU32(accent_color()), em(0.3F), ImDrawFlags_None,
                                      em(0.14F));
  if (!ImGui::IsRectVisible(low, high)) ImGui::SetScrollHereY(0.3F);
}

}  // namespace

bool setting_widget(AppContext& context, const std::string& pointer, const SettingLook& look) {
  const Setting* setting = find_setting(pointer);
  if (setting == nullptr || !scene_uses(context.scene, pointer)) return false;
  PanelMemory& m = memory(context);
  const ordered_json* value = value_at(m.json, pointer);
  if (value == nullptr) return false;
  if (setting->kind == SettingKind::choice && setting->choices.size() < 2) return false;  // nothing to choose
  // A copy: the edit below may replace the scene, and with it the JSON that `value` points into.
  const ordered_json shown = *value;
  Widget w{context, m, *setting, pointer, shown, look, std::string(look.label.empty() ? setting->label : look.label)};
  ImGui::PushID(pointer.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool changed = draw_control(w);
  if (context.highlight == pointer) point_at(corner);
  refusal_line(w);
  reset_offer(w);
  if (!look.note.empty()) muted(look.note);
  ImGui::PopID();
  gap(0.5F);
  return changed;
}

std::string pointer_to(std::initializer_list<std::string_view> parts) {
  std::string pointer;
  for (const std::string_view part : parts) {
    pointer += '/';
    for (const char c : part) pointer += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  }
  return pointer;
}

}  // namespace pf::app
