// The study that is open: how far it is, which chart is shown, what it answers.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/memory.hpp"
#include "app/studies/describe.hpp"
#include "app/studies/pages.hpp"
#include "app/theme.hpp"
#include "app/widgets/text.hpp"
#include "core/files.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

namespace {

constexpr float wide = 40;        // em: the chart stands beside the rest
constexpr float side_width = 17;  // em

double share_of(const StudyStatus& s) {
  if (s.stage == StudyStage::reference) return s.reference_share;
  return s.size > 0 ? static_cast<double>(s.finished) / static_cast<double>(s.size) : 0;
}

std::string progress_words(const StudyStatus& s) {
  const std::string runs = std::to_string(s.size) + (s.size == 1 ? " run" : " runs");
  switch (s.stage) {
    case StudyStage::reading:
      return "Reading the study…";
    case StudyStage::reference:
      return "First a fine run to compare with: " + std::to_string(std::lround(100 * s.reference_share)) + " %";
    case StudyStage::running: {
      const std::string left = duration_words(s.seconds_left);
      return std::to_string(s.finished) + " of " + runs + (left.empty() ? "" : ", about " + left + " left");
    }
    case StudyStage::ready:
      return s.finished == 0 ? runs : std::to_string(s.finished) + " of " + runs + " done";
    default:
      return runs + " done";
  }
}

/// What is done rarely.
void draw_more(AppContext& context, StudyDesk& desk) {
  if (flow_button("More…", false)) ImGui::OpenPopup("more");
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(em(0.5F), em(0.5F)));
  if (ImGui::BeginPopup("more")) {
    const bool any = desk.results != nullptr;
    if (ImGui::MenuItem("Run all again", nullptr, false, any && !desk.status.active())) desk.runner.begin(true);
    if (ImGui::MenuItem("Save study as…", nullptr, false, any))
      ask_save_study(context, desk.results->study->name, desk.results->text);
    if (ImGui::MenuItem("Copy the path of the results", nullptr, false, any && !desk.results->folder.empty()))
      ImGui::SetClipboardText(desk.results->folder.c_str());
    if (any) tooltip(desk.results->folder.string());
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

void draw_buttons(AppContext& context, StudyDesk& desk) {
  const StudyStatus& s = desk.status;
  bool first = true;
  if (s.active()) {
    if (ImGui::Button("Cancel")) desk.runner.cancel();
    tooltip("Stops at once. Finished runs stay, and the study can be gone on with, also after the program was closed.");
    first = false;
  } else if (s.stage == StudyStage::ready) {
    push_accent_button();
    if (ImGui::Button(s.finished == 0 ? "Start" : "Go on")) desk.runner.begin();
    pop_accent_button();
    if (desk.timed()) tooltip("Runs are timed: the live view stands still meanwhile.");
    first = false;
  }
  if (flow_button("New study", first)) desk.set_up(context);
  tooltip("Set up a study of the scene as it is now. What runs goes on.");
  draw_more(context, desk);
}

void draw_progress(AppContext& context, StudyDesk& desk) {
  const StudyStatus& s = desk.status;
  if (desk.results) {
    ImGui::PushFont(bold_font());
    paragraph(desk.results->study->name.empty() ? desk.results->study->source : desk.results->study->name);
    ImGui::PopFont();
    tooltip(desk.results->study->about);
  }
  if (s.stage == StudyStage::failed) {
    warning("This study cannot be run.");
    for (const Problem& problem : s.problems) muted(to_string(problem));
  } else {
    const std::string trouble = desk.results ? trouble_words(desk.results->rows) : "";
    paragraph(progress_words(s) + (trouble.empty() ? "" : "; " + trouble));
    if (s.active() || (s.finished > 0 && s.finished < s.size)) progress_bar(share_of(s));
  }
  if (desk.holds_view()) warning("The live view stands still while runs are timed.");
  draw_buttons(context, desk);
}

std::string figure_words(const StudyFigure& figure) {
  if (figure.is_map()) return figure.label.empty() ? "Map" : figure.label;
  return figure.chart.y.title + " / " + figure.chart.x.title;
}

void draw_figure_choice(StudyDesk& desk) {
  const StudyFigure* shown = desk.shown_figure();
  if (shown == nullptr) return;
  if (desk.figures.size() > 1) {
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##figure", figure_words(*shown).c_str())) {
      for (std::size_t k = 0; k < desk.figures.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        if (ImGui::Selectable(figure_words(desk.figures[k]).c_str(), k == desk.figure)) {
          desk.figure = k;
          desk.view = {};
        }
        ImGui::PopID();
      }
      ImGui::EndCombo();
    }
  }
}

void draw_notes(const StudyDesk& desk) {
  const StudyFigure* shown = desk.shown_figure();
  if (shown != nullptr && !shown->chart.subtitle.empty()) muted(shown->chart.subtitle);
  if (!desk.results || desk.results->rows.empty() || desk.place) return;
  muted("The live scene differs from this study in other settings: it has no place in the chart.");
}

void draw_side(AppContext& context, StudyDesk& desk) {
  draw_progress(context, desk);
  draw_figure_choice(desk);
  gap(0.25F);
  if (desk.results) draw_cheapest(context, desk);
  draw_notes(desk);
}

/// In a narrow drawer chart and study take turns; a line of text tells of both, as low as can be.
void draw_switch(AppContext& context, StudyDesk& desk) {
  if (memory(context).plot_menu) ImGui::SameLine();  // beside the menu
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, accent_color());
  if (text_button(desk.show_list ? "Chart" : "Study")) desk.show_list = !desk.show_list;
  ImGui::PopStyleColor();
  tooltip(desk.show_list ? "Shows the chart." : "Shows how far it is, what it answers, and which charts there are.");
  ImGui::SameLine();
  const StudyFigure* figure = desk.shown_figure();
  const bool chart = !desk.show_list && figure != nullptr && !desk.status.active();
  const float room = ImGui::GetContentRegionAvail().x - em(2.5F);  // the drawer's arrow
  std::string words = chart ? figure_words(*figure) : progress_words(desk.status);
  const auto width = [&] { return ImGui::CalcTextSize((words + "…").c_str()).x; };
  const bool whole = ImGui::CalcTextSize(words.c_str()).x <= room;
  while (!whole && !words.empty() && width() > room) {
    while (!words.empty() && (static_cast<unsigned char>(words.back()) & 0xc0) == 0x80) words.pop_back();
    if (!words.empty()) words.pop_back();
  }
  if (words.size() > 4)
    muted(whole ? words : words + "…");
  else
    ImGui::NewLine();  // what follows stands below
}

}  // namespace

void draw_results_page(AppContext& context, StudyDesk& desk) {
  if (ImGui::GetContentRegionAvail().x >= em(wide)) {
    ImGui::BeginChild("side", ImVec2(em(side_width), 0), false, ImGuiWindowFlags_NoBackground);
    draw_side(context, desk);
    ImGui::EndChild();
    ImGui::SameLine(0, em());
    ImGui::BeginChild("chart", ImVec2(0, 0), false, ImGuiWindowFlags_NoBackground);
    draw_study_chart(context, desk);
    ImGui::EndChild();
    return;
  }
  draw_switch(context, desk);
  ImGui::BeginChild("page", ImVec2(0, 0), false, ImGuiWindowFlags_NoBackground);
  desk.show_list ? draw_side(context, desk) : draw_study_chart(context, desk);
  ImGui::EndChild();
}

}  // namespace pf::app
