// Shapes: keys depend on the type, and booleans hold shapes.
#include <algorithm>
#include <array>

#include "core/params/nearest.hpp"
#include "core/scene/key_builder.hpp"
#include "core/scene/shapes/shape_types.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

constexpr double farthest = 1e9;                                   // [m]
constexpr std::size_t most_points = 10'000, most_members = 1'000;  // of one shape, booleans inside it included
constexpr int deepest = 16;                                        // booleans inside one another

const std::vector<std::string>& common_keys() {
  static const std::vector<std::string> keys = {"scale", "rotate", "translate"};
  return keys;
}

bool read_points(Reader& reader, const Json& json, const Setting& setting, Shape& shape) {
  if (!json.is_array()) {
    reader.refuse(describe(json), "an array of points [x, y] [m]");
    return false;
  }
  if (!check_count(reader, json.size(), most_points, "points")) return false;
  bool good = true;
  std::vector<Vec3> points(json.size());
  for (std::size_t k = 0; k < json.size(); ++k) {
    const Reader::Step step(reader, k);
    good = read_vector(reader, json[k], setting, points[k]) && good;
  }
  if (good) shape.points = std::move(points);
  return good;
}

/// 2D: degrees. 3D: {"axis": [0, 0, 1], "angle": degrees}.
bool read_rotation(Reader& reader, const Json& json, const Setting& setting, Shape& shape) {
  if (reader.dimension() == 2) return read_number(reader, json, setting, shape.rotate_degrees);
  const std::vector<std::string> keys = {"axis", "angle"};
  if (!json.is_object() || !json.contains("axis") || !json.contains("angle")) {
    reader.refuse(describe(json), "{ \"axis\": [x, y, z], \"angle\": degrees } in 3D");
    return false;
  }
  const std::size_t before = reader.refused();
  Setting axis = setting;
  axis.kind = SettingKind::vector;
  axis.unit = "";
  for (const auto& [key, value] : json.items()) {
    if (key != "axis" && key != "angle") {
      refuse_unknown(reader, key, keys);
      continue;
    }
    const Reader::Step step(reader, key);
    if (key == "angle") read_number(reader, value, setting, shape.rotate_degrees);
    if (key == "axis" && read_vector(reader, value, axis, shape.rotate_axis) && shape.rotate_axis.isZero(0))
      reader.refuse(describe(value), "an axis that is not zero");
  }
  return reader.refused() == before;
}

Json write_rotation(const Shape& shape, int dimension) {
  if (dimension == 2) return shape.rotate_degrees;
  return Json{{"axis", to_json(shape.rotate_axis, 3)}, {"angle", shape.rotate_degrees}};
}

bool read_where(Reader& reader, const Json& json, const Setting& setting, Shape& shape) {
  Formula formula;
  if (!read_formula(reader, json, setting, mask_reference, formula)) return false;
  shape.where = formula.is_number() ? json.dump() : formula.text;
  return true;
}

void add_geometry(TableOf<Shape>& t) {
  t.vector(&Shape::min, "min", "Lower corner", "m").within(farthest).slider(-5, 5).reset().help("Of box and where.");
  t.vector(&Shape::max, "max", "Upper corner", "m").within(farthest).slider(-5, 5).reset().help("Of box and where.");
  t.vector(&Shape::center, "center", "Centre", "m").within(farthest).slider(-5, 5).reset().help("Of ball.");
  t.vector(&Shape::from, "from", "First end", "m")
      .within(farthest)
      .slider(-5, 5)
      .reset()
      .help("Of cylinder: centre of one end.");
  t.vector(&Shape::to, "to", "Second end", "m")
      .within(farthest)
      .slider(-5, 5)
      .reset()
      .help("Of cylinder: centre of the other end.");
  t.number(&Shape::radius, "radius", "Radius", "m")
      .above(0)
      .at_most(farthest)
      .log_slider(0.01, 5)
      .reset()
      .help("Of ball and cylinder.");
  t.leaf(SettingKind::vector, "points", "Points", "m", read_points,
         [](const Shape& o, const WriteStyle& style) {
           Json array = Json::array();
           for (const Vec3& point : o.points) array.push_back(to_json(point, style.dimension));
           return array;
         })
      .within(farthest)
      .slider(-5, 5)
      .reset()
      .help("Of polygon: its corners in order, either way round.");
  t.vector(&Shape::point, "point", "Point", "m")
      .within(farthest)
      .slider(-5, 5)
      .reset()
      .help("Of half_space: any point of its face.");
  t.vector(&Shape::normal, "normal", "Normal", "")
      .within(farthest)
      .slider(-1, 1)
      .reset()
      .help("Of half_space: points out of it; any length but 0.");
  t.leaf(SettingKind::formula, "expression", "Expression", "", read_where,
         [](const Shape& o, const WriteStyle&) { return Json(o.where); })
      .reset()
      .help("Of where: the shape is where this is positive, in X Y Z.");
}

