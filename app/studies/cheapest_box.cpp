// "Cheapest setting for an error below ...": the question that a study answers, and its answer in one click.
#include <imgui.h>

#include <cmath>

#include "app/panels/memory.hpp"
#include "app/studies/describe.hpp"
#include "app/studies/pages.hpp"
#include "app/widgets/number_control.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

const std::string key = "study-tolerance";

/// The bound, from the least to the greatest error measured.
void draw_bound(AppContext& context, StudyDesk& desk, double bound, std::pair<double, double> range) {
  Setting setting;
  setting.unit = "m";
  setting.min = 0;
  setting.open_min = true;
  setting.logarithmic = true;
  setting.slider_min = rounded(range.first, 2);
  setting.slider_max = rounded(1.02 * range.second, 2);
  if (!(setting.slider_max > setting.slider_min)) setting.slider_max = 2 * setting.slider_min;
  Typing& typing = memory(context).typing;
  const NumberControl control{
      typing,
      setting,
      key,
      "Cheapest for an error below",
      "Root mean square error of position that is good enough. Measured: " + quantity(range.first, "m", 3) + " to " +
          quantity(range.second, "m", 3) + ". Allowed: above 0 m.",
      std::nan(""),
      false,
      {}};
  if (const auto to = number_control(control, bound)) desk.tolerance = *to;
  if (typing.refused_key == key) warning(typing.refusal);
}

void draw_ties(const StudyDesk& desk, const Cheapest& found) {
  if (found.ties.empty()) return;
  const Study& study = *desk.results->study;
  muted(std::to_string(found.ties.size()) + (found.ties.size() == 1 ? " other costs" : " others cost") +
        " the same, as far as the timing tells.");
  std::string list;
  for (const StudyRow* row : found.ties)
    list += (list.empty() ? "" : "\n") + setting_words(study, row->point) + ": " + cost_words(study, *row);
  tooltip(list);
}

}  // namespace

void draw_cheapest(AppContext& context, StudyDesk& desk) {
  const std::optional<double> bound = desk.bound();
  if (!bound) return;
  const StudyResults& results = *desk.results;
  const auto range = error_range(*results.study, results.rows);
  draw_bound(context, desk, *bound, *range);
  const std::optional<Cheapest> found = desk.answer();
  if (!found) {
    muted("No run is that exact: the best has " + quantity(range->first, "m", 3) + ".");
    return;
  }
  paragraph(setting_words(*results.study, found->best->point));
  muted("error " + quantity(found->best->error_l2, "m", 3) + ", " + cost_words(*results.study, *found->best));
  draw_ties(desk, *found);
  const bool in_use = desk.place && desk.place->setting(*results.study) == found->best->point;
  ImGui::BeginDisabled(in_use);
  if (ImGui::Button(in_use ? "In use" : "Use it")) load_setting(context, found->best->point);
  ImGui::EndDisabled();
  tooltip(in_use ? "The live scene has these settings."
                 : "Puts these settings into the live scene. Ctrl+Z takes them back.");
}

}  // namespace pf::app
