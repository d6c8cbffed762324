// The shapes of strokes: what a brush has gone over since it was last heard of.
#pragma once

#include <vector>

#include "app/tools/tool.hpp"
#include "core/scene/scene.hpp"

namespace pf::app {

/// Balls of that radius about the places from `from` (left out, unless it is the only one) to `to`: close enough that
/// their union has no visible notches.
Shape swept_balls(const Vec3& from, const Vec3& to, double radius);

/// Of a view in perspective: cylinders about the rays from one mouse to the other, as deep as the particles are.
/// `near`: a point of the material, where the brush has its radius and the mouse its way measured.
Shape swept_rays(const ViewMouse& from, const ViewMouse& to, const Vec3& near, double radius, const Snapshot& s);

/// The particle that the ray meets first, within `reach` of it; 3D. Costs a look at each of them.
std::optional<Vec3> met_first(const ViewMouse& mouse, const Snapshot& s, double reach);

}  // namespace pf::app
