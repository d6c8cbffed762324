// The dialog that starts a record, and the mark that says that one is being made.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/record/recorder.hpp"
#include "app/theme.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/output/export.hpp"
#include "render/overlay.hpp"

namespace pf::app {

namespace {

using What = RecordChoice::What;
using Show = RecordChoice::Show;

// What is written may change while the dialog is the same.
constexpr const char *title = "Record this run###record", *lanes_title = "Record the lanes side by side###record";

template <typename T>
void radio(const char* label, T& value, T is, bool first) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize(label).x;
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (!first && ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) ImGui::SameLine();
  if (outlined_radio(label, value == is)) value = is;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace

void Recorder::draw_what(bool lanes) {
  ImGui::BeginGroup();
  radio("Pictures (PNG)", choice_.what, What::images, true);
  ImGui::SameLine();
  ImGui::BeginDisabled(!have_ffmpeg_);
  radio("Film (MP4)", choice_.what, What::film, false);
  ImGui::EndDisabled();
  ImGui::BeginDisabled(lanes);
  radio("Files of the particles", choice_.what, What::files, false);
  ImGui::EndDisabled();
  ImGui::EndGroup();
  if (lanes && choice_.what == What::files) choice_.what = What::images;
  if (lanes) muted("Files are of one run: leave the comparison for them.");
  if (!have_ffmpeg_) muted("A film needs ffmpeg, which is not on this machine. Install it, or record pictures.");
  if (!have_ffmpeg_ && choice_.what == What::film) choice_.what = What::images;
}

void Recorder::draw_picture_choices() {
  heading("Shown");
  radio("The view with its clock and colour bar", choice_.show, Show::view, true);
  radio("The view alone", choice_.show, Show::plain, false);
  radio("The whole window", choice_.show, Show::window, false);
  if (choice_.show == Show::window) return;
  if (choice_.what == What::images) {
    checkbox("transparent", "Transparent background", &choice_.transparent);
    tooltip("For slides and figures: only the material, walls and what is written are opaque.");
  }
  ImGui::SetNextItemWidth(em(12));
  if (ImGui::BeginCombo("Size", picture_sizes()[choice_.size].label)) {
    for (std::size_t k = 0; k < picture_sizes().size(); ++k)
      if (ImGui::Selectable(picture_sizes()[k].label, k == choice_.size)) choice_.size = k;
    ImGui::EndCombo();
  }
}

void Recorder::draw_schedule(const AppContext& context) {
  heading("A frame every");
  const TimeSettings& time = context.scene.time;
  bool by_time = !choice_.by_steps;
  if (outlined_radio("##time", by_time)) choice_.by_steps = false;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(em(7));
  if (ImGui::InputDouble("s of simulated time", &choice_.every.seconds, 0, 0, "%.6g")) choice_.by_steps = false;
  if (!(choice_.every.seconds > 0)) choice_.every.seconds = time.frame.value_or(time.step);
  if (outlined_radio("##steps", choice_.by_steps)) choice_.by_steps = true;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(em(7));
  int steps = static_cast<int>(choice_.every.steps);
  const bool lanes = comparing(context);
  const char* counted = lanes ? "times that the lanes share" : steps == 1 ? "time step" : "time steps";
  if (ImGui::InputInt(counted, &steps)) {
    choice_.every.steps = std::max(1, steps);
    choice_.by_steps = true;
  }
  const double least = lanes ? context.compare->status.interval : time.step;
  const double interval =
      choice_.by_steps ? static_cast<double>(choice_.every.steps) * least : std::max(choice_.every.seconds, 0.0);
  const double frames = interval > 0 ? 1 + std::floor(time.end / std::max(interval, least)) : 0;
  std::string note = "From t = 0 to the end at " + quantity(time.end, "s", 3) + ": about " + number(frames) + " frames";
  if (choice_.what == What::film) {
    gap(0.25F);
    ImGui::SetNextItemWidth(em(7));
    ImGui::InputDouble("frames a second of film", &choice_.frames_per_second, 0, 0, "%.4g");
    choice_.frames_per_second = std::clamp(choice_.frames_per_second, 1.0, 240.0);
    note += ", " + quantity(frames / choice_.frames_per_second, "s", 3) + " of film at " +
            number(interval * choice_.frames_per_second) + " times the scene's speed";
  }
  muted(note + ".");
}

void Recorder::draw_target() {
  if (choice_.what == What::files) {
    heading("Kind of file");
    ImGui::SetNextItemWidth(-1);
    const auto formats = export_formats();
    if (ImGui::BeginCombo("##format", formats[choice_.format].about.data())) {
      for (std::size_t k = 0; k < formats.size(); ++k)
        if (ImGui::Selectable(formats[k].about.data(), k == choice_.format)) choice_.format = k;
      ImGui::EndCombo();
    }
  }
  const bool film = choice_.what == What::film;
  heading(film ? "Into the file" : "Into the folder");
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##path", film ? &choice_.file : &choice_.folder);
  std::error_code error;
  if (std::filesystem::exists(path(), error))
    muted(film ? "This file is there already: it will be replaced."
               : "This folder is there already: frames with the same number will be replaced.");
}

void Recorder::draw_dialog(AppContext& context) {
  if (std::exchange(open_, false)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = std::min(em(34), 0.94F * display.x);
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, 0.94F * display.y});
  const bool lanes = comparing(context);
  if (!ImGui::BeginPopupModal(lanes ? lanes_title : title, nullptr,
                              ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_AlwaysAutoResize))
    return;
  draw_what(lanes);
  if (choice_.what != What::files) draw_picture_choices();
  draw_schedule(context);
  draw_target();
  if (!refusal_.empty()) {
    gap(0.25F);
    warning(refusal_ + ".");
  }
  gap();
  const RunState run = context.status.state;
  const bool at_end = lanes ? context.compare->status.state == CompareState::finished
                            : run == RunState::finished || run == RunState::failed;
  bool done = flow_button("Cancel", true) ||
              (!ImGui::IsWindowAppearing() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false));
  ImGui::BeginDisabled(at_end);
  if (flow_button("Record from here on", false)) done = begin(context, false);
  ImGui::EndDisabled();
  push_accent_button();
  if (flow_button("Record from the start", false)) done = begin(context, true);
  pop_accent_button();
  if (done) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void Recorder::draw_mark(AppContext& context, const Rect& view, bool hidden) {
  if (!busy() || view.empty()) return;
  const Color red = palette(context.view.theme).error;
  std::string text = std::to_string(frames_) + (frames_ == 1 ? " frame" : " frames");
  if (!on_) text = "writing the last of " + text;
  // At the lower right, or above where the colours' legend lies there.
  const bool above = legend_lies({0, 0}, {view.width / em() * base_em, view.height / em() * base_em});
  ImGui::SetNextWindowPos({view.right() - em(0.6F), above ? view.y + em(0.6F) : view.bottom() - em(0.6F)},
                          ImGuiCond_Always, {1, above ? 0.0F : 1.0F});
  // Submitted even where it is not to be seen: a click on its button must not be lost.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, hidden ? 0.001F : 1.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, em(0.4F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {em(0.7F), em(0.3F)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::Begin("recording", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
  ImGui::AlignTextToFramePadding();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({em(0.8F), em()});
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + em(0.35F), at.y + ImGui::GetFrameHeight() / 2}, em(0.34F),
                                              ImGui::GetColorU32(ImVec4(red.r, red.g, red.b, 1)), 20);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(("Recording: " + text).c_str());
  tooltip(path().string());
  if (on_) {
    ImGui::SameLine(0, em());
    if (ImGui::Button("Stop")) stop(context);
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace pf::app
