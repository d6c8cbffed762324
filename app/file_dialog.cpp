#include "app/file_dialog.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>

#include "app/theme.hpp"
#include "app/widgets/text.hpp"

namespace pf::app {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string size_text(std::uintmax_t bytes) {
  char text[32];
  if (bytes < 1000)
    std::snprintf(text, sizeof text, "%d B", static_cast<int>(bytes));
  else if (bytes < 1000'000)
    std::snprintf(text, sizeof text, "%.1f kB", static_cast<double>(bytes) / 1e3);
  else
    std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) / 1e6);
  return text;
}

std::string day_text(fs::file_time_type when) {
  const auto system = std::chrono::time_point_cast<std::chrono::system_clock::duration>(
      when - fs::file_time_type::clock::now() + std::chrono::system_clock::now());
  const std::time_t seconds = std::chrono::system_clock::to_time_t(system);
  std::tm parts{};
  char text[32] = "";
  if (localtime_r(&seconds, &parts)) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
  return text;
}

fs::path home() {
  const char* set = std::getenv("HOME");
  return set && *set ? fs::path(set) : fs::path("/");
}

}  // namespace

fs::path with_extension(fs::path name, const std::string& extension) {
  if (lower(name.extension().string()) != lower(extension)) name += extension;
  return name;
}

void FileDialog::ask(Request request) {
  request_ = std::move(request);
  std::error_code error;
  fs::path start = request_.start.empty() ? fs::current_path(error) : fs::absolute(request_.start, error);
  name_.clear();
  if (!fs::is_directory(start, error)) {
    name_ = request_.purpose == Purpose::save ? start.filename().string() : "";
    start = start.parent_path();
  }
  open_ = appear_ = focus_name_ = true;
  go_to(fs::is_directory(start, error) ? start : home());
}

void FileDialog::go_to(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::canonical(folder, error);
  if (error || !fs::is_directory(whole, error)) {
    trouble_ = folder.string() + " is no folder that can be read.";
    return;
  }
  folder_ = whole;
  folder_text_ = whole.string();
  list();
}

void FileDialog::list() {
  entries_.clear();
  trouble_.clear();
  overwrite_asked_ = false;
  std::error_code error;
  for (fs::directory_iterator it(folder_, fs::directory_options::skip_permission_denied, error), end;
       !error && it != end; it.increment(error)) {
    Entry entry;
    entry.name = it->path().filename().string();
    std::error_code each;
    entry.folder = it->is_directory(each);
    if (entry.name.starts_with('.')) continue;
    if (!entry.folder && lower(it->path().extension().string()) != request_.extension) continue;
    if (!entry.folder) entry.size = size_text(it->file_size(each));
    entry.changed = day_text(it->last_write_time(each));
    entries_.push_back(std::move(entry));
  }
  if (error) trouble_ = "This folder cannot be read: " + error.message();
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
  });
}

fs::path FileDialog::chosen() const {
  const fs::path typed = name_;
  const fs::path whole = typed.is_absolute() ? typed : folder_ / typed;
  return request_.purpose == Purpose::save ? with_extension(whole, request_.extension) : whole;
}

void FileDialog::accept() {
  if (name_.empty()) return;
  std::error_code error;
  const fs::path typed = fs::path(name_).is_absolute() ? fs::path(name_) : folder_ / name_;
  if (fs::is_directory(typed, error)) {
    name_.clear();
    return go_to(typed);
  }
  const fs::path file = chosen();
  if (request_.purpose == Purpose::open && !fs::exists(file, error)) {
    trouble_ = "There is no file " + file.filename().string() + " here.";
    return;
  }
  if (request_.purpose == Purpose::save && fs::exists(file, error) && !overwrite_asked_) {
    overwrite_asked_ = true;
    trouble_ = file.filename().string() + " exists. Press Replace to write over it.";
    return;
  }
  open_ = false;
  request_.done(file);
}

