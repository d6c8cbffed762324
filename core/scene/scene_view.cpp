#include "core/scene/scene_view.hpp"

#include "core/scene/solid.hpp"

namespace pf {

namespace {

RegionView region_view(const Shape& shape, const Scene& scene, std::string kind) {
  const std::shared_ptr<const Solid> solid = make_solid(shape, scene.dimension, scene.constants);
  const Bounds bounds = solid->bounds();
  return {[solid](const Vec3& p) { return solid->distance(p); }, bounds.min, bounds.max, std::move(kind)};
}

}  // namespace

SceneView make_scene_view(const Scene& scene) {
  SceneView view;
  for (const Boundary& boundary : scene.boundaries) {
    const std::shared_ptr<const Solid> solid = make_solid(boundary.shape, scene.dimension, scene.constants);
    const Bounds bounds = solid->bounds();
    const double sign = boundary.invert ? -1 : 1;
    view.boundaries.push_back(
        {[solid, sign](const Vec3& p) { return sign * solid->distance(p); }, bounds.min, bounds.max, boundary.contact});
  }
  for (const Constraint& c : scene.constraints) view.regions.push_back(region_view(c.region, scene, "constraint"));
  for (const Load& load : scene.loads) view.regions.push_back(region_view(load.region, scene, "load"));
  for (const Material& material : scene.materials) view.material_names.push_back(material.name);
  for (const Body& body : scene.bodies) view.body_names.push_back(body.name);
  return view;
}

}  // namespace pf
