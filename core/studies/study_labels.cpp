// What varied columns and their values are called.
#include "core/params/json_text.hpp"
#include "core/params/setting.hpp"
#include "core/scene/choices.hpp"
#include "core/studies/study_charts.hpp"
#include "core/studies/table_chart.hpp"

namespace pf {

namespace {

/// The label of a name in the registry that a pointer chooses from; "" where there is none.
std::string choice_label(const std::string& pointer, const std::string& name) {
  const std::pair<const char*, std::span<const Choice>> registries[] = {{"/grid/basis", basis_choices()},
                                                                        {"/integrator/type", integrator_choices()},
                                                                        {"/transfer/type", transfer_choices()},
                                                                        {"/solver/linear", solver_choices()},
                                                                        {"/time/control", step_control_choices()}};
  for (const auto& [place, choices] : registries)
    if (pointer == place)
      if (const Choice* choice = find_choice(choices, name)) return std::string(choice->label);
  return "";
}

}  // namespace

std::string value_label(const std::string& column, const nlohmann::json& value) {
  if (value.is_null()) return "";
  const Setting* setting = column.starts_with('/') ? find_setting(column) : nullptr;
  if (value.is_string()) {
    const std::string name = value.get<std::string>(), label = choice_label(column, name);
    if (!label.empty()) return label;
    return setting != nullptr && setting->kind == SettingKind::choice ? setting->label + " " + name : name;
  }
  if (!value.is_number()) return value.dump();
  const std::string number = number_text(value.get<double>());
  if (setting == nullptr) return column.substr(column.rfind('/') + 1) + " " + number;
  return setting->label + " " + number + (setting->unit.empty() ? "" : " " + setting->unit);
}

std::pair<std::string, std::string> column_title(const Study& study, const std::string& column) {
  for (const auto& [named, title] : study.titles)
    if (named == column) return split_unit(title);
  if (column == "cost") {
    const RowColumn* found = find_row_column(study.cost == "work" ? "work" : "wall_s");
    return {std::string(found->title), std::string(found->unit)};
  }
  if (const RowColumn* found = find_row_column(column)) return {std::string(found->title), std::string(found->unit)};
  const Setting* setting = column.starts_with('/') ? find_setting(column) : nullptr;
  if (setting != nullptr && !column.starts_with("/constants/")) return {setting->label, setting->unit};
  return {column.starts_with('/') ? column.substr(column.rfind('/') + 1) : column, ""};
}

}  // namespace pf
