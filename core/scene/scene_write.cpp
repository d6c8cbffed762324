// Scene -> text.
#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/params/json_text.hpp"
#include "core/scene/key_builder.hpp"
#include "core/scene/scene_io.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

constexpr std::size_t line_width = 110;

std::string string_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// On one line; stops early beyond `room` characters, which then is too long anyway.
void append_flat(const Json& json, std::size_t room, std::string& out) {
  if (out.size() > room) return;
  if (json.is_object()) {
    if (json.empty()) {
      out += "{}";
      return;
    }
    out += "{ ";
    bool first = true;
    for (const auto& [key, value] : json.items()) {
      if (!first) out += ", ";
      first = false;
      out += string_text(key) + ": ";
      append_flat(value, room, out);
    }
    out += " }";
  } else if (json.is_array()) {
    out += '[';
    for (std::size_t k = 0; k < json.size(); ++k) {
      if (k) out += ", ";
      append_flat(json[k], room, out);
    }
    out += ']';
  } else if (json.is_number_float()) {
    out += number_text(json.get<double>());
  } else {
    out += json.is_string() ? string_text(json.get_ref<const std::string&>()) : json.dump();
  }
}

/// What fits on a line stays on one; the document itself and its lists of objects are always spread.
void append_pretty(const Json& json, std::size_t indent, std::size_t column, bool spread, std::string& out) {
  std::string flat;
  append_flat(json, line_width, flat);
  if (!json.is_structured() || json.empty() || (!spread && column + flat.size() <= line_width)) {
    flat.clear();
    append_flat(json, SIZE_MAX, flat);
    out += flat;
    return;
  }
  const std::string inside(indent + 2, ' ');
  const bool object = json.is_object();
  out += object ? "{" : "[";
  bool first = true;
  for (const auto& [key, value] : json.items()) {
    out += first ? "\n" : ",\n";
    first = false;
    const std::string head = inside + (object ? string_text(key) + ": " : "");
    out += head;
    const bool list_of_objects = value.is_array() && !value.empty() && value.front().is_object();
    append_pretty(value, indent + 2, head.size(), list_of_objects, out);
  }
  out += "\n" + std::string(indent, ' ') + (object ? "}" : "]");
}

}  // namespace

Json to_json(const Vec3& value, int dimension) {
  Json array = Json::array();
  for (int a = 0; a < dimension; ++a) array.push_back(value[a]);
  return array;
}

Json to_json(const Formula& value) {
  return value.is_number() ? Json(value.number) : Json(value.text);
}

Json to_json(const FormulaVector& value, int dimension) {
  Json array = Json::array();
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    array.push_back(to_json(a < value.size() ? value[a] : Formula{}));
  return array;
}

Json scene_document(const Scene& scene, bool defaults) {
  Json document = write_table(scene_table(), &scene, {scene.dimension, defaults});
  // Beside "exact" a velocity contradicts it (fine print 5), even where it is zero.
  if (!scene.exact_position.empty()) {
    for (Json& body : document["bodies"]) body.erase("velocity");
  }
  // A tolerance without a word on control is refused.
  if (scene.time.tolerance) document["time"]["control"] = scene.time.control;
  return document;
}

nlohmann::ordered_json to_json(const Scene& scene) {
  return scene_document(scene, true);
}

std::string scene_text(const Scene& scene) {
  Json document = {{"format", "pushforward/scene"}, {"version", 1}};
  document.update(scene_document(scene, false));
  std::string text;
  append_pretty(document, 0, 0, true, text);
  return text + "\n";
}

void save_scene(const Scene& scene, const std::filesystem::path& file) {
  write_atomically(file, scene_text(scene));
}

std::string scene_hash(const Scene& scene) {
  return content_hash(to_json(scene).dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace pf
