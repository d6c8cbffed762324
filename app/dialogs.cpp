// Questions, problems, help.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/theme.hpp"
#include "app/widgets/text.hpp"
#include "app/workbench.hpp"
#include "core/build_info.hpp"

namespace pf::app {
namespace {

/// Opens `title` when `*wanted` says so and begins it in the middle of the window; clears `*wanted`.
bool begin_modal(const char* title, bool* wanted, float width_em, float height_em = 0) {
  if (std::exchange(*wanted, false)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize(), width = std::min(width_em * em, 0.94f * display.x);
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({width, height_em > 0 ? std::min(height_em * em, 0.9f * display.y) : 0});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, 0.92f * display.y});
  return begin_titled_modal(title,
                            ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
}

/// The key that opened a dialog does not answer it, too.
bool pressed(ImGuiKey key) {
  return !ImGui::IsWindowAppearing() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false);
}
bool escape() {
  return pressed(ImGuiKey_Escape);
}
bool enter() {
  return pressed(ImGuiKey_Enter);
}

/// Puts the cursor so that `count` buttons of `width` end at the right edge.
void align_buttons(int count, float width) {
  const float all = static_cast<float>(count) * width + static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - all));
}

bool close_button(const char* label = "Close") {
  const float width = 6 * ImGui::GetFontSize();
  align_buttons(1, width);
  push_accent_button();
  const bool clicked = ImGui::Button(label, {width, 0});
  pop_accent_button();
  return clicked || escape() || enter();
}

void wrapped(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

void labelled(const char* label, const std::string& text) {
  if (text.empty()) return;
  ImGui::TextDisabled("%s", label);
  ImGui::SameLine(5 * ImGui::GetFontSize());
  wrapped(text);
}

constexpr std::array<std::pair<const char*, const char*>, 15> mouse_rows{{
    {"Left drag", "Grab the material"},
    {"Wheel while dragging", "Radius of the grab"},
    {"Click", "Select a particle"},
    {"Ctrl+click", "Select a node of the grid"},
    {"Click with Pin", "Hold the material, let it go"},
    {"Drag with Push", "A ball pushes it aside"},
    {"Drag with Cut", "Take the material away"},
    {"Drag with Paint", "Make it another material"},
    {"Click with Probe", "Place a probe"},
    {"Left drag beside it", "2D: move, 3D: turn"},
    {"Right drag", "2D: move, 3D: turn"},
    {"Middle drag", "Move"},
    {"Wheel", "Zoom"},
    {"Ctrl+click a slider", "Type a value"},
    {"Drop a file", "Open the scene"},
}};

}  // namespace

void Workbench::draw_dialogs() {
  draw_unsaved_question();
  scene_picker_.draw([this](const std::filesystem::path& file) { load_file(file); }, [this] { browse(); });
  file_dialog_.draw();
  recorder_.draw_dialog(context_);
  draw_problems();
  draw_help();
  draw_about();
}

void Workbench::draw_unsaved_question() {
  bool ask = after_changes_ && !file_dialog_.is_open() && !ImGui::IsPopupOpen("Unsaved changes");
  if (!begin_modal("Unsaved changes", &ask, 30)) return;
  const float em = ImGui::GetFontSize();
  wrapped((context_.scene.name.empty() ? "The scene" : "“" + context_.scene.name + "”") +
          " has changes that are not saved.");
  ImGui::Dummy({0, 0.5f * em});
  const float width = 7 * em;
  align_buttons(3, width);
  if (ImGui::Button("Cancel", {width, 0}) || escape()) {
    after_changes_ = {};
    ImGui::CloseCurrentPopup();
  }
  ImGui::SameLine();
  if (ImGui::Button("Discard", {width, 0})) {
    ImGui::CloseCurrentPopup();
    context_.unsaved = false;
    std::exchange(after_changes_, {})();
  }
  ImGui::SameLine();
  push_accent_button();
  const bool save_them = ImGui::Button("Save", {width, 0}) || enter();
  pop_accent_button();
  if (save_them) {
    ImGui::CloseCurrentPopup();
    save();  // may ask for a name, and then goes on by itself
    if (!context_.unsaved && after_changes_) std::exchange(after_changes_, {})();
    if (context_.unsaved && !file_dialog_.is_open()) after_changes_ = {};
  }
  ImGui::EndPopup();
}

