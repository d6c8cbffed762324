#include "app/studies/values.hpp"

#include <algorithm>
#include <cmath>

#include "app/widgets/setting_help.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

using nlohmann::json;

bool allowed(double value, const Setting& s) {
  return value >= s.min && value <= s.max && !(s.open_min && value == s.min) && !(s.open_max && value == s.max);
}

std::vector<json> as_json(const std::vector<double>& numbers, const Setting& setting) {
  std::vector<json> values;
  for (const double number : numbers) {
    json value = number_json(number, setting);
    if (allowed(number, setting) && std::find(values.begin(), values.end(), value) == values.end())
      values.push_back(std::move(value));
  }
  return values;
}

std::vector<json> proposed_numbers(const Setting& s, double now) {
  if (s.kind == SettingKind::integer && s.slider_max - s.slider_min <= 8)
    return as_json(ladder(s.slider_min, s.slider_max, static_cast<int>(s.slider_max - s.slider_min) + 1, false), s);
  if (s.pointer == "/grid/spacing") return as_json({2 * now, now, now / 2}, s);
  if (s.logarithmic && now > 0) {
    // Lengths of time want halving; stiffness and tolerances are judged by decades.
    const double factor = s.unit == "s" ? 2 : 10;
    return as_json({now * factor, now, now / factor, now / (factor * factor)}, s);
  }
  const double low = allowed(s.slider_min, s) ? s.slider_min : s.slider_min + 0.05 * (s.slider_max - s.slider_min);
  const double high = allowed(s.slider_max, s) ? s.slider_max : s.slider_max - 0.05 * (s.slider_max - s.slider_min);
  return as_json(ladder(low, high, 5, false), s);
}

std::string value_word(const json& value, const Setting& setting) {
  return value.is_number() ? quantity(value.get<double>(), setting.unit, 6)
                           : value_text(nlohmann::ordered_json(value), setting);
}

}  // namespace

std::vector<double> ladder(double low, double high, int count, bool logarithmic) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) {
    const double t = count > 1 ? static_cast<double>(k) / (count - 1) : 0;
    if (k == 0 || k == count - 1)
      values.push_back(k == 0 ? low : high);
    else
      values.push_back(rounded(logarithmic ? low * std::pow(high / low, t) : low + t * (high - low), 3));
  }
  return values;
}

std::vector<json> proposed_values(const Setting& setting, const json& now) {
  std::vector<json> values;
  if (setting.kind == SettingKind::choice) {
    for (const std::string& choice : setting.choices)
      if (choice != "auto") values.emplace_back(choice);  // stands for one of the others
    return values;
  }
  if (setting.kind == SettingKind::flag) return {false, true};
  return proposed_numbers(setting, now.is_number() ? now.get<double>() : 0);
}

std::string values_text(const std::vector<json>& values, const Setting& setting) {
  std::string text;
  for (const json& value : values) text += (text.empty() ? "" : ", ") + value_word(value, setting);
  return text;
}

std::vector<json> typed_values(std::string_view typed, const Setting& setting, const std::vector<json>& before,
                               std::string& refusal) {
  std::vector<json> values;
  refusal.clear();
  for (std::size_t at = 0; at <= typed.size();) {
    const std::size_t end = std::min(typed.find_first_of(",;", at), typed.size());
    std::string word(typed.substr(at, end - at));
    at = end + 1;
    word.erase(0, std::min(word.find_first_not_of(' '), word.size()));
    while (word.ends_with(' ')) word.pop_back();
    if (word.empty()) continue;
    const auto known =
        std::find_if(before.begin(), before.end(), [&](const json& v) { return value_word(v, setting) == word; });
    if (known == before.end()) refusal = number_refusal(word, setting);
    if (!refusal.empty()) return before;
    json value = known != before.end() ? *known : number_json(*parse_quantity(word, setting.unit), setting);
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(std::move(value));
  }
  if (!values.empty()) return values;
  refusal = "No value is left. The values were kept.";
  return before;
}

std::vector<json> extended(const std::vector<json>& values, const Setting& setting, bool smaller) {
  std::vector<double> sorted;
  sorted.reserve(values.size());
  for (const json& value : values) sorted.push_back(value.get<double>());
  if (sorted.empty()) return values;
  const bool falling = sorted.front() > sorted.back();
  std::sort(sorted.begin(), sorted.end());
  const double end = smaller ? sorted.front() : sorted.back();
  const double next_to = sorted.size() < 2 ? 0 : smaller ? sorted[1] : sorted[sorted.size() - 2];
  double more = smaller ? end / 2 : end * 2;
  if (sorted.size() >= 2) more = end > 0 && next_to > 0 ? rounded(end * (end / next_to), 12) : 2 * end - next_to;
  if (setting.kind == SettingKind::integer) more = smaller ? end - 1 : end + 1;
  if (!allowed(more, setting)) return values;
  std::vector<json> longer = values;
  longer.insert(smaller == falling ? longer.end() : longer.begin(), number_json(more, setting));
  return longer;
}

}  // namespace pf::app
