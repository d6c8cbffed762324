#include "core/params/setting_text.hpp"

#include <cmath>

#include "core/params/json_text.hpp"
#include "core/params/nearest.hpp"

namespace pf {

std::string range_text(const Setting& setting) {
  std::string text;
  if (setting.min == setting.max) return number_text(setting.min);
  if (std::isfinite(setting.min)) text += (setting.open_min ? "> " : ">= ") + number_text(setting.min);
  if (std::isfinite(setting.max)) {
    if (!text.empty()) text += " and ";
    text += (setting.open_max ? "< " : "<= ") + number_text(setting.max);
  }
  return text.empty() ? "any" : text;
}

std::string allowed_text(const Setting& setting, int components) {
  const std::string range = range_text(setting);
  const std::string limits =
      (range == "any" ? "" : " " + range) + (setting.unit.empty() ? "" : " [" + setting.unit + "]");
  const std::string count = std::to_string(components);
  switch (setting.kind) {
    case SettingKind::number:
      return "a number" + limits;
    case SettingKind::integer:
      return "a whole number" + limits;
    case SettingKind::text:
      return "a text";
    case SettingKind::flag:
      return "true or false";
    case SettingKind::choice:
      return suggest("", setting.choices);
    case SettingKind::vector:
      return "[" + count + " numbers]" + limits;
    case SettingKind::formula:
      return "a number or an expression" + limits;
    case SettingKind::formula_vector:
      return "[" + count + " numbers or expressions]" + limits;
    case SettingKind::flag_vector:
      return "[" + count + " of true or false]";
  }
  return "";
}

bool in_range(const Setting& setting, double value) {
  if (!std::isfinite(value)) return false;
  const bool above = setting.open_min ? value > setting.min : value >= setting.min;
  const bool below = setting.open_max ? value < setting.max : value <= setting.max;
  return above && below;
}

}  // namespace pf
