// docs/parameters.md from the table of settings.
#include <algorithm>

#include "core/materials/law.hpp"
#include "core/params/json_text.hpp"
#include "core/params/pointer.hpp"
#include "core/params/setting_text.hpp"
#include "core/scene/choices.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

/// What may stand in a table's cell.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  for (std::size_t at = 0; (at = text.find('*', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  return text;
}

std::string range_cell(const Setting& setting) {
  if (setting.kind == SettingKind::choice) {
    std::string text;
    for (const std::string& choice : setting.choices) text += (text.empty() ? "" : ", ") + choice;
    return text;
  }
  if (setting.kind == SettingKind::flag || setting.kind == SettingKind::flag_vector) return "true, false";
  if (setting.kind == SettingKind::text) return "text";
  std::string text = range_text(setting);
  if (setting.kind == SettingKind::formula || setting.kind == SettingKind::formula_vector)
    text = "expression" + (text == "any" ? "" : ", " + text);
  return setting.unit.empty() ? text : text + " " + setting.unit;
}

std::string row(const Setting& setting, const std::string& key) {
  static constexpr const char* applies[] = {"live", "reset", "view"};
  const std::string fallback = setting.required                ? "required"
                               : setting.default_value.empty() ? "absent"
                                                               : setting.default_value;
  return "| `" + key + "` | " + cell(range_cell(setting)) + " | " + cell(fallback) + " | " +
         applies[static_cast<int>(setting.applies)] + " | " + cell(setting.help) + " |\n";
}

std::string table_head(const std::string& title) {
  return "\n## " + title + "\n\n| key | allowed | default | applies | meaning |\n|---|---|---|---|---|\n";
}

std::string choice_list(const std::string& title, std::span<const Choice> choices) {
  std::string text = "\n### " + title + "\n\n";
  for (const Choice& choice : choices)
    text += "- `" + std::string(choice.name) + "`: " + std::string(choice.label) + ". " +
            cell(std::string(choice.help)) + ".\n";
  return text;
}

std::string law_list() {
  std::string text = "\n### Laws\n\n";
  for (const LawInfo& law : laws())
    text += "- `" + std::string(law.name) + "`: " + std::string(law.label) + ". " + cell(std::string(law.about)) + "\n";
  return text;
}

}  // namespace

std::string settings_markdown() {
  std::string text =
      "# Parameters of the scene file\n\n"
      "Made by `PUSHFORWARD_UPDATE_DOCS=1 ./test.sh -R parameters.md` from the tables that parse the file; do not edit "
      "by hand.\n\n"
      "SI units. A number may also be given as a text: an expression of the scene's `constants`, such as `\"1/60\"`. A "
      "\\* in a\n"
      "pointer stands for an index or a name. *live* settings apply at the next step, those marked *reset* after a "
      "reset,\n"
      "*view* ones touch no physics.\n";
  std::vector<std::pair<std::string, std::string>> parts = {{"The scene", ""}};  // title, rows
  std::string shape_rows;
  for (const Setting& setting : settings()) {
    const std::size_t slash = setting.pointer.rfind('/');
    const std::string above = setting.pointer.substr(0, slash), key = setting.pointer.substr(slash + 1);
    const std::size_t shape = std::min(setting.pointer.find("/shape/"), setting.pointer.find("/region/"));
    if (shape != std::string::npos) {  // the same keys in four places: listed once
      if (setting.pointer.starts_with("/bodies/")) shape_rows += row(setting, key);
      continue;
    }
    const std::string title = above.empty() ? "The scene" : "`" + above + "`";
    auto part = std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.first == title; });
    if (part == parts.end()) part = parts.insert(parts.end(), {title, ""});
    part->second += row(setting, key);
  }
  for (const auto& [title, rows] : parts) text += table_head(title) + rows;
  text += table_head("Shapes") + shape_rows;
  text += "\n`union`, `difference` and `intersection` take their members in `of`, an array of shapes.\n";
  text += choice_list("Shapes", shape_choices()) + law_list() + choice_list("Shape functions", basis_choices()) +
          choice_list("Time integrators", integrator_choices()) + choice_list("Transfers", transfer_choices()) +
          choice_list("Mass matrices", mass_choices()) + choice_list("Linear solvers", solver_choices()) +
          choice_list("Samplings", sampling_choices()) + choice_list("Contacts", contact_choices());
  return text;
}

}  // namespace pf
