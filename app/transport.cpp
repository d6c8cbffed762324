// The bar under the view: run, step, reset, how fast, what at the end, and what is reached.
#include <imgui.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "app/compare/desk.hpp"
#include "app/inside/scrubber.hpp"
#include "app/step_strip.hpp"
#include "app/theme.hpp"
#include "app/workbench.hpp"

namespace pf::app {
namespace {

enum class Icon { play, pause, step, reset };

/// Drawn, not typed: no font has all four. Corners clockwise: only then are edges smoothed.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 c, float r, ImU32 color) {
  switch (icon) {
    case Icon::play:
      list.AddTriangleFilled({c.x - 0.7f * r, c.y - r}, {c.x + r, c.y}, {c.x - 0.7f * r, c.y + r}, color);
      break;
    case Icon::pause:
      list.AddRectFilled({c.x - 0.75f * r, c.y - 0.9f * r}, {c.x - 0.2f * r, c.y + 0.9f * r}, color);
      list.AddRectFilled({c.x + 0.2f * r, c.y - 0.9f * r}, {c.x + 0.75f * r, c.y + 0.9f * r}, color);
      break;
    case Icon::step:
      list.AddTriangleFilled({c.x - 0.8f * r, c.y - 0.9f * r}, {c.x + 0.5f * r, c.y}, {c.x - 0.8f * r, c.y + 0.9f * r},
                             color);
      list.AddRectFilled({c.x + 0.5f * r, c.y - 0.9f * r}, {c.x + 0.95f * r, c.y + 0.9f * r}, color);
      break;
    case Icon::reset: {
      list.PathArcTo(c, 0.8f * r, -1.1f, 3.8f, 20);
      list.PathStroke(color, ImDrawFlags_None, 0.26f * r);
      const ImVec2 tip{c.x + 0.8f * r * std::cos(-1.1f), c.y + 0.8f * r * std::sin(-1.1f)};
      list.AddTriangleFilled({tip.x - 0.75f * r, tip.y + 0.05f * r}, {tip.x + 0.15f * r, tip.y - 0.55f * r},
                             {tip.x + 0.2f * r, tip.y + 0.6f * r}, color);
      break;
    }
  }
}

bool icon_button(const char* id, Icon icon, const char* hint, bool primary, bool enabled = true) {
  const float em = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
  ImGui::BeginDisabled(!enabled);
  if (primary) push_accent_button();
  const bool pressed = ImGui::Button(id, {2.4f * em, height});
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  draw_icon(*ImGui::GetWindowDrawList(), icon, {(min.x + max.x) / 2, (min.y + max.y) / 2}, 0.36f * em,
            ImGui::GetColorU32(ImGuiCol_Text));
  if (primary) pop_accent_button();
  ImGui::EndDisabled();
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", hint);
  return pressed;
}

struct Rate {
  double value;
  const char *label, *brief;  ///< brief: where there is little room
};
constexpr std::array rates{Rate{1, "Real time", "Real time"},
                           Rate{0.5, "1/2 of real time", "1/2 speed"},
                           Rate{0.2, "1/5 of real time", "1/5 speed"},
                           Rate{0.1, "1/10 of real time", "1/10 speed"},
                           Rate{0.05, "1/20 of real time", "1/20 speed"},
                           Rate{0.02, "1/50 of real time", "1/50 speed"},
                           Rate{0.01, "1/100 of real time", "1/100 speed"},
                           Rate{0, "As fast as possible", "Fastest"}};
constexpr std::array ends{"Pause at the end", "Go on past the end", "Loop"};
constexpr std::array brief_ends{"End: pause", "End: go on", "End: loop"};

std::string hint(const KeyBinding& b) {
  return std::string(b.label) + " (" + b.shortcut + ")";
}

/// As many as tell each step from the next: 2 for 0.01 s, 3 for 1/60 s.
int clock_decimals(double dt) {
  for (int n = 0; n < 6; ++n) {
    const double last_places = dt * std::pow(10.0, n);
    if (last_places >= 10 || (last_places > 0.5 && std::abs(last_places - std::round(last_places)) < 1e-6)) return n;
  }
  return 6;
}

/// "0.98× real time", "1/51 of real time".
std::string rate_text(double rate) {
  char text[48];
  if (rate >= 0.1)
    std::snprintf(text, sizeof text, "%.*f× real time", rate < 10 ? 2 : 0, rate);
  else
    std::snprintf(text, sizeof text, "1/%.0f of real time", 1 / rate);
  return text;
}

}  // namespace

void Workbench::draw_transport() {
  const float em = ImGui::GetFontSize();
  const float row = layout_.transport_row;
  const Rect& bar = layout_.transport;
  const float inset = std::floor((row - ImGui::GetFrameHeight()) / 2);
  if (comparing(context_)) {
    ImGui::SetCursorPosY(layout_.time_line + inset);
    return draw_compare_transport();
  }
  time_line_.draw(context_, {bar.x + 0.9f * em, bar.y, bar.width - 1.8f * em, layout_.time_line});
  ImGui::SetCursorPosY(layout_.time_line + inset);
  if (context_.slow) {
    if (!draw_scrubber(context_, layout_.transport_rows == 2 ? layout_.time_line + row - inset / 2 : 0))
      close_slow_step();
    return;
  }
  draw_transport_buttons();
  ImGui::SameLine();
  draw_playback_choices();
  if (layout_.transport_rows == 2)
    ImGui::SetCursorPosY(layout_.time_line + row - inset / 2);
  else
    ImGui::SameLine(0, em);
  draw_transport_status(ImGui::GetWindowWidth() - 0.8f * em);
  if (layout_.step_strip > 0)
    draw_step_strip(context_,
                    {bar.x + 0.8f * em, bar.bottom() - layout_.step_strip, bar.width - 1.6f * em, layout_.step_strip});
}

