// What a scene is made of as things that can be selected, added, doubled and deleted.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/context.hpp"
#include "core/scene/solid.hpp"

namespace pf::app {

struct ItemGroup {
  ItemKind kind;
  const char* key;       ///< of the scene: "bodies"
  const char* title;     ///< "Bodies"
  const char* singular;  ///< "body"
  const char* shape;     ///< key of its shape: "shape", "region"; null: it has none
  bool enters;           ///< a new one enters the running simulation
  std::size_t (*count)(const Scene&);
};
/// All groups, as the outline lists them.
std::span<const ItemGroup> item_groups();
const ItemGroup& group_of(ItemKind kind);

/// As people read it: its name, or "Wall 2".
std::string item_name(const Scene& scene, const SceneItem& item);
/// Where it stands in the scene's JSON: "/bodies/0", "/materials/rubber".
std::string item_pointer(const Scene& scene, const SceneItem& item);
/// Whether the scene has it (still).
bool exists(const Scene& scene, const SceneItem& item);
/// Its shape, or nullptr.
const Shape* item_shape(const Scene& scene, const SceneItem& item);

/// One that fits this scene: a body above the others, a floor below them, ...
std::vector<Edit> added(const Scene& scene, ItemKind kind);
/// A body of this shape.
std::vector<Edit> added_body(const Scene& scene, const nlohmann::json& shape, const std::string& material);
std::vector<Edit> doubled(const Scene& scene, const SceneItem& item);
std::vector<Edit> deleted(const Scene& scene, const SceneItem& item);

/// The nearest multiple of `grid`, component by component.
Vec3 snapped(const Vec3& at, double grid);
/// Bounds of all bodies at t = 0; of a unit about the origin where there are none.
Bounds bodies_bounds(const Scene& scene);

/// Applies the edits; what was wrong with refused ones is told at the window's edge. What needs a reset gets it at once
/// where nothing has been simulated yet. True when accepted.
bool edit_scene(AppContext& context, const std::vector<Edit>& edits);

}  // namespace pf::app
