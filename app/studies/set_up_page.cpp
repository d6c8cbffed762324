// Setting up a study: what kind, what is varied, how it is measured; then it begins.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/panels/memory.hpp"
#include "app/preferences.hpp"
#include "app/studies/describe.hpp"
#include "app/studies/pages.hpp"
#include "app/theme.hpp"
#include "app/widgets/number_control.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/files.hpp"
#include "core/params/problem.hpp"

namespace pf::app {

namespace {

constexpr float wide = 52;           // em: three columns stand side by side
constexpr float label_width = 6.5F;  // em

/// Begins a line "Label  [control]"; the control takes the rest of it.
void option_label(const char* label, const char* help) {
  ImGui::AlignTextToFramePadding();
  text_unformatted(label);
  tooltip(help);
  const float rest = ImGui::GetContentRegionAvail().x - em(label_width);
  if (rest >= em(8)) ImGui::SameLine(em(label_width));
  ImGui::SetNextItemWidth(-1);
}

struct Word {
  const char* value;
  const char* label;
  const char* help;
};

/// A combo over words; true when another was chosen.
bool choose(const char* id, std::string& value, std::span<const Word> words) {
  const auto now = std::find_if(words.begin(), words.end(), [&](const Word& w) { return value == w.value; });
  bool changed = false;
  const bool open = ImGui::BeginCombo(id, now != words.end() ? now->label : value.c_str());
  if (!open && now != words.end()) tooltip(now->help);
  if (!open) return false;
  for (const Word& word : words) {
    if (ImGui::Selectable(word.label, value == word.value) && value != word.value) {
      value = word.value;
      changed = true;
    }
    tooltip(word.help);
  }
  ImGui::EndCombo();
  return changed;
}

constexpr std::array costs{
    Word{"wall", "Wall time", "Seconds, each run by itself and several times: the live view stands still meanwhile."},
    Word{"work", "Counted work",
         "Visits of particles, weighted with what each kind costs. The same on every machine, and it runs beside the "
         "live view."}};
constexpr std::array measures{
    Word{"energy_change", "Energy change", "Gained or lost at the end, as a share of the energy at play."},
    Word{"energy_gained", "Energy gained", "How far the energy rose at worst, as a share of the energy at play."},
    Word{"energy_lost", "Energy lost", "How far the energy fell at worst, as a share of the energy at play."},
    Word{"stress_noise", "Stress noise", "What a smooth fit over each particle's neighbours leaves of the stress."},
    Word{"velocity_noise", "Velocity noise",
         "What a smooth fit over each particle's neighbours leaves of the velocity."},
    Word{"retries", "Steps begun again", "Steps that had to be tried again with a shorter time step."}};

/// A quantity that is clicked to be typed. True when it was changed.
bool quantity_option(AppContext& context, const char* key, const char* label, const char* unit, double most,
                     const char* help, double& value) {
  Setting setting;
  setting.unit = unit;
  setting.min = 0;
  setting.open_min = true;
  setting.max = most;
  setting.slider_min = setting.slider_max = 0;  // no slider: any value may be right
  Typing& typing = memory(context).typing;
  const std::string name = key;
  const NumberControl control{typing, setting, name, label, help, std::nan(""), false, {}};
  ImGui::PushID(key);
  const auto to = number_control(control, value);
  ImGui::PopID();
  if (typing.refused_key == name) warning(typing.refusal);
  if (to) value = *to;
  return to.has_value();
}

void draw_kind(AppContext& context, StudyDesk& desk, bool in_a_row) {
  const auto radio = [&](const char* label, StudyKind kind, const char* help) {
    if (outlined_radio(label, desk.draft.kind == kind) && desk.draft.kind != kind) desk.propose(context, kind);
    tooltip(help);
  };
  radio("Speed and accuracy", StudyKind::work_precision, "Charts each setting's error against what it costs.");
  const float needed = ImGui::GetFrameHeight() + ImGui::CalcTextSize("Stability map").x + em(2);
  if (in_a_row && ImGui::GetItemRectMax().x + needed < ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
    ImGui::SameLine(0, em(1));
  radio("Stability map", StudyKind::stability_map,
        "Two settings as axes; colour and hatching show where runs gain energy, lose it, get noisy or fail.");
}

void draw_reference(AppContext& context, StudyDesk& desk) {
  StudyDraft& draft = desk.draft;
  const bool exact = !context.scene.exact_position.empty();
  std::vector<Word> words;
  if (exact) words.push_back({"exact", "Exact motion", "The motion that the scene says is known."});
  words.push_back({"run", "A fine run", "One run with short steps (and on a finer grid where the grid is varied)."});
  if (draft.kind == StudyKind::stability_map) words.push_back({"none", "Nothing", "Errors are not measured."});
  std::string now = draft.reference == ReferenceKind::exact ? "exact"
                    : draft.reference == ReferenceKind::run ? "run"
                                                            : "none";
  option_label("Errors from", "What each run is compared with.");
  if (choose("##reference", now, words)) {
    draft.reference = now == "exact" ? ReferenceKind::exact : now == "run" ? ReferenceKind::run : ReferenceKind::none;
    desk.touched = true;
  }
  if (draft.reference == ReferenceKind::run)
    desk.touched |= quantity_option(context, "study-fine-step", "Step of the fine run", "s", 1e6,
                                    "Shorter than every step that is compared with it.", draft.fine_step);
}

void draw_measuring(AppContext& context, StudyDesk& desk) {
  StudyDraft& draft = desk.draft;
  draw_reference(context, desk);
  if (draft.kind == StudyKind::stability_map) {
    option_label("Colour", "What is measured of each run.");
    desk.touched |= choose("##measure", draft.measure, measures);
  } else {
    option_label("Cost", "How the cost of a run is told.");
    desk.touched |= choose("##cost", draft.cost, costs);
  }
  desk.touched |= quantity_option(context, "study-end", "Each run lasts", "s", 1e9,
                                  "Simulated time of every run. Shorter runs give an answer sooner.", draft.end);
}

/// How much it will be, in words.
std::string effort(const AppContext& context, const StudyDraft& draft) {
  const DraftSize size = size_of(draft, context.scene);
  std::string text = std::to_string(size.runs) + (size.runs == 1 ? " run" : " runs");
  if (draft.cost == "wall") text += ", " + std::to_string(draft.repeat) + " times each";
  const double fine = draft.reference == ReferenceKind::run ? draft.end / draft.fine_step : 0;
  if (context.status.step_ms > 0)
    text += ": roughly " + duration_words(1e-3 * context.status.step_ms * (size.steps + fine));
  return text;
}

void draw_start(AppContext& context, StudyDesk& desk) {
  const std::string problem = draft_problem(desk.draft, context.scene);
  if (!problem.empty())
    warning(problem);
  else
    muted(effort(context, desk.draft));
  ImGui::BeginDisabled(!problem.empty());
  push_accent_button();
  if (ImGui::Button("Start", ImVec2(em(5), 0))) desk.start_draft(context.scene);
  pop_accent_button();
  tooltip(desk.draft.cost == "wall" ? "Runs are timed: the live view stands still meanwhile."
                                    : "Runs beside the live view.");
  if (flow_button("Save as…", false))
    ask_save_study(context, context.scene.name + " study", study_text(desk.draft, context.scene));
  tooltip("Writes this study, its scene inside, for pushforward study or for later.");
  ImGui::EndDisabled();
  if (desk.results || desk.status.active()) {
    if (flow_button("Back", false)) desk.page = StudyDesk::Page::results;
    tooltip("To the study that is open.");
  }
}

/// What was proposed follows the scene; what the user made of it stays, as long as it is the same scene.
void follow_scene(AppContext& context, StudyDesk& desk) {
  const Scene& scene = context.scene;
  if (desk.drafted_for == scene) return;
  bool fits = desk.touched && desk.drafted_for.name == scene.name && !desk.draft.axes.empty();
  desk.variable = variable_settings(scene);
  for (const DraftAxis& axis : desk.draft.axes)
    fits = fits && std::find(desk.variable.begin(), desk.variable.end(), axis.pointer) != desk.variable.end();
  if (fits)
    desk.drafted_for = scene;
  else
    desk.propose(context, desk.draft.kind);
}

/// A column of the page; `width` 0: the rest.
void column(const char* id, float width, const std::function<void()>& content) {
  ImGui::BeginChild(id, ImVec2(width, 0), false, ImGuiWindowFlags_NoBackground);
  content();
  ImGui::EndChild();
}

}  // namespace

void ask_save_study(AppContext& context, const std::string& name, std::string text) {
  if (!context.ask_file) return;
  FileDialog::Request request;
  request.purpose = FileDialog::Purpose::save;
  request.title = "Save study";
  request.start = file_stem(name, "study") + ".json";
  request.done = [&context, text = std::move(text)](const std::filesystem::path& file) {
    try {
      write_atomically(file, text);
      context.notify("Saved " + file.string());
    } catch (const FileError& error) {
      context.notify(error.what());
    }
  };
  context.ask_file(std::move(request));
}

void draw_set_up_page(AppContext& context, StudyDesk& desk) {
  follow_scene(context, desk);
  const float width = ImGui::GetContentRegionAvail().x;
  if (width < em(wide)) {
    // What begins it comes first: the rest need not be looked at.
    column("all", 0, [&] {
      draw_kind(context, desk, true);
      draw_start(context, desk);
      draw_open_menu(context, desk, false);
      gap(0.5F);
      draw_axes(context, desk);
      gap(0.5F);
      draw_measuring(context, desk);
    });
    return;
  }
  const auto first = [&] {
    muted("Study this scene");
    draw_kind(context, desk, false);
    gap(0.5F);
    draw_open_menu(context, desk, true);
  };
  const auto last = [&] {
    draw_measuring(context, desk);
    gap(0.25F);
    draw_start(context, desk);
  };
  column("kind", em(12), first);
  ImGui::SameLine(0, em(1.5F));
  column("vary", width - em(12 + 18 + 3), [&] { draw_axes(context, desk); });
  ImGui::SameLine(0, em(1.5F));
  column("measure", em(18), last);
}

}  // namespace pf::app
