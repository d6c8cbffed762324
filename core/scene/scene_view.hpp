// The parts of a scene that are drawn but never change: boundaries, regions, names.
#pragma once

#include "core/scene/scene.hpp"
#include "core/snapshot.hpp"

namespace pf {

/// Distance functions are thread-safe and outlive the scene; those of inverted boundaries are negative outside the
/// shape.
SceneView make_scene_view(const Scene& scene);

}  // namespace pf
