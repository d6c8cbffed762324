// Compare: runs of this scene side by side; what sets them apart, what it costs and what it changes.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "app/compare/desk.hpp"
#include "app/compare/followed.hpp"
#include "app/panels/panels.hpp"
#include "app/panels/series.hpp"
#include "app/preferences.hpp"
#include "app/studies/describe.hpp"
#include "app/studies/draft.hpp"
#include "app/studies/values.hpp"
#include "app/theme.hpp"
#include "app/widgets/choices.hpp"
#include "app/widgets/plot.hpp"
#include "app/widgets/setting_help.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/charts/theme.hpp"
#include "core/files.hpp"

namespace pf::app {

namespace {

using nlohmann::json;

struct Metric {
  const char *name, *unit;
  std::vector<double> LaneCurves::*values;
  std::vector<double> LaneCurves::*times = &LaneCurves::time;
};
const std::array metrics{
    Metric{"Total energy", "J", &LaneCurves::total},
    Metric{"Kinetic energy", "J", &LaneCurves::kinetic},
    Metric{"Elastic energy", "J", &LaneCurves::elastic},
    Metric{"Momentum", "kg m/s", &LaneCurves::momentum},
    Metric{"Newton iterations a step", "", &LaneCurves::iterations, &LaneCurves::step_time},
    Metric{"Wall time a step", "ms", &LaneCurves::wall_ms, &LaneCurves::step_time},
    Metric{"Time step", "s", &LaneCurves::dt, &LaneCurves::step_time},
    Metric{"Distance from lane 1 (rms)", "m", &LaneCurves::rms, &LaneCurves::distance_time},
    Metric{"Distance from lane 1 (largest)", "m", &LaneCurves::max, &LaneCurves::distance_time},
};

constexpr float both = 48;  // em: table and plot stand side by side

double mean(const std::vector<double>& values) {
  return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

json value_now(const Scene& scene, const std::string& pointer) {
  const nlohmann::ordered_json::json_pointer at(pointer);
  const nlohmann::ordered_json all = to_json(scene);
  return all.contains(at) ? json(all.at(at)) : json();
}

void list_settings(AppContext& context, CompareDesk& desk) {
  if (!desk.variable.empty() && desk.listed_for == context.scene) return;
  desk.listed_for = context.scene;
  desk.variable = variable_settings(context.scene);
  if (std::find(desk.variable.begin(), desk.variable.end(), desk.pointer) == desk.variable.end()) desk.pointer.clear();
}

void choose_setting(AppContext& context, CompareDesk& desk) {
  const std::string now = desk.pointer.empty() ? "Change…" : setting_title(context.scene, desk.pointer);
  if (!ImGui::BeginCombo("##setting", now.c_str(), ImGuiComboFlags_HeightLarge)) return;
  for (const std::string& pointer : desk.variable) {
    ImGui::PushID(pointer.c_str());
    if (ImGui::Selectable(setting_title(context.scene, pointer).c_str(), pointer == desk.pointer)) {
      desk.pointer = pointer;
      const Setting* setting = find_setting(pointer);
      const json value = value_now(context.scene, pointer);
      desk.typed = setting && value.is_number() ? value_text(value, *setting) : std::string();
      desk.refusal.clear();
    }
    if (const Setting* setting = find_setting(pointer)) tooltip(setting->help);
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

/// Words of a choice, one click each; a number is typed.
void choose_value(AppContext& context, CompareDesk& desk) {
  const Setting* setting = find_setting(desk.pointer);
  if (setting == nullptr) return;
  if (setting->kind == SettingKind::choice || setting->kind == SettingKind::flag) {
    if (!ImGui::BeginCombo("##value", "to…")) return;
    const json now = value_now(context.scene, desk.pointer);
    std::vector<json> all{false, true};
    if (setting->kind == SettingKind::choice) all.assign(setting->choices.begin(), setting->choices.end());
    for (const json& value : all) {
      const std::string label = value.is_string()   ? choice_label(desk.pointer, value.get<std::string>())
                                : value.get<bool>() ? "on"
                                                    : "off";
      if (ImGui::Selectable(label.c_str(), value == now)) desk.add(context, desk.pointer, value);
      if (value.is_string()) tooltip(choice_help(desk.pointer, value.get<std::string>()));
    }
    ImGui::EndCombo();
    return;
  }
  const bool entered = ImGui::InputText("##value", &desk.typed,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  tooltip("The lane's value, with or without a unit. Allowed: " + range_text(*setting) + ".");
  ImGui::SameLine(0, em(0.4F));
  if (!ImGui::Button("Add lane") && !entered) return;
  desk.refusal.clear();
  const std::vector<json> values = typed_values(desk.typed, *setting, {}, desk.refusal);
  if (!values.empty() && desk.refusal.empty()) desk.add(context, desk.pointer, values.front());
}

/// What the next lane is: proposals of one click, or a setting and a value.
void draw_next(AppContext& context, CompareDesk& desk) {
  list_settings(context, desk);
  const float room = ImGui::GetContentRegionAvail().x;
  muted(desk.active() ? "One more lane, with one thing changed:" : "A lane beside this run, with one thing changed:");
  bool first = true;
  for (const LaneProposal& p : desk.proposals(context.scene)) {
    const std::string label = CompareDesk::name_of(context.scene, p.pointer, p.value);
    if (flow_button(label.c_str(), first)) desk.add(context, p.pointer, p.value);
    first = false;
    tooltip(setting_title(context.scene, p.pointer) + " changed, all else as it is.");
  }
  const bool one_line = room > em(24);
  const float width = one_line ? std::min(em(12), 0.45F * room) : room;
  ImGui::SetNextItemWidth(width);
  choose_setting(context, desk);
  if (!desk.pointer.empty()) {
    if (one_line) ImGui::SameLine(0, em(0.4F));
    ImGui::SetNextItemWidth(std::min(em(8), one_line ? 0.3F * room : 0.5F * room));
    choose_value(context, desk);
  }
  if (desk.lanes.size() > 2 || desk.from > 0) {
    ImGui::SetNextItemWidth(width);
    const std::size_t from = std::min(desk.from, desk.lanes.size() - 1);
    if (ImGui::BeginCombo("of what it starts from", desk.lanes[from].name.c_str())) {
      for (std::size_t k = 0; k < desk.lanes.size(); ++k)
        if (ImGui::Selectable((std::to_string(k + 1) + "  " + desk.lanes[k].name).c_str(), k == from)) desk.from = k;
      ImGui::EndCombo();
    }
  }
}

void save_lane(AppContext& context, const LaneSpec& lane) {
  try {
    const Scene scene = CompareDesk::scene_of(context, lane);
    FileDialog::Request request;
    request.purpose = FileDialog::Purpose::save;
    request.title = "Save the lane's scene";
    request.start = context.save_folder / (file_stem(context.scene.name + " " + lane.name, "lane") + ".json");
    request.done = [scene, notify = context.notify](const std::filesystem::path& file) {
      try {
        save_scene(scene, file);
        notify("Saved " + file.string());
      } catch (const FileError& error) {
        notify(error.what());
      }
    };
    context.ask_file(std::move(request));
  } catch (const InputError& error) {
    context.notify(problem_text(error.problems()));
  }
}

/// The lane's number in its colour; a click opens what can be done with it. True: remove it.
bool lane_cell(AppContext& context, CompareDesk& desk, std::size_t k) {
  const ChartTheme theme = context.view.theme == Theme::dark ? dark_theme() : light_theme();
  const Color c = theme.series[k];
  bool remove = false;
  ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(c.r, c.g, c.b, c.a));
  ImGui::PushFont(bold_font());
  ImGui::Text("%zu", k + 1);
  ImGui::PopFont();
  ImGui::PopStyleColor();
  ImGui::SameLine(0, em(0.5F));
  if (ImGui::Selectable(desk.lanes[k].name.c_str(), false, ImGuiSelectableFlags_SpanAllColumns))
    ImGui::OpenPopup("lane");
  tooltip(desk.lanes[k].name + "\n\nClick: save its scene, take its settings, remove it.");
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(em(0.5F), em(0.5F)));
  if (ImGui::BeginPopup("lane")) {
    if (ImGui::MenuItem("Save this lane's scene as…")) save_lane(context, desk.lanes[k]);
    if (ImGui::MenuItem("Go on with these settings", nullptr, false, !desk.lanes[k].edits.empty())) {
      const std::vector<Edit> edits = desk.lanes[k].edits;
      desk.close(context);
      if (context.change(edits) && context.status.edit.needs_reset) context.session.reset();
      ImGui::EndPopup();
      ImGui::PopStyleVar();
      return false;
    }
    remove = ImGui::MenuItem("Remove this lane");
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return remove;
}

void number_cell(const std::string& text, const char* help) {
  ImGui::TableNextColumn();
  const float left = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (left > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + left);
  text_unformatted(text);
  if (help) tooltip(help);
}

/// What the table says of a lane; the first that goes where there is little room has the highest number.
struct Column {
  const char *head, *help;
  float room;  ///< least width of the table that has room for it [em]
  std::string (*text)(const CompareDesk&, std::size_t);
};
// clang-format off
const std::array columns{
    Column{"Energy", "Total energy now.", 30, [](const CompareDesk& d, std::size_t k) {
             return newest(d.curves[k].total, "J"); }},
    Column{"Change", "Of the total energy since the start.", 22, [](const CompareDesk& d, std::size_t k) {
             const auto& E = d.curves[k].total;
             return E.empty() ? "" : quantity(E.back() - E.front(), "J", 3); }},
    Column{"|p|", "Size of the momentum [kg m/s].", 34, [](const CompareDesk& d, std::size_t k) {
             const auto& p = d.curves[k].momentum;
             return p.empty() ? "" : quantity(p.back(), "", 3); }},
    Column{"It.", "Newton iterations a step, on average.", 26, [](const CompareDesk& d, std::size_t k) {
             return d.curves[k].iterations.empty() ? "" : quantity(mean(d.curves[k].iterations), "", 3); }},
    Column{"ms/step", "Wall time a step, on average; lanes are computed one after the other.", 0,
           [](const CompareDesk& d, std::size_t k) {
             return d.curves[k].wall_ms.empty() ? "" : quantity(mean(d.curves[k].wall_ms), "", 3); }},
    Column{"Distance", "Of its particles from those of lane 1, rms over the volume; a dash: it has other particles.", 0,
           [](const CompareDesk& d, std::size_t k) -> std::string {
             if (k == 0 || !d.frame || k >= d.frame->lanes.size()) return "";
             const auto& apart = d.frame->lanes[k].distance;
             return apart ? quantity(apart->rms, "m", 3) : "\u2013"; }}};
// clang-format on

void draw_table(AppContext& context, CompareDesk& desk) {
  constexpr auto flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_PadOuterX |
                         ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH;
  const float room = ImGui::GetContentRegionAvail().x / em();
  std::vector<const Column*> shown;
  for (const Column& c : columns)
    if (c.room <= room) shown.push_back(&c);
  std::size_t removed = desk.lanes.size();
  if (!ImGui::BeginTable("lanes", 1 + static_cast<int>(shown.size()), flags)) return;
  ImGui::TableSetupColumn("Lane", ImGuiTableColumnFlags_WidthStretch);
  for (const Column* c : shown) ImGui::TableSetupColumn(c->head);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("Lane");
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  for (const Column* c : shown) number_cell(c->head, c->help);
  ImGui::PopStyleColor();
  for (std::size_t k = 0; k < desk.lanes.size() && k < desk.curves.size(); ++k) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(k));
    if (lane_cell(context, desk, k)) removed = k;
    ImGui::PopID();
    if (k >= desk.lanes.size()) break;  // closed by its menu
    for (const Column* c : shown) number_cell(c->text(desk, k), nullptr);
  }
  ImGui::EndTable();
  if (removed < desk.lanes.size()) desk.remove(context, removed);
}

void draw_plot(AppContext& context, CompareDesk& desk) {
  ImGui::SetNextItemWidth(std::min(em(15), ImGui::GetContentRegionAvail().x));
  const Metric& metric = metrics[desk.metric];
  if (ImGui::BeginCombo("##metric", metric.name, ImGuiComboFlags_HeightLarge)) {
    for (std::size_t k = 0; k < metrics.size(); ++k)
      if (ImGui::Selectable(metrics[k].name, k == desk.metric)) {
        desk.metric = k;
        desk.view = {};
      }
    ImGui::EndCombo();
  }
  Chart chart = time_chart(metrics[desk.metric].name, metrics[desk.metric].unit);
  const bool apart = metrics[desk.metric].times == &LaneCurves::distance_time;
  for (std::size_t k = 0; k < desk.lanes.size() && k < desk.curves.size(); ++k) {
    const LaneCurves& c = desk.curves[k];
    if (apart && k == 0) continue;
    add_series(chart, std::to_string(k + 1) + " " + desk.lanes[k].name, c.*metrics[desk.metric].times,
               c.*metrics[desk.metric].values, k, Role::current);
  }
  PlotLook look;
  look.own_legend = true;
  plot(context, "compare", std::move(chart), desk.view, look);
}

void draw_side(AppContext& context, CompareDesk& desk) {
  if (desk.active()) {
    draw_table(context, desk);
    if (!desk.active()) return;
    draw_followed(context, desk);
    checkbox("difference", "Colour by the distance from lane 1", &desk.difference);
    tooltip("Particle by particle: |x - x of the same particle in lane 1|, on one colour map for all lanes.");
    if (flow_button("Back to one run", true)) return desk.close(context);
    tooltip("Ends the comparison; the run goes on from where it was.");
    gap(0.4F);
  } else {
    paragraph("Two to four runs of this scene side by side, at the same time and through the same camera, from t = 0.");
    gap(0.25F);
  }
  if (desk.lanes.size() < most_lanes) draw_next(context, desk);
  if (!desk.refusal.empty()) warning(desk.refusal);
}

}  // namespace

void draw_compare_panel(AppContext& context) {
  CompareDesk& desk = compare_of(context);
  const float width = ImGui::GetContentRegionAvail().x;
  const bool wide = width > em(both);
  if (!wide && desk.active()) {
    int which = desk.show_plot ? 1 : 0;
    outlined_radio("Table", &which, 0);
    ImGui::SameLine();
    outlined_radio("Plot", &which, 1);
    desk.show_plot = which == 1;
  }
  const bool table = wide || !desk.show_plot || !desk.active();
  if (table) {
    const float side = wide && desk.active() ? std::max(em(30), 0.46F * width) : 0;
    ImGui::BeginChild("lanes-side", ImVec2(side, 0), false, ImGuiWindowFlags_NoBackground);
    draw_side(context, desk);
    ImGui::EndChild();
    if (wide) ImGui::SameLine(0, em());
  }
  if (!desk.active() || (!wide && !desk.show_plot)) return;
  ImGui::BeginGroup();
  draw_plot(context, desk);
  ImGui::EndGroup();
}

}  // namespace pf::app
