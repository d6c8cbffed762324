// Materials: which parameters they have depends on the law.
#include <algorithm>
#include <cmath>

#include "core/materials/law.hpp"
#include "core/params/json_text.hpp"
#include "core/params/nearest.hpp"
#include "core/params/setting_text.hpp"
#include "core/scene/key_builder.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

constexpr std::size_t most_materials = 1'000;
constexpr double largest_parameter = 1e18;  // far beyond any material, far from overflow

Setting setting_of(const LawParameter& parameter) {
  Setting setting;
  setting.pointer = parameter.key;
  setting.label = parameter.label;
  setting.unit = parameter.unit;
  setting.min = parameter.min;
  setting.max = std::min(parameter.max, largest_parameter);
  setting.open_min = parameter.open_min;
  setting.open_max = parameter.open_max && setting.max == parameter.max;
  setting.help = parameter.help;
  setting.required = true;
  // A narrow range is spanned, a wide one by two decades on either side of what is typical.
  setting.logarithmic = !(parameter.max - parameter.min < 100);
  const double margin = 0.01 * (parameter.max - parameter.min);
  setting.slider_min = setting.logarithmic ? parameter.typical / 100 : std::max(0.0, parameter.min);
  setting.slider_max =
      setting.logarithmic ? parameter.typical * 100 : parameter.max - (parameter.open_max ? margin : 0);
  return setting;
}

/// The parameters of `law`, in its order; unknown and missing ones are problems.
void read_parameters(Reader& reader, const Json& json, const LawInfo& law, Material& material) {
  std::vector<std::string> known = {"model", "density", "f_bar"};
  for (const LawParameter& parameter : law.parameters) known.emplace_back(parameter.key);
  for (const auto& [key, value] : json.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) refuse_unknown(reader, key, known);
  }
  for (const LawParameter& parameter : law.parameters) {
    const std::string key(parameter.key);
    const Setting setting = setting_of(parameter);
    const Reader::Step step(reader, key);
    double value = parameter.typical;
    if (json.contains(key)) {
      read_number(reader, json[key], setting, value);
    } else {
      reader.refuse("nothing", allowed_text(setting, 1) + "; " + material.model + " needs this key");
    }
    material.parameters.emplace_back(key, value);
  }
}

void read_material(Reader& reader, const Json& json, Material& material) {
  if (!json.is_object()) return reader.refuse(describe(json), "an object { \"model\": ..., \"density\": ..., ... }");
  for (const char* const name : {"model", "density"}) {
    const Key& key = *material_table().find(name);
    const Reader::Step step(reader, name);
    if (json.contains(name)) {
      key.read(reader, json[name], &material);
    } else {
      reader.refuse("nothing", allowed_text(key.setting, 1) + "; this key is required");
    }
  }
  if (json.contains("f_bar")) {
    const Reader::Step step(reader, "f_bar");
    material_table().find("f_bar")->read(reader, json["f_bar"], &material);
  }
  if (const LawInfo* law = find_law(material.model)) return read_parameters(reader, json, *law, material);
  for (const auto& [key, value] : json.items()) {
    if (!material_table().find(key)) refuse_unknown(reader, key, material_table().names());
  }
}

}  // namespace

const Table& material_table() {
  static const Table table = [] {
    std::vector<std::string> models;
    for (const LawInfo& law : laws()) models.emplace_back(law.name);
    TableOf<Material> t("Material");
    t.choice(&Material::model, "model", "Law")
        .choices(std::move(models))
        .required()
        .live()
        .help("How stress follows from deformation.");
    t.number(&Material::density, "density", "Density", "kg/m^3")
        .above(0)
        .at_most(1e12)
        .log_slider(10, 1e4)
        .required()
        .reset()
        .help("Of the reference body.");
    t.flag(&Material::f_bar, "f_bar", "F-bar")
        .live()
        .help(
            "Against locking: particles of a cell share their change of volume. For materials that hardly change their "
            "volume, Poisson's ratio above 0.45 or so; else it only costs time.");
    Table made = t.take();
    for (const LawInfo& law : laws()) {
      for (const LawParameter& parameter : law.parameters) {
        if (made.find(parameter.key)) continue;
        Key key;
        key.setting = setting_of(parameter);
        key.fallback = [](int) { return std::nullopt; };
        made.keys.push_back(std::move(key));
      }
    }
    return made;
  }();
  return table;
}

void read_materials(Reader& reader, const Json& json, std::vector<Material>& materials) {
  if (!json.is_object() || json.empty())
    return reader.refuse(describe(json),
                         "an object { \"name\": { \"model\": ..., ... }, ... } with one material or more");
  if (!check_count(reader, json.size(), most_materials, "materials")) return;
  materials.resize(json.size());
  std::size_t index = 0;
  for (const auto& [name, value] : json.items()) {
    const Reader::Step step(reader, name);
    Material& material = materials[index++];
    material.name = name;
    if (name.empty()) reader.refuse("an empty name", "a name of one character or more");
    read_material(reader, value, material);
  }
}

Json write_materials(const std::vector<Material>& materials, bool defaults) {
  Json object = Json::object();
  for (const Material& material : materials) {
    Json entry = {{"model", material.model}, {"density", material.density}};
    for (const auto& [key, value] : material.parameters) entry[key] = value;
    if (defaults || material.f_bar) entry["f_bar"] = material.f_bar;
    object[material.name] = std::move(entry);
  }
  return object;
}

Json material_schema() {
  Json kinds = Json::array();
  for (const LawInfo& law : laws()) {
    Json properties = {
        {"model", {{"const", law.name}}},
        {"density", {{"type", Json::array({"number", "string"})}, {"exclusiveMinimum", 0}}},
        {"f_bar",
         {{"type", "boolean"}, {"default", false}, {"description", material_table().find("f_bar")->setting.help}}}};
    Json required = Json::array({"model", "density"});
    for (const LawParameter& parameter : law.parameters) {
      const Setting setting = setting_of(parameter);
      Json schema = {{"type", Json::array({"number", "string"})}};
      if (std::isfinite(setting.min)) schema[setting.open_min ? "exclusiveMinimum" : "minimum"] = setting.min;
      if (std::isfinite(setting.max)) schema[setting.open_max ? "exclusiveMaximum" : "maximum"] = setting.max;
      schema["description"] =
          std::string(parameter.help) + (parameter.unit.empty() ? "" : " [" + std::string(parameter.unit) + "]");
      properties[std::string(parameter.key)] = std::move(schema);
      required.push_back(parameter.key);
    }
    kinds.push_back({{"title", law.label},
                     {"description", law.about},
                     {"type", "object"},
                     {"properties", std::move(properties)},
                     {"required", std::move(required)},
                     {"additionalProperties", false}});
  }
  return {{"oneOf", std::move(kinds)}};
}

}  // namespace pf