void read_at(Reader& reader, const Json& json, ShapeUse use, Shape& shape, int depth);

void read_members(Reader& reader, const Json& json, ShapeUse use, Shape& shape, int depth) {
  if (!json.is_array() || json.empty()) return reader.refuse(describe(json), "an array of one shape or more");
  if (depth == deepest)
    return reader.refuse("shapes inside one another", "at most " + std::to_string(deepest) + " deep");
  if (!check_count(reader, json.size(), most_members, "shapes")) return;
  shape.of.resize(json.size());
  for (std::size_t k = 0; k < json.size(); ++k) {
    const Reader::Step step(reader, k);
    read_at(reader, json[k], use, shape.of[k], depth + 1);
  }
}

std::size_t count_members(const Shape& shape) {
  std::size_t count = shape.of.size();
  for (const Shape& member : shape.of) count += count_members(member);
  return count;
}

/// Reads "type"; nullptr after a problem.
const ShapeType* read_type(Reader& reader, const Json& json, Shape& shape) {
  const Reader::Step step(reader, "type");
  const Key& key = *shape_table().find("type");
  if (!json.contains("type")) {
    reader.refuse("nothing", suggest("", key.setting.choices) + "; this key is required");
    return nullptr;
  }
  if (!read_choice(reader, json["type"], key.setting, shape.type)) return nullptr;
  const ShapeType* type = find_shape_type(shape.type);
  if (type->dimension != 0 && type->dimension != reader.dimension()) {
    reader.refuse(describe(json["type"]), "shapes for " + std::to_string(reader.dimension()) +
                                              "D; this one needs \"dimension\" " + std::to_string(type->dimension));
    return nullptr;
  }
  return type;
}

void read_at(Reader& reader, const Json& json, ShapeUse use, Shape& shape, int depth) {
  if (!json.is_object()) return reader.refuse(describe(json), "a shape { \"type\": ..., ... }");
  const std::size_t before = reader.refused();
  const ShapeType* type = read_type(reader, json, shape);
  if (!type) return;
  std::vector<std::string> known = {"type"};
  known.insert(known.end(), type->keys.begin(), type->keys.end());
  known.insert(known.end(), common_keys().begin(), common_keys().end());
  for (const auto& [name, value] : json.items()) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      refuse_unknown(reader, name, known);
      continue;
    }
    const Reader::Step step(reader, name);
    if (name == "of") {
      read_members(reader, value, use, shape, depth);
    } else if (name != "type") {
      shape_table().find(name)->read(reader, value, &shape);
    }
  }
  for (const std::string_view name : type->keys) {
    const std::string key(name);
    if (!json.contains(key)) reader.refuse("/" + key, "nothing", "a value; " + shape.type + " needs this key");
  }
  if (reader.refused() == before)
    check_shape(reader, shape, depth == 0 ? use : use == ShapeUse::body ? ShapeUse::boundary : use);
}

