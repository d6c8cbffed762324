#include "app/studies/describe.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "app/widgets/choices.hpp"
#include "app/widgets/units.hpp"
#include "core/params/pointer.hpp"
#include "core/params/setting.hpp"
#include "core/studies/results.hpp"
#include "core/studies/study_charts.hpp"

namespace pf::app {

namespace {

std::string value_words(const std::string& pointer, const nlohmann::json& value) {
  const Setting* setting = pointer.starts_with("/constants/") ? nullptr : find_setting(pointer);
  const std::string name = setting != nullptr ? setting->label : pointer.substr(pointer.rfind('/') + 1);
  if (value.is_number()) return name + " " + quantity(value.get<double>(), setting != nullptr ? setting->unit : "");
  if (value.is_boolean()) return name + (value.get<bool>() ? " on" : " off");
  if (!value.is_string()) return name + " " + value.dump();
  const std::string word = value.get<std::string>();
  if (setting == nullptr || setting->kind != SettingKind::choice) return name + " " + word;
  const std::string label = choice_label(pointer, word);
  // "Lumped" alone does not say which mass.
  const bool clear = pointer == "/integrator/type" || pointer == "/transfer/type";
  return clear ? label : name + " " + label;
}

std::string lower_first(std::string text) {
  for (const char* name : {"Young", "Poisson", "Newton"})
    if (text.starts_with(name)) return text;
  const bool word = text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' && text[1] >= 'a' && text[1] <= 'z';
  if (word) text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

std::string share_words(double value) {
  return quantity(100 * value, "", 2) + " %";
}

}  // namespace

std::string setting_title(const Scene& scene, const std::string& pointer) {
  const Setting* setting = find_setting(pointer);
  if (setting == nullptr) return pointer;
  const auto steps = split_pointer(pointer);
  if (!steps || steps->size() < 3) return setting->label;
  const auto& [list, item] = std::pair((*steps)[0], (*steps)[1]);
  if (list == "materials") return scene.materials.size() > 1 ? setting->label + " (" + item + ")" : setting->label;
  const auto index = array_index(item);
  if (list == "bodies" && index && *index < scene.bodies.size()) {
    if (scene.bodies.size() < 2) return setting->label;
    const std::string& name = scene.bodies[*index].name;
    return setting->label + " (" + (name.empty() ? "body " + std::to_string(*index + 1) : name) + ")";
  }
  if (list == "boundaries" && index)
    return scene.boundaries.size() > 1 ? setting->label + " (wall " + std::to_string(*index + 1) + ")" : setting->label;
  return setting->label;
}

std::string setting_words(const Study& study, std::size_t k) {
  const StudyPoint point = study_point(study, k);
  std::string text;
  const auto add = [&text](std::string words) { text += text.empty() ? words : ", " + lower_first(std::move(words)); };
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    const StudyValue& value = study.axes[a].values[point.at[a]];
    if (!value.label.empty()) {
      add(value.label);
      continue;
    }
    for (const Edit& edit : value.edits) add(value_words(edit.pointer, edit.value));
  }
  return text;
}

std::string cost_words(const Study& study, const StudyRow& row) {
  const Cost cost = cost_of(study, row);
  if (std::isnan(cost.value)) return "";
  if (study.cost == "work") return quantity(cost.value, "", 3) + " weighted visits";
  std::string text = quantity(cost.value, "s", 3);
  if (cost.high > cost.low) text += " (" + quantity(cost.low, "s", 3) + " to " + quantity(cost.high, "s", 3) + ")";
  return text;
}

std::string class_words(RunClass behaviour) {
  std::string name(name_of(behaviour));
  if (behaviour == RunClass::blown_up) name = "blown up";
  return name;
}

std::vector<std::string> row_words(const Study& study, const StudyRow& row) {
  std::vector<std::string> lines{setting_words(study, row.point)};
  const auto add = [&lines](const std::string& name, const std::string& value) {
    if (!value.empty()) lines.push_back(name + ": " + value);
  };
  const auto number = [](double value, const char* unit) {
    return std::isnan(value) ? std::string() : quantity(value, unit, 3);
  };
  const auto share = [](double value) { return std::isnan(value) ? std::string() : share_words(value); };
  add("Position error", number(row.error_l2, "m"));
  add(study.cost == "work" ? "Work" : "Wall time", cost_words(study, row));
  const std::string behaviour = class_words(row.behaviour);
  if (row.reason.empty() || row.behaviour != RunClass::failed) add("The run was", behaviour);
  if (!row.reason.empty() && row.behaviour == RunClass::failed) add("Failed", row.reason.substr(0, 160));
  add("Energy change", share(row.energy_change));
  add("Stress noise", share(row.stress_noise));
  if (row.retries > 0) add("Steps begun again", number(row.retries, ""));
  return lines;
}

std::string duration_words(double seconds) {
  if (std::isnan(seconds)) return "";
  char text[48];
  if (seconds < 90)
    std::snprintf(text, sizeof text, "%.0f s", std::max(1.0, seconds));
  else if (seconds < 5400)
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  else
    std::snprintf(text, sizeof text, "%.0f h %.0f min", std::floor(seconds / 3600), std::fmod(seconds, 3600) / 60);
  return text;
}

std::string trouble_words(std::span<const StudyRow> rows) {
  std::array<std::size_t, 6> counts{};
  for (const StudyRow& row : rows) ++counts[static_cast<std::size_t>(row.behaviour)];
  std::string text;
  const auto add = [&](RunClass behaviour, const char* words) {
    const std::size_t count = counts[static_cast<std::size_t>(behaviour)];
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + words;
  };
  add(RunClass::blown_up, "blew up");
  add(RunClass::growing, "gained energy");
  add(RunClass::failed, "failed");
  return text;
}

}  // namespace pf::app