void Workbench::draw_problems() {
  if (!begin_modal("This did not work", &show_problems_, 44, context_.problems.size() > 4 ? 30.0f : 0.0f)) return;
  const float em = ImGui::GetFontSize();
  const bool scene_file = context_.problems_source != "file" && context_.problems_source != "the window";
  if (scene_file) {
    ImGui::PushFont(bold_font());
    wrapped(context_.problems_source);
    ImGui::PopFont();
    const std::size_t count = context_.problems.size();
    wrapped(count == 1 ? "has a problem:" : "has " + std::to_string(count) + " problems:");
  }
  const float below = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().ItemSpacing.y + 0.5f * em + 1;
  const bool scrolls = context_.problems.size() > 4;
  if (scrolls) ImGui::BeginChild("list", {0, ImGui::GetContentRegionAvail().y - below});
  for (const Problem& problem : context_.problems) {
    ImGui::Dummy({0, 0.25f * em});
    if (scene_file) {
      std::string place = problem.pointer.empty() ? "whole file" : problem.pointer;
      if (problem.line > 0) place += "  (line " + std::to_string(problem.line) + ")";
      ImGui::PushFont(bold_font());
      wrapped(place);
      ImGui::PopFont();
      labelled("Found", problem.found);
      labelled("Allowed", problem.allowed);
    } else {
      wrapped(problem.found);
    }
  }
  if (scrolls) ImGui::EndChild();
  ImGui::Dummy({0, 0.5f * em});
  if (close_button()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void Workbench::draw_help() {
  if (!begin_modal("Keys and mouse", &show_help_, 46)) return;
  const float em = ImGui::GetFontSize();
  const auto row = [](const char* key, const char* what) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted(key);
    ImGui::PopFont();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(what);
  };
  const bool beside = ImGui::GetContentRegionAvail().x > 43 * em;  // else below
  const auto part = [&](const char* id, float width, const auto& rows) {
    if (!ImGui::BeginTable(id, 2)) return;
    ImGui::TableSetupColumn("what is done", ImGuiTableColumnFlags_WidthFixed, width * em);
    rows();
    ImGui::EndTable();
  };
  const auto keys = [&] {
    for (const KeyBinding& b : key_bindings())
      if (b.key != 0) row(b.shortcut, b.label);
  };
  const auto mouse = [&] {
    for (const auto& [gesture, what] : mouse_rows) row(gesture, what);
  };
  if (beside && ImGui::BeginTable("columns", 2, ImGuiTableFlags_SizingStretchSame)) {
    ImGui::TableNextColumn();
    part("keys", 7.5f, keys);
    ImGui::TableNextColumn();
    part("mouse", 9.5f, mouse);
    ImGui::EndTable();
  } else if (!beside) {
    part("keys", 10, keys);
    ImGui::Separator();
    part("mouse", 10, mouse);
  }
  ImGui::Dummy({0, 0.5f * em});
  if (close_button()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void Workbench::draw_about() {
  if (!begin_modal("About Pushforward", &show_about_, 34)) return;
  const BuildInfo build = build_info();
  const float em = ImGui::GetFontSize();
  wrapped("A workbench for the implicit material point method.");
  ImGui::Dummy({0, 0.25f * em});
  const auto line = [](const char* label, std::string_view text) { labelled(label, std::string(text)); };
  line("Version", build.version);
  line("Commit", build.commit);
  line("Compiler", build.compiler);
  line("Flags", build.flags);
  ImGui::Dummy({0, 0.5f * em});
  if (close_button()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void Workbench::draw_failure_banner() {
  if (context_.status.state != RunState::failed || layout_.view.empty()) return;
  const float em = ImGui::GetFontSize();
  const Rect& view = layout_.view;
  const float top = tools_in_column() ? 2.4f : 3.4f;  // below the tool in hand
  ImGui::SetNextWindowPos({view.x + view.width / 2, view.y + top * em}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({std::min(40 * em, view.width - 2 * em), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.4f * em);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::Begin("failure", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  const Color c = palette(context_.view.theme).error;
  ImGui::PushFont(bold_font());
  ImGui::TextColored({c.r, c.g, c.b, 1}, "The simulation could not go on");
  ImGui::PopFont();
  wrapped(context_.status.message);
  ImGui::Dummy({0, 0.25f * em});
  if (ImGui::Button("Try again")) session_.run();
  ImGui::SameLine();
  if (ImGui::Button("Reset (R)")) act(Action::reset);
  ImGui::SameLine();
  if (ImGui::Button("One step back (←)")) act(Action::step_back);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace pf::app