void Workbench::draw_transport_buttons() {
  const bool compared = comparing(context_);
  const CompareState lanes = compared ? context_.compare->status.state : CompareState::closed;
  const bool led = recorder_.on() && !recorder_.paused();  // from one common time to the next
  const bool running = compared ? lanes == CompareState::running || led : context_.status.state == RunState::running;
  const bool finished = compared ? lanes == CompareState::finished : context_.status.state == RunState::finished;
  const float gap = 0.27f * ImGui::GetFontSize();
  if (icon_button("##run", running ? Icon::pause : Icon::play,
                  running    ? "Pause (Space)"
                  : finished ? "Run again (Space)"
                             : "Run (Space)",
                  true, context_.status.state != RunState::loading))
    act(Action::run_pause);
  ImGui::SameLine(0, gap);
  if (icon_button("##step", Icon::step, hint(binding(Action::step)).c_str(), false, possible(Action::step)))
    act(Action::step);
  ImGui::SameLine(0, gap);
  if (icon_button("##reset", Icon::reset, hint(binding(Action::reset)).c_str(), false)) act(Action::reset);
}

void Workbench::draw_playback_choices() {
  const float em = ImGui::GetFontSize();
  const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x;
  const bool both = room > 10 * em;  // else the speed alone
  const float width = std::min(10.5f * em, both ? room / 2 : room);
  const bool brief = width < 10 * em;
  const char* now = rates.front().label;
  for (const Rate& rate : rates)
    if (rate.value == rate_) now = brief ? rate.brief : rate.label;
  ImGui::SetNextItemWidth(width);
  if (ImGui::BeginCombo("##rate", now, ImGuiComboFlags_HeightLarge)) {
    for (const Rate& rate : rates)
      if (ImGui::Selectable(rate.label, rate.value == rate_)) set_rate(rate.value);
    ImGui::EndCombo();
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("How fast simulated time runs, if the machine keeps up");
  if (comparing(context_) || !both) return;  // lanes pause at the end
  ImGui::SameLine();
  ImGui::SetNextItemWidth(width);
  const auto end = static_cast<std::size_t>(at_end_);
  if (ImGui::BeginCombo("##at-end", brief ? brief_ends[end] : ends[end])) {
    draw_end_choices();
    ImGui::EndCombo();
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("What happens at t = %g s", context_.scene.time.end);
}

void Workbench::draw_end_choices() {
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ImGui::MenuItem(ends[i], nullptr, at_end_ == static_cast<AtEnd>(i)))
      session_.set_at_end(at_end_ = static_cast<AtEnd>(i));
}

void Workbench::draw_clock() {
  const SessionStatus& s = context_.status;
  char text[48];
  std::snprintf(text, sizeof text, "%.*f s", clock_decimals(context_.scene.time.step), s.time);
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(bold_font());
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Simulated time, of %g s", context_.scene.time.end);
  ImGui::SameLine();
}

void Workbench::draw_transport_status(float right_edge) {
  const SessionStatus& s = context_.status;
  const float em = ImGui::GetFontSize();
  draw_clock();
  char text[96];
  std::snprintf(text, sizeof text, "step %ld", s.step);
  std::string left = text, right;
  bool notable = true;
  if (s.state == RunState::loading) {
    left = "loading…";
  } else if (s.suspended) {
    left += " – stands still while a study is timed";
  } else if (s.target >= 0) {
    left += " – on the way to step " + std::to_string(s.target);
  } else if (s.edit.applies_at_step >= 0 && s.step_in_flight) {
    left += " – change applies at step " + std::to_string(s.edit.applies_at_step);
  } else if (s.edit.needs_reset) {
    left += " – some changes need a reset (R)";
  } else if (s.step < s.reached) {
    left += " of " + std::to_string(s.reached) + " – an edit goes on from here";
  } else {
    notable = false;
    if (s.state == RunState::finished) left += " – end reached";
  }
  if (s.step_ms > 0) {
    std::snprintf(text, sizeof text, s.step_ms < 10 ? "%.1f ms a step" : "%.0f ms a step", s.step_ms);
    right = text;
    if (s.state == RunState::running && s.achieved_rate > 0) right = rate_text(s.achieved_rate) + "   " + right;
  }
  const float start = ImGui::GetCursorPosX();
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(notable ? ImGuiCol_Text : ImGuiCol_TextDisabled));
  ImGui::TextUnformatted(left.c_str());
  ImGui::PopStyleColor();
  const float left_end = start + ImGui::CalcTextSize(left.c_str()).x;
  // The step says more than the speed: that goes where both do not fit, its second part first.
  for (const std::string& shown : {right, right.substr(0, right.find("   "))}) {
    const float right_start = right_edge - ImGui::CalcTextSize(shown.c_str()).x;
    if (shown.empty() || right_start < left_end + em) continue;
    ImGui::SameLine(right_start);
    ImGui::TextDisabled("%s", shown.c_str());
    break;
  }
}

}  // namespace pf::app
