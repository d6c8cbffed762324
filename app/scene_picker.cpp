#include "app/scene_picker.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/panels/gallery.hpp"
#include "app/theme.hpp"
#include "app/widgets/text.hpp"

namespace pf::app {
namespace {

constexpr const char* title = "Find a scene";

bool key(ImGuiKey which) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(which), which != ImGuiKey_Enter && which != ImGuiKey_Escape);
}

}  // namespace

std::vector<SceneChoice> matching(const std::vector<SceneChoice>& choices, const std::string& letters) {
  std::vector<std::pair<int, std::size_t>> found;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const int score =
        std::max(2 * fuzzy_score(letters, choices[i].name), fuzzy_score(letters, choices[i].file.stem().string()));
    if (score >= 0) found.emplace_back(-score, i);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<SceneChoice> offered;
  offered.reserve(found.size());
  for (const auto& [score, i] : found) offered.push_back(choices[i]);
  return offered;
}

void ScenePicker::open(const std::filesystem::path& shipped, const std::vector<std::filesystem::path>& recent) {
  choices_.clear();
  std::error_code error;
  for (const auto& file : recent)
    if (std::filesystem::is_regular_file(file, error))
      choices_.push_back({file, file.stem().string(), file.parent_path().string()});
  for (const GalleryEntry& entry : list_scenes(shipped))
    choices_.push_back({entry.file, entry.name, entry.dimension == 3 ? "shipped, 3D" : "shipped, 2D"});
  letters_.clear();
  offered_ = choices_;
  at_ = 0;
  wanted_ = open_ = true;
}

void ScenePicker::draw_list() {
  const float room = 0.84F * ImGui::GetIO().DisplaySize.y - em(7);  // below it the button
  ImGui::BeginChild("scenes", {0, std::clamp(room, em(5), em(20))});
  gap(0.15F);  // a row's highlight reaches beyond it
  for (int i = 0; i < static_cast<int>(offered_.size()); ++i) {
    const SceneChoice& choice = offered_[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable("##choice", i == at_, ImGuiSelectableFlags_DontClosePopups)) at_ = i, pressed_ = true;
    if (i == at_ && std::exchange(follow_, false)) ImGui::SetScrollHereY();
    ImGui::SameLine(left);
    text_unformatted(choice.name);
    const float name = ImGui::CalcTextSize(choice.name.c_str()).x, place = ImGui::CalcTextSize(choice.place.c_str()).x;
    if (name + place + em(2) < width) {
      ImGui::SameLine(left + width - place - em(0.5F));
      muted(choice.place);
    }
    ImGui::PopID();
  }
  if (offered_.empty()) muted("No scene has these letters in its name.");
  ImGui::EndChild();
}

void ScenePicker::draw(const std::function<void(const std::filesystem::path&)>& chosen,
                       const std::function<void()>& browse) {
  if (std::exchange(wanted_, false)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, 0.12F * display.y}, ImGuiCond_Always, {0.5F, 0});
  ImGui::SetNextWindowSize({std::min(em(34), 0.94F * display.x), 0});
  if (!ImGui::BeginPopupModal(title, nullptr,
                              ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings)) {
    open_ = false;
    return;
  }
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (ImGui::InputTextWithHint("##letters", "Open a scene: a few letters of its name", &letters_)) {
    offered_ = matching(choices_, letters_);
    at_ = 0;
    follow_ = true;
  }
  const int last = static_cast<int>(offered_.size()) - 1;
  const int to =
      std::clamp(at_ + (key(ImGuiKey_DownArrow) ? 1 : 0) - (key(ImGuiKey_UpArrow) ? 1 : 0), 0, std::max(last, 0));
  if (to != std::exchange(at_, to)) follow_ = true;
  gap(0.25F);
  pressed_ = false;
  draw_list();
  const bool enter = !ImGui::IsWindowAppearing() && key(ImGuiKey_Enter);
  const bool other = ImGui::Button("Another file…");
  ImGui::SameLine();
  const bool cancel = ImGui::Button("Cancel") || key(ImGuiKey_Escape);
  const bool take = (enter || pressed_) && at_ <= last;
  if (take || other || cancel) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (take)
    chosen(offered_[static_cast<std::size_t>(at_)].file);
  else if (other)
    browse();
}

}  // namespace pf::app
