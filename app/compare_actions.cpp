// The window's part in comparing runs: keys and buttons drive all lanes, the view is theirs.
#include <imgui.h>

#include <cmath>
#include <cstdio>

#include "app/compare/desk.hpp"
#include "app/panels/memory.hpp"
#include "app/theme.hpp"
#include "app/workbench.hpp"

namespace pf::app {

void Workbench::follow_comparison() {
  if (!comparing(context_)) return;
  context_.compare->follow(context_);
  // Panels that know one run only make no sense of several.
  if (comparing(context_)) close_slow_step();
}

bool Workbench::act_on_comparison(Action action) {
  if (!comparing(context_)) return false;
  Comparison& comparison = context_.compare->comparison;
  if (recorder_.on()) {  // it leads the lanes
    if (action == Action::run_pause) recorder_.toggle_pause(context_);
    return action == Action::run_pause || action == Action::step;
  }
  switch (action) {
    case Action::run_pause:
      if (context_.compare->status.state == CompareState::running)
        comparison.pause();
      else
        comparison.run();
      return true;
    case Action::step:
      comparison.step();
      return true;
    default:
      return false;  // a reset of the run is one of the lanes, too (CompareDesk::follow)
  }
}

void Workbench::set_rate(double simulated_per_wall) {
  rate_ = simulated_per_wall;
  session_.set_rate(rate_);
  if (context_.compare) context_.compare->comparison.set_rate(rate_);
}

void Workbench::draw_lanes() {
  if (!lane_views_) lane_views_ = std::make_unique<LaneViews>();
  const CompareDesk& desk = *context_.compare;
  const float pixels = window_.pixels_per_unit(), height = static_cast<float>(window_.framebuffer_height());
  float aspect = 1;
  if (context_.snapshot) {
    const Vec3 size = scene_bounds(*context_.snapshot).size();
    aspect = static_cast<float>(size.x() / std::max(size.y(), 1e-12));
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Rect cell = lane_views_->place(layout_.view, desk.lanes.size(), aspect, {mouse.x, mouse.y});
  const auto& cells = lane_views_->cells();
  for (std::size_t k = 0; k < cells.size(); ++k)
    if (cells[k].contains(mouse.x, mouse.y)) context_.compare->under_mouse = k;
  view_->place(cell, pixels, height, lane_views_->margins(context_.scene.dimension, ImGui::GetFontSize() / base_em));
  view_->handle_mouse(context_);
  view_->aim(context_);
  lane_views_->draw(context_, desk, view_->camera(), pixels, height, ImGui::GetFontSize() / base_em);
}

void Workbench::draw_lanes_overlay() {
  if (!lane_views_ || lane_views_->cells().size() != context_.compare->lanes.size()) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const Rect& v = layout_.view;
  // Where the lanes leave a cell free.
  const std::vector<Rect>& cells = lane_views_->cells();
  if (cells.back().right() + 4 < v.right() && cells.back().y > cells.front().y + 1)
    list.AddRectFilled({cells.back().right() + 2, cells.back().y}, {v.right(), v.bottom()},
                       ImGui::GetColorU32(ImGuiCol_WindowBg));
  const ImU32 line = ImGui::GetColorU32(ImGuiCol_Border);
  for (const Rect& cell : lane_views_->cells()) {
    if (cell.right() + 4 < v.right())
      list.AddLine({cell.right() + 1, cell.y}, {cell.right() + 1, cell.bottom()}, line, 2);
    if (cell.bottom() + 4 < v.bottom())
      list.AddLine({cell.x, cell.bottom() + 1}, {cell.right(), cell.bottom() + 1}, line, 2);
  }
  lane_views_->draw_overlay(context_, *context_.compare, view_->camera(), window_.pixels_per_unit(),
                            ImGui::GetFontSize() / base_em, list);
}

Image Workbench::view_picture(const PictureRequest& request) {
  if (!comparing(context_) || !lane_views_ || !context_.compare->frame) return view_->picture(context_, request);
  return lane_views_->picture(context_, *context_.compare, *view_, request, window_.pixels_per_unit(),
                              ImGui::GetFontSize() / base_em);
}

void Workbench::draw_compare_transport() {
  const float em = ImGui::GetFontSize();
  const ComparisonStatus& s = context_.compare->status;
  const Rect& bar = layout_.transport;
  const std::string note = "Lanes go forward together; there is no way back while they are compared";
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = bar.y + layout_.time_line / 2, left = bar.x + 0.9f * em, right = bar.right() - 0.9f * em;
  list.AddRectFilled({left, y - 0.12f * em}, {right, y + 0.12f * em}, ImGui::GetColorU32(ImGuiCol_FrameBg), 0.12f * em);
  const double end = context_.scene.time.end;
  const float reached = end > 0 ? static_cast<float>(std::min(1.0, s.time / end)) : 0;
  list.AddRectFilled({left, y - 0.12f * em}, {left + reached * (right - left), y + 0.12f * em},
                     ImGui::GetColorU32(ImGuiCol_SliderGrab), 0.12f * em);
  const ImVec2 cursor = ImGui::GetCursorPos();
  ImGui::SetCursorScreenPos({left, bar.y});
  ImGui::InvisibleButton("time line", {std::max(1.0f, right - left), std::max(1.0f, layout_.time_line)});
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", note.c_str());
  ImGui::SetCursorPos(cursor);
  draw_transport_buttons();
  ImGui::SameLine();
  draw_playback_choices();
  if (layout_.transport_rows == 2) {
    const float inset = std::floor((layout_.transport_row - ImGui::GetFrameHeight()) / 2);
    ImGui::SetCursorPosY(layout_.time_line + layout_.transport_row - inset / 2);
  } else {
    ImGui::SameLine(0, em);
  }
  char text[160];
  std::snprintf(text, sizeof text, "%.4g s", s.time);
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(bold_font());
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
  ImGui::SameLine();
  std::string words = std::to_string(context_.compare->lanes.size()) + " lanes, together every ";
  std::snprintf(text, sizeof text, "%.4g s", s.interval);
  words += text;
  if (s.state == CompareState::loading)
    words = "loading…";
  else if (context_.status.suspended)
    words += " – stand still while a study is timed";
  else if (s.waits_for_reset)
    words += " – some changes need a reset (R)";
  else if (s.state == CompareState::finished)
    words += " – end reached";
  else if (recorder_.on())
    words += recorder_.paused() ? " – the record waits" : " – recorded";
  ImGui::TextDisabled("%s", words.c_str());
}

}  // namespace pf::app
