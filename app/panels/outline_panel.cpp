// Outline: all that the scene is made of; what is selected, in the list or in the view, is edited below.
#include <imgui.h>

#include <algorithm>
#include <set>

#include "app/outline/items.hpp"
#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/theme.hpp"
#include "app/widgets/setting_widget.hpp"
#include "app/widgets/text.hpp"
#include "core/params/setting.hpp"

namespace pf::app {

namespace {

using nlohmann::ordered_json;

/// "+" at the right end of the line; true when pressed.
bool plus(const char* what, bool possible) {
  const float size = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - size);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::BeginDisabled(!possible);
  const bool pressed = ImGui::InvisibleButton(what, {size, size});
  ImGui::EndDisabled();
  const bool hovered = ImGui::IsItemHovered();
  const ImU32 color = hovered ? ImGui::GetColorU32(accent_color()) : ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const float r = em(0.32F), thick = em(0.12F);
  const ImVec2 c{at.x + size / 2, at.y + size / 2};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({c.x - r, c.y - thick / 2}, {c.x + r, c.y + thick / 2}, color);
  draw.AddRectFilled({c.x - thick / 2, c.y - r}, {c.x + thick / 2, c.y + r}, color);
  tooltip(std::string("Add a ") + what);
  return pressed;
}

void select(AppContext& context, const SceneItem& item) {
  context.selected_item = item;
}

void draw_group(AppContext& context, const ItemGroup& group) {
  const Scene& scene = context.scene;
  ImGui::AlignTextToFramePadding();
  muted(group.title);
  const bool possible = group.kind != ItemKind::load || !scene.bodies.empty();
  if (plus(group.singular, possible)) {
    if (edit_scene(context, added(scene, group.kind))) select(context, {group.kind, group.count(context.scene) - 1});
    return;
  }
  for (std::size_t i = 0; i < group.count(scene); ++i) {
    const SceneItem item{group.kind, i};
    const bool selected = context.selected_item == item;
    ImGui::PushID(static_cast<int>(i));
    ImGui::Indent(em(0.75F));
    std::string name = item_name(scene, item);
    if (group.kind == ItemKind::body) name += ", " + scene.bodies[i].material;
    if (ImGui::Selectable(name.c_str(), selected)) {
      if (selected)
        context.selected_item.reset();
      else
        select(context, item);
    }
    ImGui::Unindent(em(0.75F));
    ImGui::PopID();
  }
}

/// The values of a scene's objects in the JSON that have a widget, in the order of the settings' table.
void draw_fields(AppContext& context, const std::string& pointer, const std::set<std::string>& left_out) {
  const ordered_json::json_pointer at(pointer);
  const PanelMemory& m = memory(context);
  if (!m.json.contains(at)) return;
  std::vector<std::string> fields;
  for (const auto& [key, value] : m.json.at(at).items()) {
    const std::string below = pointer + pointer_to({key});
    if (!left_out.contains(key) && find_setting(below) != nullptr) fields.push_back(below);
  }
  for (const std::string& field : fields) setting_widget(context, field);
}

/// A combo of names that already stand in the scene.
void draw_name_choice(AppContext& context, const char* label, const std::string& pointer, const std::string& now,
                      const std::vector<std::string>& names) {
  muted(label);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (ImGui::BeginCombo(("##" + pointer).c_str(), now.c_str())) {
    for (const std::string& name : names)
      if (ImGui::Selectable(name.c_str(), name == now) && name != now) edit_scene(context, {{pointer, name}});
    ImGui::EndCombo();
  }
  gap(0.5F);
}

std::string shape_word(const std::string& type) {
  std::string word = type == "half_space" ? "half space" : type;
  word[0] = static_cast<char>(word[0] - 'a' + 'A');
  return word;
}

void draw_shape(AppContext& context, const SceneItem& item, const std::string& pointer) {
  const Shape* shape = item_shape(context.scene, item);
  if (!shape) return;
  const std::string at = pointer + "/" + group_of(item.kind).shape;
  heading(shape_word(shape->type).c_str());
  if (shape->type == "polygon") muted(std::to_string(shape->points.size()) + " corners");
  if (!shape->of.empty()) muted("Made of " + std::to_string(shape->of.size()) + " shapes");
  draw_fields(context, at, {"type", "points", "of", context.scene.dimension == 3 ? "rotate" : ""});
}

void draw_selected(AppContext& context) {
  const SceneItem item = *context.selected_item;
  const Scene& scene = context.scene;
  heading(item_name(scene, item).c_str());
  if (flow_button("Duplicate", true)) {
    if (edit_scene(context, doubled(scene, item)))
      select(context, {item.kind, group_of(item.kind).count(context.scene) - 1});
    return;
  }
  if (flow_button("Delete", false)) {
    if (edit_scene(context, deleted(scene, item))) context.selected_item.reset();
    return;
  }
  gap(0.5F);
  const std::string pointer = item_pointer(scene, item);
  std::set<std::string> left_out;
  if (item.kind == ItemKind::body) {
    std::vector<std::string> names;
    for (const Material& m : scene.materials) names.push_back(m.name);
    draw_name_choice(context, "Material", pointer + "/material", scene.bodies[item.index].material, names);
    left_out = {"material"};
  }
  if (item.kind == ItemKind::load) {
    std::vector<std::string> names;
    for (const Body& b : scene.bodies) names.push_back(b.name);
    draw_name_choice(context, "Body", pointer + "/body", scene.loads[item.index].body, names);
    left_out = {"body"};
  }
  draw_fields(context, pointer, left_out);
  if (context.selected_item == item && exists(context.scene, item)) draw_shape(context, item, pointer);
}

}  // namespace

void draw_outline_panel(AppContext& context) {
  if (context.selected_item && !exists(context.scene, *context.selected_item)) context.selected_item.reset();
  for (const ItemGroup& group : item_groups()) {
    ImGui::PushID(group.key);
    draw_group(context, group);
    ImGui::PopID();
  }
  if (context.status.edit.needs_reset) {
    warning("Some of this is used from the start of a run.");
    if (ImGui::Button("Reset to apply")) context.session.reset();
  }
  if (context.selected_item) draw_selected(context);
}

}  // namespace pf::app
