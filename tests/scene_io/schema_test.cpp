#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/params/setting.hpp"
#include "scene_text.hpp"

using namespace pf;
using Json = nlohmann::ordered_json;

namespace {

bool has_type(const Json& value, const std::string& type) {
  if (type == "integer") return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
  return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
         (type == "string" && value.is_string()) || (type == "number" && value.is_number()) ||
         (type == "boolean" && value.is_boolean());
}

/// The part of JSON Schema 2020-12 that scene_schema() uses; other keywords fail the test.
class Validator {
 public:
  explicit Validator(const Json& root) : root_(root) {}

  bool valid(const Json& schema, const Json& value) const {
    for (const auto& [keyword, rule] : schema.items()) {
      if (!holds(schema, keyword, rule, value)) return false;
    }
    return true;
  }

 private:
  bool holds(const Json& schema, const std::string& keyword, const Json& rule, const Json& value) const {
    static const std::vector<std::string> notes = {"$schema", "$defs", "title", "description", "default"};
    if (std::find(notes.begin(), notes.end(), keyword) != notes.end()) return true;
    if (keyword == "$ref") return valid(root_[Json::json_pointer(rule.get<std::string>().substr(1))], value);
    if (keyword == "type") {
      if (rule.is_string()) return has_type(value, rule);
      return std::any_of(rule.begin(), rule.end(), [&](const Json& type) { return has_type(value, type); });
    }
    if (keyword == "const") return value == rule;
    if (keyword == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end();
    if (keyword == "oneOf")
      return std::count_if(rule.begin(), rule.end(), [&](const Json& s) { return valid(s, value); }) == 1;
    if (value.is_number() || keyword == "minimum" || keyword == "maximum" || keyword.starts_with("exclusive"))
      return number_holds(keyword, rule, value);
    if (keyword == "minLength") return value.get_ref<const std::string&>().size() >= rule.get<std::size_t>();
    if (keyword == "minItems" || keyword == "minProperties") return value.size() >= rule.get<std::size_t>();
    if (keyword == "maxItems") return value.size() <= rule.get<std::size_t>();
    if (keyword == "items")
      return std::all_of(value.begin(), value.end(), [&](const Json& v) { return valid(rule, v); });
    return object_holds(schema, keyword, rule, value);
  }
  static bool number_holds(const std::string& keyword, const Json& rule, const Json& value) {
    if (!value.is_number()) return true;
    const double x = value.get<double>(), end = rule.get<double>();
    if (keyword == "minimum") return x >= end;
    if (keyword == "maximum") return x <= end;
    if (keyword == "exclusiveMinimum") return x > end;
    REQUIRE(keyword == "exclusiveMaximum");
    return x < end;
  }
  bool object_holds(const Json& schema, const std::string& keyword, const Json& rule, const Json& value) const {
    if (keyword == "required")
      return std::all_of(rule.begin(), rule.end(), [&](const Json& key) { return value.contains(key); });
    if (keyword == "propertyNames") {
      return std::all_of(value.items().begin(), value.items().end(),
                         [](const auto& item) { return item.key().starts_with('/'); });
    }
    for (const auto& [key, member] : value.items()) {
      const bool known = schema.contains("properties") && schema["properties"].contains(key);
      if (keyword == "properties" && known && !valid(rule[key], member)) return false;
      if (keyword == "additionalProperties" && !known && (rule.is_boolean() ? !rule.get<bool>() : !valid(rule, member)))
        return false;
    }
    REQUIRE_MESSAGE((keyword == "properties" || keyword == "additionalProperties"), keyword);
    return true;
  }
  const Json& root_;
};

}  // namespace

TEST_CASE("the schema accepts what the parser accepts") {
  const Json schema = scene_schema();
  const Validator validator(schema);
  CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  CHECK(validator.valid(schema, small_scene()));
  CHECK(validator.valid(schema, small_scene(3)));
  CHECK(validator.valid(schema, full_scene()));
  for (const auto& entry : std::filesystem::directory_iterator(PUSHFORWARD_SOURCE "/assets/scenes")) {
    if (entry.path().extension() != ".json") continue;
    CHECK_MESSAGE(validator.valid(schema, Json(to_json(load_scene(entry.path())))), entry.path().string());
  }
}

TEST_CASE("the schema refuses what the parser refuses for a key's own sake") {
  const Json schema = scene_schema();
  const Validator validator(schema);
  const std::pair<const char*, Json> wrong[] = {{"/grid/spacing", 0},
                                                {"/grid/spacings", 0.1},
                                                {"/grid/basis", "nurbs"},
                                                {"/grid/boundary_correction", 1},
                                                {"/time/step", -1},
                                                {"/version", 2},
                                                {"/dimension", 4},
                                                {"/transfer/flip_ratio", 1.5},
                                                {"/solver/max_newton", 1.5},
                                                {"/materials/rubber/poisson", 0.5},
                                                {"/materials/rubber/model", "steel"},
                                                {"/bodies", Json::array()},
                                                {"/bodies/0/shape/type", "mesh"},
                                                {"/bodies/0/name", ""},
                                                {"/gravity", {1}},
                                                {"/constraints/0/fix", {1, 0}}};
  for (const auto& [pointer, value] : wrong) {
    Json scene = full_scene();
    scene[Json::json_pointer(pointer)] = value;
    CHECK_MESSAGE(!validator.valid(schema, scene), pointer);
    CHECK_MESSAGE(!problems_in(scene).empty(), pointer);
  }
  for (const char* const key : {"dimension", "grid", "materials", "bodies"}) {
    Json scene = full_scene();
    scene.erase(key);
    CHECK_MESSAGE(!validator.valid(schema, scene), key);
  }
}
