#include "app/outline/items.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/widgets/setting_widget.hpp"
#include "core/params/problem.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {
namespace {

using nlohmann::json;

// clang-format off
const std::array groups{
    ItemGroup{ItemKind::material, "materials", "Materials", "material", nullptr, false,
              [](const Scene& s) { return s.materials.size(); }},
    ItemGroup{ItemKind::body, "bodies", "Bodies", "body", "shape", true,
              [](const Scene& s) { return s.bodies.size(); }},
    ItemGroup{ItemKind::boundary, "boundaries", "Walls", "wall", "shape", false,
              [](const Scene& s) { return s.boundaries.size(); }},
    ItemGroup{ItemKind::constraint, "constraints", "Supports", "support", "region", false,
              [](const Scene& s) { return s.constraints.size(); }},
    ItemGroup{ItemKind::load, "loads", "Loads", "load", "region", false,
              [](const Scene& s) { return s.loads.size(); }},
    ItemGroup{ItemKind::probe, "probes", "Probes", "probe", nullptr, true,
              [](const Scene& s) { return s.probes.size(); }}};
// clang-format on

json array_of(const Vec3& v, int dimension) {
  json a = json::array();
  for (int k = 0; k < dimension; ++k) a.push_back(v[k]);
  return a;
}

/// "block", "block 2", "block 3", ...: the first that no other has.
template <class Taken>
std::string free_name(std::string wanted, Taken&& taken) {
  const auto space = wanted.find_last_of(' ');
  if (space != std::string::npos && space + 1 < wanted.size() &&
      std::all_of(wanted.begin() + static_cast<std::ptrdiff_t>(space) + 1, wanted.end(),
                  [](char c) { return c >= '0' && c <= '9'; }))
    wanted.resize(space);
  if (!taken(wanted)) return wanted;
  for (int k = 2;; ++k)
    if (const std::string name = wanted + " " + std::to_string(k); !taken(name)) return name;
}

std::string free_body_name(const Scene& scene, const std::string& wanted) {
  return free_name(wanted, [&](const std::string& name) {
    return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& b) { return b.name == name; });
  });
}
std::string free_material_name(const Scene& scene, const std::string& wanted) {
  return free_name(wanted, [&](const std::string& name) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [&](const Material& m) { return m.name == name; });
  });
}
std::string free_probe_name(const Scene& scene, const std::string& wanted) {
  return free_name(wanted, [&](const std::string& name) {
    return std::any_of(scene.probes.begin(), scene.probes.end(), [&](const Probe& p) { return p.name == name; });
  });
}

json box(const Vec3& min, const Vec3& max, int dimension) {
  return {{"type", "box"}, {"min", array_of(min, dimension)}, {"max", array_of(max, dimension)}};
}

/// Above the others by two cells, a third as large.
json new_body_shape(const Scene& scene) {
  const Bounds all = bodies_bounds(scene);
  const double dx = scene.grid.spacing;
  const Vec3 size = all.max - all.min;
  const double least = std::min({size.x(), size.y(), scene.dimension == 2 ? size.y() : size.z()});
  const double side = std::max(3 * dx, std::round(least / 2 / dx) * dx);
  Vec3 low = snapped((all.min + all.max) / 2 - Vec3::Constant(side / 2), dx);
  low.y() = std::ceil(all.max.y() / dx) * dx + 2 * dx;
  return box(low, low + Vec3::Constant(side), scene.dimension);
}

/// A box about one side of the bodies: `axis`, at its lower or upper end.
json side_of(const Scene& scene, int axis, bool upper) {
  const Bounds all = bodies_bounds(scene);
  const double dx = scene.grid.spacing;
  Vec3 low = all.min - Vec3::Constant(dx), high = all.max + Vec3::Constant(dx);
  (upper ? low : high)[axis] = upper ? all.max[axis] : all.min[axis];
  return box(low, high, scene.dimension);
}

json added_item(const Scene& scene, ItemKind kind) {
  const int d = scene.dimension;
  const Bounds all = bodies_bounds(scene);
  switch (kind) {
    case ItemKind::boundary:
      return {{"shape",
               {{"type", "half_space"},
                {"point", array_of({0, std::floor(all.min.y() / scene.grid.spacing) * scene.grid.spacing, 0}, d)},
                {"normal", array_of(Vec3::UnitY(), d)}}}};
    case ItemKind::constraint:
      return {{"region", side_of(scene, 0, false)}, {"fix", std::vector<bool>(static_cast<std::size_t>(d), true)}};
    case ItemKind::load:
      return {{"body", scene.bodies.front().name},
              {"region", side_of(scene, 1, true)},
              {"traction", array_of({0, -1000, 0}, d)}};
    case ItemKind::probe:
      return {{"name", free_probe_name(scene, "probe")}, {"at", array_of((all.min + all.max) / 2, d)}};
    default:
      return {};
  }
}

}  // namespace

Vec3 snapped(const Vec3& at, double grid) {
  return {grid * std::round(at.x() / grid), grid * std::round(at.y() / grid), grid * std::round(at.z() / grid)};
}

std::span<const ItemGroup> item_groups() {
  return groups;
}

