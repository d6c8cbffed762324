#include "app/field_menu.hpp"

#include <imgui.h>

#include <string>

#include "app/theme.hpp"
#include "app/widgets/text.hpp"
#include "render/color_range.hpp"

namespace pf::app {

namespace {

/// Keys 1 to 9 choose the first ones.
std::string key_of(const FieldInfo& info) {
  const auto k = static_cast<int>(info.field) + 1;
  return k <= 9 && info.group == fields().front().group ? std::to_string(k) : "";
}

bool symmetric(const ViewState& view) {
  return color_scale(field_info(view.field), view.log_colors, view.symmetric) == ColorScale::symmetric;
}

/// The ends were chosen for another meaning.
void set_scale(ViewState& view, bool logarithmic, std::optional<bool> about_centre) {
  view.log_colors = logarithmic;
  view.symmetric = about_centre;
  view.lock_range = false;
}

std::string symmetric_label(const ViewState& view) {
  return field_info(view.field).centre == 1 ? "Symmetric about 1" : "Symmetric about 0";
}

}  // namespace

bool offers(const Scene& scene, const FieldInfo& field) {
  if (field.field == Field::error) return !scene.exact_position.empty();
  if (field.field == Field::material) return scene.materials.size() > 1;
  return scene.dimension == 3 || !field.only_in_3d;
}

void draw_field_menu(AppContext& context) {
  ViewState& view = context.view;
  std::string_view group;
  bool open = false, in_group = false;
  for (const FieldInfo& info : fields()) {
    if (info.group != group) {
      if (in_group && open) ImGui::EndMenu();
      in_group = !group.empty();
      group = info.group;
      if (in_group) open = ImGui::BeginMenu(std::string(group).c_str());
    }
    if (in_group && (!open || !offers(context.scene, info))) continue;
    if (ImGui::MenuItem(std::string(info.label).c_str(), key_of(info).c_str(), view.field == info.field,
                        offers(context.scene, info)))
      view.color_by(info.field);
  }
  if (in_group && open) ImGui::EndMenu();
  if (field_info(view.field).scale == FieldScale::categorical) return;
  ImGui::Separator();
  draw_color_scale_items(context);
}

void draw_field_box(AppContext& context) {
  ViewState& view = context.view;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (!ImGui::BeginCombo("##field", std::string(field_info(view.field).label).c_str(), ImGuiComboFlags_HeightLargest))
    return;
  std::string_view group = fields().front().group;
  for (const FieldInfo& info : fields()) {
    if (!offers(context.scene, info)) continue;
    if (info.group != group) {
      group = info.group;
      heading(std::string(group).c_str());
    }
    const std::string shortcut = key_of(info);
    ImGui::PushID(static_cast<int>(info.field));
    if (ImGui::Selectable("##choice", info.field == view.field)) view.color_by(info.field);
    ImGui::SameLine(0, 0);
    text_unformatted(info.label);
    if (!shortcut.empty()) {
      ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(shortcut.c_str()).x);
      ImGui::TextDisabled("%s", shortcut.c_str());
    }
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

void draw_color_scale_items(AppContext& context) {
  ViewState& view = context.view;
  if (ImGui::MenuItem("Automatic range", nullptr, !view.lock_range)) view.lock_range = false;
  if (ImGui::MenuItem("Logarithmic", nullptr, view.log_colors)) set_scale(view, !view.log_colors, view.symmetric);
  if (ImGui::MenuItem(symmetric_label(view).c_str(), nullptr, symmetric(view)))
    set_scale(view, false, !symmetric(view));
  ImGui::MenuItem("Histogram", nullptr, &view.show_histogram);
}

void draw_color_scale_boxes(AppContext& context) {
  ViewState& view = context.view;
  bool logarithmic = view.log_colors, about = symmetric(view);
  if (checkbox("log", "Logarithmic", &logarithmic)) set_scale(view, logarithmic, view.symmetric);
  tooltip("Equal steps of colour are equal factors, of the value's magnitude.");
  if (checkbox("symmetric", symmetric_label(view), &about)) set_scale(view, false, about);
  tooltip("Blue below, red above, grey at the middle. Without it the map goes from the smallest value to the largest.");
  checkbox("histogram", "Histogram beside the colour bar", &view.show_histogram);
}

}  // namespace pf::app
