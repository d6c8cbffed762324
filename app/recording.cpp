#include "app/recording.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/scene/scene_io.hpp"

namespace pf::app {
namespace {

using Json = nlohmann::ordered_json;

std::string escaped(const std::string& key) {
  std::string out;
  for (const char c : key) {
    if (c == '~')
      out += "~0";
    else if (c == '/')
      out += "~1";
    else
      out += c;
  }
  return out;
}

/// No edit can take a key away: an object that loses one is replaced whole.
bool keeps_keys(const Json& from, const Json& to) {
  for (const auto& item : from.items())
    if (!to.contains(item.key())) return false;
  return true;
}

void collect(const Json& from, const Json& to, const std::string& pointer, std::vector<Edit>& edits) {
  if (from == to) return;
  if (from.is_object() && to.is_object() && keeps_keys(from, to)) {
    for (const auto& item : to.items()) {
      const std::string below = pointer + "/" + escaped(item.key());
      if (from.contains(item.key()))
        collect(from.at(item.key()), item.value(), below, edits);
      else
        edits.push_back({below, item.value()});
    }
  } else if (from.is_array() && to.is_array() && from.size() == to.size()) {
    for (std::size_t i = 0; i < to.size(); ++i) collect(from[i], to[i], pointer + "/" + std::to_string(i), edits);
  } else {
    edits.push_back({pointer, to});
  }
}

}  // namespace

std::vector<Edit> difference(const Scene& from, const Scene& to) {
  std::vector<Edit> edits;
  if (!(from == to)) collect(to_json(from), to_json(to), "", edits);
  return edits;
}

Applies applies(const Edit& edit) {
  for (std::string pointer = edit.pointer; !pointer.empty(); pointer.erase(pointer.rfind('/'))) {
    if (const Setting* setting = find_setting(pointer)) return setting->applies;
  }
  return Applies::reset;
}

std::vector<Edit> only(const std::vector<Edit>& edits, Applies when) {
  std::vector<Edit> chosen;
  std::copy_if(edits.begin(), edits.end(), std::back_inserter(chosen),
               [&](const Edit& edit) { return applies(edit) == when; });
  return chosen;
}

void Recording::add(double time, const std::vector<Edit>& edits) {
  if (edits.empty()) return;
  if (log_.empty() || log_.back().time != time) log_.push_back({time, {}});
  for (const Edit& edit : edits) {
    // The newest value of a place is the one that the next step saw.
    auto& set = log_.back().set;
    std::erase_if(set, [&](const Edit& earlier) { return earlier.pointer == edit.pointer; });
    set.push_back(edit);
  }
}

Scene Recording::scene() const {
  Scene scene = built_;
  scene.events.insert(scene.events.end(), log_.begin(), log_.end());
  std::stable_sort(scene.events.begin(), scene.events.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
  return scene;
}

}  // namespace pf::app
