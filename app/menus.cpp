// The menu bar; every item says its key.
#include <imgui.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "app/compare/desk.hpp"
#include "app/field_menu.hpp"
#include "app/lessons/desk.hpp"
#include "app/studies/desk.hpp"
#include "app/theme.hpp"
#include "app/workbench.hpp"

namespace pf::app {

void Workbench::menu_item(Action action, bool checked) {
  const KeyBinding& b = binding(action);
  if (ImGui::MenuItem(b.label, b.shortcut, checked, possible(action))) act(action);
}

void Workbench::draw_menus() {
  if (!ImGui::BeginMainMenuBar()) return;
  menu_height_ = ImGui::GetWindowHeight();
  if (ImGui::BeginMenu("File")) {
    draw_file_menu();
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Edit")) {
    menu_item(Action::undo);
    menu_item(Action::redo);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Run")) {
    draw_run_menu();
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("View")) {
    draw_view_menu();
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Help")) {
    if (ImGui::BeginMenu("Lessons")) {
      draw_lesson_menu(context_);
      ImGui::EndMenu();
    }
    menu_item(Action::help);
    if (ImGui::MenuItem("About Pushforward")) show_about_ = true;
    ImGui::EndMenu();
  }
  // The document at the right, where it cannot meet the menus.
  const std::string label = file_label();
  const float em = ImGui::GetFontSize();
  const float width = ImGui::CalcTextSize(label.c_str()).x;
  const float x = ImGui::GetWindowWidth() - width - em;
  if (x > ImGui::GetCursorPosX() + em) {
    ImGui::SetCursorPosX(x);
    ImGui::TextDisabled("%s", label.c_str());
  }
  ImGui::EndMainMenuBar();
}

std::string Workbench::file_label() const {
  std::string name = context_.scene_file.empty() ? "not saved yet" : context_.scene_file.filename().string();
  if (context_.unsaved) name += context_.scene_file.empty() ? "" : " – changed";
  return name;
}

void Workbench::draw_file_menu() {
  menu_item(Action::open);
  if (ImGui::BeginMenu("Open recent", !preferences_.recent.empty())) {
    const auto recent = preferences_.recent;  // opening one changes the list
    for (const auto& file : recent) {
      ImGui::PushID(file.c_str());
      if (ImGui::MenuItem(file.filename().c_str())) open_file(file);
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", file.c_str());
      ImGui::PopID();
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  menu_item(Action::save);
  menu_item(Action::save_as);
  menu_item(Action::save_recording);
  ImGui::Separator();
  menu_item(Action::picture);
  menu_item(Action::export_picture);
  menu_item(Action::picture_window);
  menu_item(Action::picture_bare);
  ImGui::Separator();
  if (recorder_.on()) {
    if (ImGui::MenuItem("Stop recording", binding(Action::record).shortcut)) act(Action::record);
  } else {
    menu_item(Action::record);
  }
  ImGui::Separator();
  menu_item(Action::quit);
}

void Workbench::draw_run_menu() {
  menu_item(Action::run_pause);
  menu_item(Action::step);
  menu_item(Action::slow_step, context_.slow != nullptr);
  menu_item(Action::reset);
  ImGui::Separator();
  menu_item(Action::step_back);
  menu_item(Action::bad_step);
  menu_item(Action::branch);
  draw_rewind_memory_menu();
  if (ImGui::BeginMenu("At the end of the time")) {
    draw_end_choices();
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Compare runs…")) context_.show_plot("Compare");
  if (ImGui::MenuItem("Study this scene…")) {
    studies_of(context_).set_up(context_);
    show_studies();
  }
  if (ImGui::MenuItem("Pin this run's curves", nullptr, false, !context_.current.reports.empty())) pin();
}

void Workbench::draw_rewind_memory_menu() {
  if (!ImGui::BeginMenu("Memory for going back")) return;
  constexpr std::array choices{0, 128, 512, 2048, 8192};
  for (const int megabytes : choices) {
    const std::string label = megabytes == 0     ? "None: go back by simulating from the start"
                              : megabytes < 1024 ? std::to_string(megabytes) + " MB"
                                                 : std::to_string(megabytes / 1024) + " GB";
    if (!ImGui::MenuItem(label.c_str(), nullptr, preferences_.rewind_megabytes == megabytes)) continue;
    preferences_.rewind_megabytes = megabytes;
    session_.set_rewind_memory(static_cast<std::size_t>(megabytes) << 20);
    keep_preferences();
  }
  ImGui::Separator();
  ImGui::TextDisabled("%.1f MB in use", static_cast<double>(context_.status.rewind_bytes) / (1 << 20));
  ImGui::EndMenu();
}

void Workbench::draw_view_menu() {
  ViewState& view = context_.view;
  menu_item(Action::fit);
  if (ImGui::BeginMenu("Colour by")) {
    const Field before = view.field;
    draw_field_menu(context_);
    if (view.field != before && context_.compare) context_.compare->difference = false;
    ImGui::EndMenu();
  }
  ImGui::Separator();
  menu_item(Action::grid, view.show_grid);
  menu_item(Action::vectors, view.show_velocities);
  menu_item(Action::crosses, view.show_crosses);
  menu_item(Action::bent_grid, view.show_bent_grid);
  menu_item(Action::shapes, view.show_shapes);
  ImGui::Separator();
  menu_item(Action::hide_panels, view.hide_panels);
  menu_item(Action::full_screen, window_.full_screen());
  if (ImGui::BeginMenu("Theme")) {
    if (ImGui::MenuItem("Dark", nullptr, view.theme == Theme::dark)) view.theme = Theme::dark;
    if (ImGui::MenuItem("Light", nullptr, view.theme == Theme::light)) view.theme = Theme::light;
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Size of text and controls")) {
    for (const int percent : {75, 100, 125, 150, 175, 200, 250, 300}) {
      char label[16];
      std::snprintf(label, sizeof label, "%d %%", percent);
      const float scale = static_cast<float>(percent) / 100;
      if (ImGui::MenuItem(label, nullptr, std::abs(view.ui_scale - scale) < 0.005f)) view.ui_scale = scale;
    }
    ImGui::EndMenu();
  }
}

}  // namespace pf::app
