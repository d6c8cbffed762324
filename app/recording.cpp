#include "app/recording.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/scene/live_lists.hpp"
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

/// Whether `to` is all of `from`, and more after it.
bool grown(const Json& from, const Json& to) {
  return !from.empty() && from.size() < to.size() && std::equal(from.begin(), from.end(), to.begin());
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
  } else if (from.is_array() && to.is_array() && grown(from, to)) {
    for (std::size_t i = from.size(); i < to.size(); ++i) edits.push_back({pointer + "/-", to[i]});
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
  if (comes_or_goes_live(edit.pointer)) return Applies::live;  // it enters the running simulation, or leaves it
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

void Recording::add(long step, double time, const std::vector<Edit>& edits) {
  if (edits.empty()) return;
  taken_back_.clear();
  const auto replaceable = [](const Edit& edit) { return !edit.value.is_string(); };
  const auto appends = [](const Edit& edit) { return edit.pointer.ends_with("/-"); };
  const auto open = [&] { return !deeds_.empty() && deeds_.back().step == step && !deeds_.back().edits.empty(); };
  for (const Edit& edit : edits) {
    // The newest value of a place is the one that the next step saw. A choice that was made and taken back may have
    // left its traces, though: going from APIC to FLIP forgets the affine velocities. And an event has each place once.
    const bool again = open() && std::any_of(deeds_.back().edits.begin(), deeds_.back().edits.end(),
                                             [&](const Edit& earlier) { return earlier.pointer == edit.pointer; });
    if (!open() || (again && (!replaceable(edit) || appends(edit)))) push({.step = step, .time = time});
    auto& set = deeds_.back().edits;
    std::erase_if(set, [&](const Edit& earlier) { return earlier.pointer == edit.pointer; });
    set.push_back(edit);
  }
}

void Recording::add_grab(long step, double time, const std::optional<Grab>& grab) {
  if (deeds_.empty() || deeds_.back().step != step || !deeds_.back().hold)
    push({.step = step, .time = time, .hold = true});
  deeds_.back().grab = grab;
}

std::optional<Deed> Recording::take_back_strokes() {
  if (!ends_in_stroke()) return std::nullopt;
  const std::uint64_t gesture = deeds_.back().gesture;
  const auto begin = std::find_if(deeds_.rbegin(), deeds_.rend(), [&](const Deed& deed) {
                       return !deed.stroke || deed.gesture != gesture;
                     }).base();
  taken_back_.emplace_back(begin, deeds_.end());
  deeds_.erase(begin, deeds_.end());
  return taken_back_.back().front();
}

std::optional<std::pair<long, long>> Recording::bring_back_strokes() {
  if (taken_back_.empty()) return std::nullopt;
  const std::vector<Deed> strokes = std::move(taken_back_.back());
  taken_back_.pop_back();
  deeds_.insert(deeds_.end(), strokes.begin(), strokes.end());
  return std::pair{strokes.front().step, strokes.back().step};
}

void Recording::forget_after(long step) {
  taken_back_.clear();
  std::erase_if(deeds_, [&](const Deed& deed) { return deed.step > step; });
}

bool Recording::grabbed() const {
  return std::any_of(deeds_.begin(), deeds_.end(), [](const Deed& deed) { return deed.grab.has_value(); });
}

Scene Recording::scene() const {
  Scene scene = built_;
  for (const Deed& deed : deeds_) {
    if (!deed.edits.empty()) scene.events.push_back({deed.time, deed.edits, {}});
    if (deed.stroke) scene.events.push_back({deed.time, {}, {*deed.stroke}});
  }
  std::stable_sort(scene.events.begin(), scene.events.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
  return scene;
}

}  // namespace pf::app
