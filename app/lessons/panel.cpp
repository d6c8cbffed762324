// The page of a lesson at the right of the view, and the menu that opens one.
#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/lessons/desk.hpp"
#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/theme.hpp"
#include "app/widgets/formula_text.hpp"
#include "app/widgets/text.hpp"

namespace pf::app {

namespace {

constexpr float projector_scale = 1.6F;

void set_big(AppContext& context, LessonDesk& desk, bool big) {
  if (big && !desk.big) desk.usual_scale = context.view.ui_scale;
  desk.big = big;
  context.view.ui_scale = std::min(largest_scale, desk.usual_scale * (big ? projector_scale : 1));
}

/// True when the lesson was closed.
bool draw_head(AppContext& context, LessonDesk& desk) {
  muted(desk.lesson().title + ", " + std::to_string(desk.page_index() + 1) + " of " +
        std::to_string(desk.lesson().pages.size()));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = em(0.2F);
  const auto share = static_cast<float>(desk.page_index() + 1) / static_cast<float>(desk.lesson().pages.size());
  list.AddRectFilled(at, ImVec2(at.x + width, at.y + height), ImGui::GetColorU32(ImGuiCol_FrameBg), height / 2);
  list.AddRectFilled(at, ImVec2(at.x + share * width, at.y + height), ImGui::GetColorU32(accent_color()), height / 2);
  ImGui::Dummy(ImVec2(width, height));
  bool big = desk.big;
  if (tick_box("Large text", &big)) set_big(context, desk, big);
  tooltip("For a projector.");
  const float close = ImGui::CalcTextSize("Close").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - close);
  return ImGui::Button("Close##lesson");
}

/// A line with a mark: done, or still to do.
void to_do(bool done, const std::string& text) {
  const ImVec4 color = done ? accent_color() : ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 middle(at.x + em(0.4F), at.y + em(0.65F));
  if (done) {  // no shipped font has a tick
    const ImVec2 tick[] = {ImVec2(middle.x - em(0.32F), middle.y), ImVec2(middle.x - em(0.08F), middle.y + em(0.26F)),
                           ImVec2(middle.x + em(0.36F), middle.y - em(0.32F))};
    list.AddPolyline(tick, 3, ImGui::GetColorU32(color), ImDrawFlags_None, em(0.14F));
  } else {
    list.AddCircle(middle, em(0.3F), ImGui::GetColorU32(color), 0, em(0.1F));
  }
  ImGui::Indent(em(1.2F));
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos(0);
  text_unformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::Unindent(em(1.2F));
}

void draw_tasks(AppContext& context, LessonDesk& desk) {
  const LessonPage& page = desk.page();
  const bool any = !page.task.empty() || page.slow || !page.until.empty();
  if (!any) return;
  gap(0.5F);
  if (!page.task.empty()) {
    to_do(desk.task_done(context), "Set the marked control as the text says.");
    if (context.status.edit.needs_reset) muted("It takes effect with a reset: press R.");
  }
  if (page.slow) to_do(desk.taken_apart(), "Take a step apart: press T.");
  if (!page.until.empty()) to_do(desk.seen(), desk.filled(page.say));
  const bool all = desk.task_done(context) && desk.taken_apart() && desk.seen();
  if (all) return;
  const bool runs = context.status.state == RunState::running;
  if (ImGui::Button(runs ? "Running" : "Do it for me")) desk.help(context);
}

void draw_question(LessonDesk& desk) {
  if (!desk.page().question) return;
  const LessonQuestion& q = *desk.page().question;
  gap(0.5F);
  ImGui::PushFont(bold_font());
  paragraph(desk.filled(q.text));
  ImGui::PopFont();
  for (std::size_t k = 0; k < q.choices.size(); ++k) {
    ImGui::PushID(static_cast<int>(k));
    ImGui::BeginGroup();
    const bool chosen = desk.answer_ == k;
    if (outlined_radio("##choice", chosen)) desk.answer_ = k;
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    paragraph(q.choices[k]);
    ImGui::EndGroup();
    if (ImGui::IsItemClicked()) desk.answer_ = k;
    ImGui::PopID();
  }
  if (!desk.answer_) return;
  gap(0.25F);
  const bool right = *desk.answer_ == q.answer;
  const std::string reply = desk.filled(q.replies[*desk.answer_]);
  if (right)
    to_do(true, reply);
  else
    warning(reply);
}

void draw_feet(AppContext& context, LessonDesk& desk) {
  gap(0.75F);
  const bool done = desk.done(context);
  ImGui::BeginDisabled(desk.page_index() == 0);
  if (ImGui::Button("Back")) desk.turn_to(context, desk.page_index() - 1);
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (desk.last()) {
    if (done) push_accent_button();
    const bool finished = ImGui::Button("Finish");
    if (done) pop_accent_button();
    if (finished) close_lesson(context);
    return;
  }
  if (done) {
    push_accent_button();
    const bool next = ImGui::Button("Next");
    pop_accent_button();
    if (next) desk.turn_to(context, desk.page_index() + 1);
  } else if (ImGui::Button("Skip")) {
    desk.turn_to(context, desk.page_index() + 1);
  }
}

}  // namespace

void draw_lesson_panel(AppContext& context) {
  if (!context.lesson) return;
  const std::shared_ptr<LessonDesk> desk = context.lesson;  // kept while a button closes it
  if (draw_head(context, *desk)) return close_lesson(context);
  gap(0.25F);
  ImGui::PushFont(bold_font());
  paragraph(desk->page().title);
  ImGui::PopFont();
  for (const LessonLine& line : desk->page().lines) {
    if (line.formula)
      formula_text(line.text, 1.25F);
    else
      paragraph(desk->filled(line.text));
  }
  draw_tasks(context, *desk);
  draw_question(*desk);
  draw_feet(context, *desk);
}

void draw_lesson_menu(AppContext& context) {
  PanelMemory& m = memory(context);
  if (!m.lessons) m.lessons = std::make_shared<const std::vector<Lesson>>(shipped_lessons());
  for (const Lesson& lesson : *m.lessons) {
    const bool open = context.lesson && context.lesson->lesson().file == lesson.file;
    const std::string minutes = std::to_string(lesson.minutes) + " min";
    const std::string indent = lesson.order < 10 ? "  " : "";  // the titles stand below one another
    const std::string label = indent + std::to_string(lesson.order) + "  " + lesson.title, about = lesson.about;
    if (ImGui::MenuItem(label.c_str(), minutes.c_str(), open)) open_lesson(context, lesson);
    tooltip(about);
  }
  if (context.lesson && ImGui::MenuItem("Close the lesson")) close_lesson(context);
}

}  // namespace pf::app
