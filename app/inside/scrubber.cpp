#include "app/inside/scrubber.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/inside/step_player.hpp"
#include "app/theme.hpp"
#include "app/widgets/text.hpp"

namespace pf::app {

namespace {

/// Phases as a bar of segments, as long as they take; the words of those that have room.
void draw_segments(StepPlayer& player, float width) {
  const float height = ImGui::GetFrameHeight(), between = em(0.15F);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("phases", ImVec2(width, height));
  double all = 0;
  for (const Phase& p : player.phases()) all += p.seconds;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool held = ImGui::IsItemActive();
  const float mouse = ImGui::GetIO().MousePos.x;
  float x = at.x;
  for (std::size_t k = 0; k < player.phases().size(); ++k) {
    const Phase& p = player.phases()[k];
    const float w = width * static_cast<float>(p.seconds / all);
    const ImVec2 low(x, at.y), high(x + w - between, at.y + height);
    const double done = std::clamp(player.position() - static_cast<double>(k), 0.0, 1.0);
    const bool current = k == player.phase_index(), hovered = ImGui::IsItemHovered() && mouse >= x && mouse < x + w;
    list.AddRectFilled(low, high, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), em(0.25F));
    if (done > 0)
      list.AddRectFilled(low, ImVec2(low.x + (high.x - low.x) * static_cast<float>(done), high.y),
                         ImGui::GetColorU32(ImGuiCol_SliderGrab, current ? 0.55F : 0.25F), em(0.25F));
    const std::string words[] = {p.brief, p.kind == PhaseKind::iterate ? std::to_string(p.iterate) : std::string()};
    for (const std::string& word : words) {
      const ImVec2 size = ImGui::CalcTextSize(word.c_str());
      if (word.empty() || size.x + em(0.6F) > w) continue;
      list.AddText(ImVec2(low.x + (high.x - low.x - size.x) / 2, low.y + (height - size.y) / 2),
                   ImGui::GetColorU32(ImGuiCol_Text), word.c_str());
      break;
    }
    if (hovered && !held) ImGui::SetTooltip("%s", p.title.c_str());
    if (held && mouse >= x && (mouse < x + w || k + 1 == player.phases().size())) {
      player.playing = false;
      player.seek(static_cast<double>(k) +
                  static_cast<double>(std::clamp((mouse - x) / std::max(1.0F, w), 0.0F, 1.0F)));
    }
    x += w;
  }
}

void choose_speed(StepPlayer& player) {
  constexpr std::array speeds{0.25, 0.5, 1.0, 2.0, 4.0};
  constexpr std::array labels{"1/4 speed", "1/2 speed", "Speed 1", "2 times", "4 times"};
  std::size_t shown = 2;
  for (std::size_t k = 0; k < speeds.size(); ++k)
    if (speeds[k] == player.speed) shown = k;
  ImGui::SetNextItemWidth(em(6.6F));
  if (!ImGui::BeginCombo("##speed", labels[shown])) return;
  for (std::size_t k = 0; k < speeds.size(); ++k)
    if (ImGui::Selectable(labels[k], k == shown)) player.speed = speeds[k];
  ImGui::EndCombo();
}

/// How much larger than life motions are drawn.
void choose_magnification(StepPlayer& player) {
  char label[32];
  std::snprintf(label, sizeof label, "Motion %g\xc3\x97", player.magnification());
  ImGui::SetNextItemWidth(em(8));
  if (!ImGui::BeginCombo("##magnification", label)) return;
  for (const double times : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    std::snprintf(label, sizeof label, "%g\xc3\x97", times);
    if (ImGui::Selectable(label, times == player.magnification())) player.set_magnification(times);
  }
  ImGui::EndCombo();
}

}  // namespace

bool draw_scrubber(AppContext& context, float below) {
  StepPlayer& player = *context.slow;
  push_accent_button();
  if (ImGui::Button(player.playing ? "Pause" : player.at_end() ? "Again" : "Play", ImVec2(em(4.4F), 0))) {
    if (player.at_end()) player.seek(0);
    player.playing = !player.playing;
  }
  pop_accent_button();
  ImGui::SameLine();
  if (ImGui::Button("Next step")) context.session.take_apart();
  tooltip("Takes the next step apart (T).");
  ImGui::SameLine();
  const float right = ImGui::CalcTextSize("Close").x + 2 * ImGui::GetStyle().FramePadding.x;
  const bool roomy = ImGui::GetContentRegionAvail().x > em(44);
  const float combos = roomy ? em(6.6F) + em(8) + 2 * ImGui::GetStyle().ItemSpacing.x : 0;
  const float width = ImGui::GetContentRegionAvail().x - right - combos - ImGui::GetStyle().ItemSpacing.x;
  draw_segments(player, std::max(em(6), width));
  ImGui::SameLine();
  if (roomy) {
    choose_speed(player);
    ImGui::SameLine();
    choose_magnification(player);
    ImGui::SameLine();
  }
  const bool closed = ImGui::Button("Close");
  if (!roomy && below > 0) {
    ImGui::SetCursorPosY(below);
    choose_speed(player);
    ImGui::SameLine();
    choose_magnification(player);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const Phase& now = player.phases()[player.phase_index()];
    const std::string brief = now.kind == PhaseKind::iterate ? "iterate " + std::to_string(now.iterate) : now.brief;
    ImGui::TextDisabled("Step %ld%s%s", player.record().step, brief.empty() ? "" : ": ", brief.c_str());
  }
  return !closed;
}

}  // namespace pf::app