void FileDialog::draw() {
  if (!open_) return;
  const float em = ImGui::GetFontSize();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const std::string title = request_.title + "###file-dialog";
  if (std::exchange(appear_, false)) ImGui::OpenPopup(title.c_str());
  ImGui::SetNextWindowSize({std::min(46 * em, 0.94f * display.x), std::min(32 * em, 0.9f * display.y)});
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  const auto flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  if (!begin_titled_modal(title.c_str(), flags)) {
    open_ = false;
    return;
  }
  draw_path();
  const float below = 2 * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
  const float height = std::max(4 * em, ImGui::GetContentRegionAvail().y - below);
  if (display.x > 40 * em) {
    ImGui::BeginChild("places", {12 * em, height});
    draw_places();
    ImGui::EndChild();
    ImGui::SameLine();
  }
  draw_entries(height);
  draw_buttons();
  if (!open_) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void FileDialog::draw_path() {
  if (ImGui::Button("↑ Up")) go_to(folder_.parent_path());
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##folder", &folder_text_, ImGuiInputTextFlags_EnterReturnsTrue)) go_to(folder_text_);
}

void FileDialog::draw_places() {
  const auto place = [&](const std::string& label, const fs::path& folder) {
    ImGui::PushID(folder.c_str());
    if (ImGui::Selectable(label.c_str(), folder == folder_)) go_to(folder);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", folder.c_str());
    ImGui::PopID();
  };
  place("Home", home());
  for (const fs::path& folder : request_.places) place(folder.filename().string(), folder);
}

void FileDialog::draw_entries(float height) {
  const float em = ImGui::GetFontSize();
  fs::path enter;
  bool open_now = false;
  const bool wide = ImGui::GetContentRegionAvail().x > 30 * em;
  const auto flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
  if (ImGui::BeginTable("files", wide ? 3 : 1, flags, {0, height})) {
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
    if (wide) {
      ImGui::TableSetupColumn("Size", ImGuiTableColumnFlags_WidthFixed, 4.5f * em);
      ImGui::TableSetupColumn("Changed", ImGuiTableColumnFlags_WidthFixed, 9 * em);
    }
    ImGui::TableHeadersRow();
    for (const Entry& entry : entries_) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      const std::string label = entry.name + (entry.folder ? "/" : "");
      if (ImGui::Selectable(label.c_str(), entry.name == name_,
                            ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick |
                                ImGuiSelectableFlags_DontClosePopups)) {
        if (entry.folder) {
          enter = folder_ / entry.name;
        } else {
          name_ = entry.name;
          overwrite_asked_ = false;
          trouble_.clear();
          open_now = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        }
      }
      if (!wide) continue;
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", entry.size.c_str());
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", entry.changed.c_str());
    }
    ImGui::EndTable();
  }
  if (!enter.empty()) go_to(enter);
  if (open_now) accept();
}

void FileDialog::draw_buttons() {
  const float em = ImGui::GetFontSize();
  ImGui::SetNextItemWidth(-1);
  if (std::exchange(focus_name_, false)) ImGui::SetKeyboardFocusHere();
  const std::string before = name_;
  const bool entered = ImGui::InputTextWithHint("##name", "File name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
  if (name_ != before) {
    overwrite_asked_ = false;
    trouble_.clear();
  }
  if (entered) accept();
  ImGui::TextUnformatted(trouble_.empty() ? " " : trouble_.c_str());
  const char* verb = request_.purpose == Purpose::open ? "Open" : overwrite_asked_ ? "Replace" : "Save";
  const ImVec2 size{6 * em, 0};
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2 * size.x - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::Button("Cancel", size) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) open_ = false;
  ImGui::SameLine();
  ImGui::BeginDisabled(name_.empty());
  push_accent_button();
  if (ImGui::Button(verb, size)) accept();
  pop_accent_button();
  ImGui::EndDisabled();
}

}  // namespace pf::app
