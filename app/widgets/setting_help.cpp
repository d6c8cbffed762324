#include "app/widgets/setting_help.hpp"

#include <cmath>

#include "app/widgets/choices.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

std::string range_text(const Setting& s) {
  const bool below = std::isfinite(s.min), above = std::isfinite(s.max);
  const std::string low = quantity(s.min, s.unit), high = quantity(s.max, s.unit);
  if (below && above) {
    if (s.open_min && s.open_max) return "between " + low + " and " + high + ", both excluded";
    if (s.open_min) return "above " + low + ", up to " + high;
    if (s.open_max) return "from " + low + " to below " + high;
    return "from " + low + " to " + high;
  }
  if (below) return (s.open_min ? "above " : "at least ") + low;
  if (above) return (s.open_max ? "below " : "at most ") + high;
  return {};
}

std::string help_text(const Setting& s, bool waits_for_reset) {
  std::string text = s.help;
  const auto line = [&](const std::string& more) { text += (text.empty() ? "" : "\n") + more; };
  const std::string range = range_text(s);
  const bool numeric = s.kind == SettingKind::number || s.kind == SettingKind::integer;
  if (numeric && !range.empty()) line("Allowed: " + range + ".");
  if (!numeric && !s.unit.empty()) line("Unit: " + pretty_unit(s.unit) + ".");
  if (s.kind == SettingKind::formula || s.kind == SettingKind::formula_vector)
    line("A number or a formula, such as 2*sin(pi*t).");
  if (s.applies == Applies::reset)
    line(waits_for_reset ? "Changed: the run uses it after a reset." : "Takes effect after a reset.");
  if (s.applies == Applies::live) line("Takes effect at the next step.");
  return text;
}

std::string number_refusal(std::string_view typed, const Setting& s) {
  const auto value = parse_quantity(typed, s.unit);
  if (!value) {
    const std::string unit = s.unit.empty() ? std::string() : " in " + pretty_unit(s.unit);
    return "\"" + std::string(typed) + "\" is not a number" + unit + ". The value was kept.";
  }
  const bool low = *value < s.min || (s.open_min && *value == s.min);
  const bool high = *value > s.max || (s.open_max && *value == s.max);
  if (low || high) return quantity(*value, s.unit) + " is not allowed: " + range_text(s) + ". The value was kept.";
  if (s.kind == SettingKind::integer && *value != std::round(*value))
    return plain_number(*value) + " is not a whole number. The value was kept.";
  return {};
}

std::string problem_text(std::span<const Problem> problems) {
  if (problems.empty()) return "This change was refused.";
  const Problem& p = problems.front();
  std::string text = p.found.empty() ? p.pointer : p.found;
  if (!p.allowed.empty()) text += " (allowed: " + p.allowed + ")";
  return text + ". The value was kept.";
}

std::string value_text(const nlohmann::ordered_json& value, const Setting& s) {
  if (value.is_number()) return quantity(value.get<double>(), s.kind == SettingKind::vector ? "" : s.unit);
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_string()) {
    const auto text = value.get<std::string>();
    return s.kind == SettingKind::choice ? choice_label(s.pointer, text) : text;
  }
  if (!value.is_array()) return value.is_null() ? "none" : value.dump();
  std::string text = "[";
  for (const auto& item : value) text += (text.size() > 1 ? ", " : "") + value_text(item, s);
  return text + "]";
}

nlohmann::json number_json(double value, const Setting& s) {
  if (s.kind == SettingKind::integer) return static_cast<std::int64_t>(std::llround(value));
  return value;
}

nlohmann::json typed_component(std::string_view typed, const Setting& s) {
  if (s.kind != SettingKind::text)
    if (const auto number = parse_quantity(typed, s.unit)) return *number;
  return std::string(typed);
}

std::optional<nlohmann::ordered_json> default_value(const Setting& s, const nlohmann::ordered_json& value) {
  if (s.default_value.empty()) return std::nullopt;
  auto usual = nlohmann::ordered_json::parse(s.default_value, nullptr, false);
  const bool alike =
      usual.is_number() == value.is_number() && usual.is_array() == value.is_array() && usual.size() == value.size();
  if (usual.is_discarded() || usual.is_null() || !alike) return std::nullopt;
  return usual;
}

}  // namespace pf::app
