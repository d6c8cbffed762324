#include "app/notices.hpp"

#include <imgui.h>

#include <algorithm>

namespace pf::app {
namespace {

constexpr std::size_t most = 3;

}  // namespace

void Notices::add(const std::string& text) {
  // Long messages stay long enough to be read.
  const auto stay = std::chrono::milliseconds(2500 + 40 * static_cast<long>(std::min<std::size_t>(text.size(), 150)));
  std::erase_if(notices_, [&](const Notice& n) { return n.text == text; });
  notices_.push_back({text, Clock::now() + stay});
  if (notices_.size() > most) notices_.pop_front();
}

bool Notices::expire() {
  const auto now = Clock::now();
  return std::erase_if(notices_, [&](const Notice& n) { return n.until < now; }) > 0;
}

void Notices::draw(const Rect& view) const {
  if (notices_.empty() || view.empty()) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({view.x + view.width / 2, view.bottom() - 0.6f * em}, ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {std::min(40 * em, view.width - 2 * em), view.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.4f * em);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  const auto flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
  ImGui::Begin("notices", nullptr, flags);
  for (const Notice& notice : notices_) {
    ImGui::PushTextWrapPos(std::min(38 * em, view.width - 4 * em));
    ImGui::TextUnformatted(notice.text.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace pf::app
