// Studies that are there already: shipped, run earlier, or in a file.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studies/pages.hpp"
#include "app/widgets/text.hpp"
#include "core/files.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

namespace {

void open_file(AppContext& context, StudyDesk& desk, const std::filesystem::path& file) {
  try {
    desk.open({read_file(file), file.string(), file.parent_path()});
  } catch (const FileError& error) {
    if (context.notify) context.notify(error.what());
  }
}

void ask_for_file(AppContext& context) {
  if (!context.ask_file) return;
  FileDialog::Request request;
  request.title = "Open study";
  request.start = context.scene_file.empty() ? std::filesystem::path() : context.scene_file.parent_path();
  request.done = [&context](const std::filesystem::path& file) { open_file(context, studies_of(context), file); };
  context.ask_file(std::move(request));
}

void list(AppContext& context, StudyDesk& desk, const char* title, const std::vector<LibraryEntry>& entries) {
  if (entries.empty()) return;
  muted(title);
  for (const LibraryEntry& entry : entries) {
    ImGui::PushID(entry.file.c_str());
    std::string label = entry.name;
    if (entry.runs > 0) label += "  –  " + std::to_string(entry.finished) + " of " + std::to_string(entry.runs);
    if (ImGui::Selectable(label.c_str())) open_file(context, desk, entry.file);
    tooltip(entry.about.empty() ? entry.file.string() : entry.about);
    ImGui::PopID();
  }
  gap(0.5F);
}

}  // namespace

void draw_open_menu(AppContext& context, StudyDesk& desk, bool first) {
  if (flow_button("Open…", first)) {
    ImGui::OpenPopup("open-study");
    desk.listed = false;
  }
  tooltip("A study that comes with the program, one that was run earlier, or a file.");
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowSizeConstraints(ImVec2(em(16), 0), ImVec2(0.9F * display.x, 0.7F * display.y));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(std::round(em(0.75F)), std::round(em(0.75F))));
  if (ImGui::BeginPopup("open-study")) {
    if (!desk.listed) {
      desk.shipped = shipped_studies();
      desk.earlier = context.study_folder.empty() ? std::vector<LibraryEntry>() : earlier_studies(context.study_folder);
      desk.listed = true;
    }
    list(context, desk, "Run earlier", desk.earlier);
    list(context, desk, "Shipped", desk.shipped);
    if (ImGui::Selectable("From a file…")) ask_for_file(context);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace pf::app
