// The tables as one flat list of settings, for widgets and docs.
#include <map>

#include "core/params/pointer.hpp"
#include "core/params/setting.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

void collect(const Table& table, const std::string& above, std::vector<Setting>& all) {
  for (const Key& key : table.keys) {
    const std::string pointer = above + '/' + key.setting.pointer;
    if (key.nesting == Nesting::leaf) {
      Setting setting = key.setting;
      setting.pointer = pointer;
      if (key.fallback) {
        if (const std::optional<Json> value = key.fallback(2)) setting.default_value = value->dump();
      }
      all.push_back(std::move(setting));
    } else if (key.child && &key.child() != &table) {  // a boolean's members are shapes again
      const bool items =
          key.nesting == Nesting::list || (key.nesting == Nesting::map && key.child().keys[0].setting.pointer != "*");
      collect(key.child(), pointer + (items ? "/*" : ""), all);
    }
  }
}

const std::vector<Setting>& all_settings() {
  static const std::vector<Setting> all = [] {
    std::vector<Setting> settings;
    collect(scene_table(), "", settings);
    return settings;
  }();
  return all;
}

/// Steps of the pattern, and the pattern's place in the list.
const std::map<std::string, std::size_t, std::less<>>& by_pattern() {
  static const std::map<std::string, std::size_t, std::less<>> map = [] {
    std::map<std::string, std::size_t, std::less<>> result;
    for (std::size_t k = 0; k < all_settings().size(); ++k) result.emplace(all_settings()[k].pointer, k);
    return result;
  }();
  return map;
}

/// "/materials/rubber/young" -> "/materials/*/young"; members of boolean shapes count as the shape itself.
std::string pattern_of(const std::vector<std::string>& steps, std::size_t count) {
  std::string pattern;
  for (std::size_t k = 0; k < count; ++k) {
    const bool item = k == 1 && (steps[0] == "materials" || steps[0] == "bodies" || steps[0] == "boundaries" ||
                                 steps[0] == "constraints" || steps[0] == "loads" || steps[0] == "probes" ||
                                 steps[0] == "events" || steps[0] == "constants");
    if (item || (k == 3 && steps[0] == "events" && steps[2] == "strokes")) {
      pattern += "/*";
    } else if (k >= 3 && steps[k] == "of" && k + 1 < count) {
      ++k;
    } else {
      pattern += '/' + steps[k];
    }
  }
  return pattern;
}

}  // namespace

std::span<const Setting> settings() {
  return all_settings();
}

const Setting* find_setting(std::string_view pointer) {
  const std::optional<std::vector<std::string>> steps = split_pointer(pointer);
  if (!steps) return nullptr;
  const auto find = [&](std::size_t count) -> const Setting* {
    const auto it = by_pattern().find(pattern_of(*steps, count));
    return it == by_pattern().end() ? nullptr : &all_settings()[it->second];
  };
  if (const Setting* setting = find(steps->size())) return setting;
  // A component of a vector, or of a list of points.
  for (std::size_t up = 1; up <= 2 && up < steps->size(); ++up) {
    const Setting* setting = find(steps->size() - up);
    if (!setting) continue;
    const bool vector = setting->kind == SettingKind::vector || setting->kind == SettingKind::formula_vector ||
                        setting->kind == SettingKind::flag_vector;
    return vector ? setting : nullptr;
  }
  return nullptr;
}

}  // namespace pf
