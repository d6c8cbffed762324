// Sets values by pointer, as --set, events, studies and panels do.
#include "core/params/nearest.hpp"
#include "core/params/pointer.hpp"
#include "core/scene/scene_io.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

/// What the tables say of the place that an edit has reached; all empty where they know nothing.
struct Place {
  const Table* table = nullptr;  ///< of the object here
  const Key* key = nullptr;      ///< of the list or map here, whose items have key->child
};

/// The place one step further down, and the key that leads there.
Place descend(const Place& place, const std::string& step, const Key*& key) {
  key = place.table ? place.table->find(step) : nullptr;
  if (place.key) return {place.key->child ? &place.key->child() : nullptr, nullptr};
  if (!key) return {};
  if (key->nesting == Nesting::object) return {key->child ? &key->child() : nullptr, nullptr};
  if (key->nesting == Nesting::list || key->nesting == Nesting::map) return {nullptr, key};
  return {};
}

/// What a missing member is before an edit goes on below it: its default, or else what the next step asks for.
Json missing_member(const Key* key, int dimension, const std::string& next) {
  if (key && key->fallback) {
    if (std::optional<Json> value = key->fallback(dimension)) return *std::move(value);
  }
  return next == "-" ? Json::array() : Json::object();
}

Json* step_into_array(Json& array, const std::string& step, std::string& changed, std::string& allowed) {
  if (step == "-") {
    changed += '/' + std::to_string(array.size());
    array.push_back(Json::object());
    return &array.back();
  }
  const std::optional<std::size_t> index = array_index(step);
  if (!index || *index >= array.size()) {
    allowed = array.empty() ? "only - (append), because the array is empty"
                            : "an index from 0 to " + std::to_string(array.size() - 1) + ", or - to append";
    return nullptr;
  }
  changed += '/' + step;
  return &array[*index];
}

}  // namespace

int peek_dimension(const Json& document) {
  const auto it = document.is_object() ? document.find("dimension") : document.end();
  if (!document.is_object() || it == document.end() || !it->is_number()) return 2;
  return it->get<double>() == 3 ? 3 : 2;
}

bool apply_edit(Json& document, const std::string& pointer, Json value, std::vector<Problem>& problems,
                std::string& changed) {
  const auto refuse = [&](std::string found, std::string allowed) {
    problems.push_back({pointer, std::move(found), std::move(allowed), 0});
    return false;
  };
  const std::optional<std::vector<std::string>> steps = split_pointer(pointer);
  if (!steps || steps->empty())
    return refuse("the pointer \"" + pointer + "\"", "a pointer such as /time/step; ~1 stands for /, ~0 for ~");
  if (steps->size() > 100) return refuse("a pointer of " + std::to_string(steps->size()) + " steps", "at most 100");
  const int dimension = peek_dimension(document);
  Json* at = &document;
  Place place{&scene_table(), nullptr};
  changed.clear();
  for (std::size_t k = 0; k < steps->size(); ++k) {
    const std::string& step = (*steps)[k];
    const bool last = k + 1 == steps->size();
    const Key* key = nullptr;
    const Place below = descend(place, step, key);
    if (at->is_array()) {
      std::string allowed;
      at = step_into_array(*at, step, changed, allowed);
      if (!at) return refuse("the step \"" + step + "\" into " + (changed.empty() ? "the document" : changed), allowed);
    } else if (at->is_object()) {
      changed += pointer_step(step);
      if (!last && !at->contains(step)) (*at)[step] = missing_member(key, dimension, (*steps)[k + 1]);
      at = &(*at)[step];
    } else {
      return refuse(
          describe(*at).append(" at ").append(changed).append(", where \"").append(step).append("\" is to be set"),
          "pointers to what the scene holds");
    }
    place = below;
  }
  *at = std::move(value);
  return true;
}

}  // namespace pf
