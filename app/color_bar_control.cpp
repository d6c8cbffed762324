#include "app/color_bar_control.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/field_menu.hpp"
#include "app/imgui_painter.hpp"
#include "app/theme.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

constexpr double nearest = 0.04;  // to the end that stays: the range is not to become endless

double value_at(const ValueRange& range, double position, ColorScale scale) {
  if (scale == ColorScale::logarithmic) return range.min * std::pow(range.max / range.min, position);
  return range.min + position * (range.max - range.min);
}

/// Small triangles at the ends that somebody chose: beside a bar that stands, above one that lies.
void draw_chosen_ends(ImDrawList& list, Point2 low, Point2 high, bool lies, float em, ImU32 color) {
  const float long_side = 0.4F * em, half = 0.25F * em;
  if (lies)
    for (const float x : {low.x, high.x})
      list.AddTriangleFilled({x, low.y}, {x - half, low.y - long_side}, {x + half, low.y - long_side}, color);
  else
    for (const float y : {low.y, high.y})
      list.AddTriangleFilled({high.x, y}, {high.x + long_side, y - half}, {high.x + long_side, y + half}, color);
}

}  // namespace

ValueRange dragged(const ValueRange& range, double pressed, double now, ColorScale scale, double centre) {
  if (scale == ColorScale::logarithmic) {
    const ValueRange log{std::log(range.min), std::log(range.max)};
    const ValueRange moved = dragged(log, pressed, now, ColorScale::spread, 0);
    return {std::exp(moved.min), std::exp(moved.max)};
  }
  const double value = value_at(range, pressed, scale);
  const bool upper = pressed >= 0.5;
  if (scale == ColorScale::symmetric) {
    const double away = std::max(upper ? 2 * now - 1 : 1 - 2 * now, 2 * nearest);
    const double half = std::abs(value - centre) / away;
    return {centre - half, centre + half};
  }
  if (upper) return {range.min, range.min + (value - range.min) / std::max(now, nearest)};
  return {range.max - (range.max - value) / std::max(1 - now, nearest), range.max};
}

void ColorBarControl::draw(AppContext& context, const OverlayInfo& info, Point2 min, Point2 max, float scale,
                           ImDrawList& list) {
  ViewState& view = context.view;
  ImGuiPainter painter(list, scale);
  const auto place = color_bar_place(info, painter, min, max);
  ends_.reset();
  if (!place) {
    held_.reset();
    return;
  }
  const float em = ImGui::GetFontSize();
  const Point2 low{place->min.x * scale, place->min.y * scale}, high{place->max.x * scale, place->max.y * scale};
  const Point2 middle{0.5F * (low.x + high.x), 0.5F * (low.y + high.y)};
  const float length = place->lies ? high.x - low.x : high.y - low.y;
  if (place->lies)
    ends_ = {{high.x, middle.y}, {low.x, middle.y}};
  else
    ends_ = {{middle.x, low.y}, {middle.x, high.y}};
  const float right = (place->lies ? high.x : place->panel_max.x * scale) + (place->lies ? 0.6F * em : 0);
  const float left = low.x - (place->lies ? 0.6F : 0.3F) * em;
  ImGui::SetNextWindowPos({left, low.y - 0.6F * em});
  ImGui::SetNextWindowSize({right - left, high.y - low.y + 1.2F * em});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("colour bar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();
  ImGui::InvisibleButton("bar", ImGui::GetContentRegionAvail());
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float way = place->lies ? mouse.x - low.x : high.y - mouse.y;
  const double now = std::clamp(static_cast<double>(way / length), -0.5, 1.5);
  const FieldInfo& field = field_info(info.field);
  if (ImGui::IsItemActivated()) held_ = Held{std::clamp(now, 0.0, 1.0), info.range};
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    view.lock_range = false;
    held_.reset();
  }
  if (!ImGui::IsItemActive()) held_.reset();
  if (held_ && std::abs(now - held_->position) * static_cast<double>(length) > 2) {
    const ValueRange range = dragged(held_->range, held_->position, now, info.scale, field.centre);
    view.lock_range = true;
    view.range_min = rounded(range.min, 3);
    view.range_max = rounded(range.max, 3);
  }
  const bool hovered = ImGui::IsItemHovered();
  if (view.lock_range || hovered)
    draw_chosen_ends(list, low, high, place->lies, em,
                     ImGui::GetColorU32(view.lock_range ? accent_color() : ImGui::GetStyleColorVec4(ImGuiCol_Text)));
  if (hovered && !held_ && now >= 0 && now <= 1)
    tooltip(quantity(value_at(info.range, now, info.scale), field.unit, 3) +
            "\nDrag: another range. Double click: the automatic one. Right click: more.");
  if (ImGui::BeginPopupContextItem("colour scale")) {
    draw_color_scale_items(context);
    ImGui::EndPopup();
  }
  ImGui::End();
}

}  // namespace pf::app