const ItemGroup& group_of(ItemKind kind) {
  return *std::find_if(groups.begin(), groups.end(), [&](const ItemGroup& g) { return g.kind == kind; });
}

bool exists(const Scene& scene, const SceneItem& item) {
  return item.index < group_of(item.kind).count(scene);
}

std::string item_name(const Scene& scene, const SceneItem& item) {
  const std::size_t i = item.index;
  std::string name;
  if (item.kind == ItemKind::material) name = scene.materials[i].name;
  if (item.kind == ItemKind::body) name = scene.bodies[i].name;
  if (item.kind == ItemKind::probe) name = scene.probes[i].name;
  if (!name.empty()) return name;
  std::string word = group_of(item.kind).singular;
  word[0] = static_cast<char>(word[0] - 'a' + 'A');
  return word + " " + std::to_string(i + 1);
}

std::string item_pointer(const Scene& scene, const SceneItem& item) {
  const ItemGroup& group = group_of(item.kind);
  if (item.kind == ItemKind::material) return pointer_to({group.key, scene.materials[item.index].name});
  return pointer_to({group.key, std::to_string(item.index)});
}

const Shape* item_shape(const Scene& scene, const SceneItem& item) {
  if (!exists(scene, item)) return nullptr;
  switch (item.kind) {
    case ItemKind::body:
      return &scene.bodies[item.index].shape;
    case ItemKind::boundary:
      return &scene.boundaries[item.index].shape;
    case ItemKind::constraint:
      return &scene.constraints[item.index].region;
    case ItemKind::load:
      return &scene.loads[item.index].region;
    default:
      return nullptr;
  }
}

Bounds bodies_bounds(const Scene& scene) {
  Bounds all{Vec3::Constant(std::numeric_limits<double>::infinity()),
             Vec3::Constant(-std::numeric_limits<double>::infinity())};
  for (const Body& body : scene.bodies) {
    const Bounds b = make_solid(body.shape, scene.dimension, scene.constants)->bounds();
    all.min = all.min.cwiseMin(b.min);
    all.max = all.max.cwiseMax(b.max);
  }
  if (scene.bodies.empty()) all = {Vec3::Zero(), Vec3::Ones()};
  if (scene.dimension == 2) all.min.z() = all.max.z() = 0;
  return all;
}

std::vector<Edit> added_body(const Scene& scene, const json& shape, const std::string& material) {
  const std::string name = shape.value("type", "body");
  return {{"/bodies/-", {{"name", free_body_name(scene, name)}, {"material", material}, {"shape", shape}}}};
}

std::vector<Edit> added(const Scene& scene, ItemKind kind) {
  if (kind == ItemKind::body) return added_body(scene, new_body_shape(scene), scene.materials.front().name);
  if (kind == ItemKind::material) {
    const std::string name = free_material_name(scene, "material");
    const json like = to_json(scene)["materials"][scene.materials.front().name];
    return {{pointer_to({"materials", name}), like}};
  }
  return {{std::string("/") + group_of(kind).key + "/-", added_item(scene, kind)}};
}

std::vector<Edit> doubled(const Scene& scene, const SceneItem& item) {
  const json all = to_json(scene);
  json copy = all.at(json::json_pointer(item_pointer(scene, item)));
  if (item.kind == ItemKind::material)
    return {{pointer_to({"materials", free_material_name(scene, scene.materials[item.index].name)}), copy}};
  if (item.kind == ItemKind::body) {
    copy["name"] = free_body_name(scene, scene.bodies[item.index].name);
    // Beside it, a cell apart.
    const Shape& shape = scene.bodies[item.index].shape;
    const Bounds b = make_solid(shape, scene.dimension, scene.constants)->bounds();
    const double dx = scene.grid.spacing;
    Vec3 translate = shape.translate;
    translate.x() += std::ceil((b.max.x() - b.min.x()) / dx) * dx + dx;
    copy["shape"]["translate"] = array_of(translate, scene.dimension);
  }
  if (item.kind == ItemKind::probe) copy["name"] = free_probe_name(scene, scene.probes[item.index].name);
  return {{std::string("/") + group_of(item.kind).key + "/-", copy}};
}

std::vector<Edit> deleted(const Scene& scene, const SceneItem& item) {
  const std::string key = group_of(item.kind).key;
  json list = to_json(scene).at(key);
  if (item.kind == ItemKind::material)
    list.erase(scene.materials[item.index].name);
  else
    list.erase(item.index);
  return {{"/" + key, list}};
}

bool edit_scene(AppContext& context, const std::vector<Edit>& edits) {
  if (!context.change(edits)) {
    if (!context.problems.empty()) {
      const Problem& p = context.problems.front();
      context.notify("That cannot be: " + p.found + (p.allowed.empty() ? "" : ". Allowed: " + p.allowed));
    }
    return false;
  }
  // Nothing is lost by it.
  const SessionStatus status = context.session.status();
  const bool enters = std::all_of(edits.begin(), edits.end(), [](const Edit& e) {
    return e.pointer == "/bodies/-" || e.pointer.starts_with("/probes");
  });
  if (status.reached == 0 && status.state == RunState::paused && !enters) context.session.reset();
  return true;
}

}  // namespace pf::app
