// JSON Schema (2020-12) from the tables. Numbers may be texts everywhere: expressions of constants.
#include <cmath>

#include "core/scene/scene_io.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

Json number_schema(const Setting& setting, const char* type) {
  Json schema = {{"type", Json::array({type, "string"})}};
  if (std::isfinite(setting.min)) schema[setting.open_min ? "exclusiveMinimum" : "minimum"] = setting.min;
  if (std::isfinite(setting.max)) schema[setting.open_max ? "exclusiveMaximum" : "maximum"] = setting.max;
  return schema;
}

Json components(Json item) {
  return {{"type", "array"}, {"items", std::move(item)}, {"minItems", 2}, {"maxItems", 3}};
}

Json leaf_schema(const Setting& setting) {
  switch (setting.kind) {
    case SettingKind::number:
    case SettingKind::formula:
      return number_schema(setting, "number");
    case SettingKind::integer:
      return number_schema(setting, "integer");
    case SettingKind::text:
      return setting.min > 0 ? Json{{"type", "string"}, {"minLength", 1}} : Json{{"type", "string"}};
    case SettingKind::flag:
      return {{"type", "boolean"}};
    case SettingKind::choice:
      return {{"enum", setting.choices}};
    case SettingKind::vector:
    case SettingKind::formula_vector:
      return components(number_schema(setting, "number"));
    case SettingKind::flag_vector:
      return components({{"type", "boolean"}});
  }
  return {};
}

Json table_schema(const Table& table);

Json nested_schema(const Key& key) {
  if (key.schema) return key.schema();
  const Table& child = key.child();
  Json items = &child == &shape_table()               ? Json{{"$ref", "#/$defs/shape"}}
               : &child == &material_table()          ? Json{{"$ref", "#/$defs/material"}}
               : child.keys[0].setting.pointer == "*" ? Json{{"type", "number"}}
                                                      : table_schema(child);
  if (key.nesting == Nesting::object) return items;
  if (key.nesting == Nesting::map) return {{"type", "object"}, {"additionalProperties", std::move(items)}};
  Json schema = {{"type", "array"}, {"items", std::move(items)}};
  if (key.setting.min > 0) schema["minItems"] = key.setting.min;
  if (std::isfinite(key.setting.max)) schema["maxItems"] = key.setting.max;
  return schema;
}

Json key_schema(const Key& key) {
  const Setting& setting = key.setting;
  Json schema = key.nesting == Nesting::leaf ? (key.schema ? key.schema() : leaf_schema(setting)) : nested_schema(key);
  if (!setting.label.empty()) schema["title"] = setting.label;
  if (!setting.help.empty())
    schema["description"] = setting.help + (setting.unit.empty() ? "" : " [" + setting.unit + "]");
  if (key.nesting == Nesting::leaf && key.fallback) {
    if (std::optional<Json> value = key.fallback(2)) schema["default"] = *std::move(value);
  }
  return schema;
}

Json table_schema(const Table& table) {
  Json properties = Json::object(), required = Json::array();
  for (const Key& key : table.keys) {
    properties[key.setting.pointer] = key_schema(key);
    if (key.setting.required) required.push_back(key.setting.pointer);
  }
  Json schema = {{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty()) schema["required"] = std::move(required);
  schema["additionalProperties"] = false;
  return schema;
}

}  // namespace

nlohmann::ordered_json scene_schema() {
  Json schema = {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "Pushforward scene"},
      {"description", "SI units. A number may also be given as a text: an expression of the scene's constants."}};
  schema.update(table_schema(scene_table()));
  schema["properties"]["format"] = {{"const", "pushforward/scene"}};
  schema["properties"]["version"] = {{"const", 1}};
  schema["properties"]["dimension"] = {{"enum", {2, 3}},
                                       {"description", scene_table().find("dimension")->setting.help}};
  schema["$defs"] = {{"shape", shape_schema()}, {"material", material_schema()}};
  return schema;
}

}  // namespace pf
