#include "app/widgets/slider.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

struct Geometry {
  ImRect frame;    ///< catches the mouse
  float from, to;  ///< where the knob's centre may be
};

void paint(const Geometry& g, double position, double mark, bool hot) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float y = std::floor(g.frame.GetCenter().y) + 0.5F, half = em(0.11F);
  const auto at = [&](double p) { return g.from + (g.to - g.from) * static_cast<float>(std::clamp(p, 0.0, 1.0)); };
  const ImU32 track = ImGui::GetColorU32(ImGuiCol_Border), accent = ImGui::GetColorU32(ImGuiCol_CheckMark);
  draw.AddRectFilled(ImVec2(g.from - half, y - half), ImVec2(g.to + half, y + half), track, half);
  draw.AddRectFilled(ImVec2(g.from - half, y - half), ImVec2(at(position) + half, y + half), accent, half);
  if (mark >= 0 && mark <= 1) {
    const float x = std::round(at(mark));
    draw.AddRectFilled(ImVec2(x - em(0.04F), y - em(0.32F)), ImVec2(x + em(0.04F), y + em(0.32F)),
                       ImGui::GetColorU32(ImGuiCol_TextDisabled));
  }
  draw.AddCircleFilled(ImVec2(at(position), y), em(hot ? 0.42F : 0.36F), accent);
  draw.AddCircleFilled(ImVec2(at(position), y), em(hot ? 0.2F : 0.15F), ImGui::GetColorU32(ImGuiCol_WindowBg));
}

}  // namespace

double slider_position(double value, const SliderRange& r) {
  const double p = r.logarithmic ? std::log(std::max(value, r.min) / r.min) / std::log(r.max / r.min)
                                 : (value - r.min) / (r.max - r.min);
  return std::clamp(p, 0.0, 1.0);
}

double slider_value(double position, const SliderRange& r) {
  const double p = std::clamp(position, 0.0, 1.0);
  if (p == 0) return r.min;
  if (p == 1) return r.max;
  const double v = r.logarithmic ? r.min * std::pow(r.max / r.min, p) : r.min + (r.max - r.min) * p;
  if (r.integer) return std::round(v);
  if (r.logarithmic) return rounded(v, 3);
  const double step = std::pow(10.0, std::floor(std::log10((r.max - r.min) / 200)));
  return rounded(std::round(v / step) * step, 12);
}

SliderResult slider(const char* id, double& value, const SliderRange& range, double mark) {
  SliderResult result;
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  if (window->SkipItems) return result;
  const ImGuiID item = window->GetID(id);
  const ImVec2 size(ImGui::GetContentRegionAvail().x, em(1.0F));
  const ImRect frame(window->DC.CursorPos, ImVec2(window->DC.CursorPos.x + size.x, window->DC.CursorPos.y + size.y));
  ImGui::ItemSize(size, 0);
  if (!ImGui::ItemAdd(frame, item)) return result;
  ImGuiContext& g = *ImGui::GetCurrentContext();
  const bool hovered = ImGui::ItemHoverable(frame, item);
  const bool pressed = hovered && ImGui::IsMouseClicked(0);
  if (hovered && pressed && g.IO.KeyCtrl) result.type = true;
  if (!result.type && (pressed || g.NavActivateId == item)) {
    ImGui::SetActiveID(item, window);
    ImGui::SetFocusID(item, window);
    ImGui::FocusWindow(window);
    g.ActiveIdUsingNavDirMask |= (1 << ImGuiDir_Left) | (1 << ImGuiDir_Right);
  }
  const float inset = em(0.42F);
  const Geometry geometry{frame, frame.Min.x + inset, frame.Max.x - inset};
  if (g.ActiveId == item && g.ActiveIdSource == ImGuiInputSource_Mouse) {
    if (!g.IO.MouseDown[0]) {
      ImGui::ClearActiveID();
    } else if (g.IO.MouseDelta.x != 0 || pressed) {
      const double to = slider_value((g.IO.MousePos.x - geometry.from) / (geometry.to - geometry.from), range);
      result.changed = to != value;
      value = to;
    }
  } else if (g.ActiveId == item) {  // keyboard or gamepad
    const float move = ImGui::GetNavInputAmount2d(ImGuiNavDirSourceFlags_Keyboard | ImGuiNavDirSourceFlags_PadDPad,
                                                  ImGuiInputReadMode_RepeatFast, 0, 0)
                           .x;
    if (g.NavActivatePressedId == item && !g.ActiveIdIsJustActivated) ImGui::ClearActiveID();
    if (move != 0) {
      const double before = value;
      value = range.integer ? std::clamp(value + (move > 0 ? 1 : -1), range.min, range.max)
                            : slider_value(slider_position(value, range) + 0.01 * move, range);
      result.changed = value != before;
    }
  }
  ImGui::RenderNavHighlight(frame, item);
  paint(geometry, slider_position(value, range), std::isnan(mark) ? -1 : slider_position(mark, range),
        hovered || g.ActiveId == item);
  return result;
}

}  // namespace pf::app