Json schema_of_key(const Key& key) {
  const std::string& name = key.setting.pointer;
  const Json number = {{"type", Json::array({"number", "string"})}};
  Json schema = key.setting.kind == SettingKind::vector ? Json{{"type", "array"}, {"items", number}} : number;
  if (name == "points")
    schema = Json{{"type", "array"}, {"minItems", 3}, {"items", {{"type", "array"}, {"items", number}}}};
  if (name == "of") schema = Json{{"type", "array"}, {"minItems", 1}, {"items", {{"$ref", "#/$defs/shape"}}}};
  if (name == "rotate") schema = Json{{"type", Json::array({"number", "string", "object"})}};
  if (name == "radius" || name == "scale") schema["exclusiveMinimum"] = 0;
  schema["description"] = key.setting.help + (key.setting.unit.empty() ? "" : " [" + key.setting.unit + "]");
  return schema;
}

}  // namespace

const Table& shape_table() {
  static const Table table = [] {
    TableOf<Shape> t("Shape");
    t.choice(&Shape::type, "type", "Type")
        .choices(shape_choices())
        .required()
        .reset()
        .help("What kind of shape it is.");
    add_geometry(t);
    Key& of = t.own(Nesting::list, shape_table, "of", "Members");
    of.setting.help = "Of union, difference and intersection: the shapes that they are made of.";
    of.read = [](Reader&, const Json&, void*) {};  // read_members does, which knows the depth
    of.write = [](const void* o, const WriteStyle& style) {
      Json array = Json::array();
      for (const Shape& member : static_cast<const Shape*>(o)->of) array.push_back(write_shape(member, style));
      return array;
    };
    t.number(&Shape::scale, "scale", "Scale", "")
        .above(0)
        .at_most(1e6)
        .log_slider(0.1, 10)
        .reset()
        .help("Factor about the shape's centre; applied first.");
    t.leaf(SettingKind::number, "rotate", "Rotation", "degrees", read_rotation,
           [](const Shape& o, const WriteStyle& style) { return write_rotation(o, style.dimension); })
        .within(1e6)
        .slider(-180, 180)
        .reset()
        .help(
            "Anticlockwise about the shape's centre, after scaling. In 3D { \"axis\": [x, y, z], \"angle\": degrees "
            "}.");
    t.vector(&Shape::translate, "translate", "Translation", "m")
        .within(farthest)
        .slider(-5, 5)
        .reset()
        .help("Applied after scaling and rotating.");
    return t.take();
  }();
  return table;
}

void read_shape(Reader& reader, const Json& json, ShapeUse use, Shape& shape) {
  read_at(reader, json, use, shape, 0);
  check_count(reader, count_members(shape), most_members, "shapes inside one another");
}

Json write_shape(const Shape& shape, const WriteStyle& style) {
  Json object = {{"type", shape.type}};
  const ShapeType* type = find_shape_type(shape.type);
  if (!type) return object;
  for (const std::string_view key : type->keys)
    object[std::string(key)] = *shape_table().find(key)->write(&shape, style);
  for (const std::string& name : common_keys()) {
    const Key& key = *shape_table().find(name);
    std::optional<Json> value = key.write(&shape, style);
    if (style.defaults || value != key.fallback(style.dimension)) object[name] = *std::move(value);
  }
  return object;
}

Json shape_schema() {
  Json kinds = Json::array();
  for (const ShapeType& shape : shape_types()) {
    Json properties = {{"type", {{"const", shape.name}}}};
    Json required = Json::array({"type"});
    for (const std::string_view name : shape.keys) {
      properties[std::string(name)] = schema_of_key(*shape_table().find(name));
      required.push_back(name);
    }
    for (const std::string& name : common_keys()) properties[name] = schema_of_key(*shape_table().find(name));
    kinds.push_back({{"title", shape.label},
                     {"description", shape.help},
                     {"type", "object"},
                     {"properties", std::move(properties)},
                     {"required", std::move(required)},
                     {"additionalProperties", false}});
  }
  return {{"oneOf", std::move(kinds)}};
}

}  // namespace pf
