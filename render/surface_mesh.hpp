// Rigid solids as triangles.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/snapshot.hpp"
#include "render/camera.hpp"

namespace pf {

struct SurfaceVertex {
  Vec3 position;
  Vec3 normal;  ///< out of the solid, unit
};

/// Zero surface of a signed distance in `bounds` by marching tetrahedra on cells of at most largest side /
/// `resolution`; three vertices a triangle. Vertices are moved onto the surface along the gradient.
std::vector<SurfaceVertex> surface_mesh(const std::function<double(const Vec3&)>& distance, const ViewBounds& bounds,
                                        int resolution);

/// The solid's surface is one plane, as a half-space's is.
struct Plane {
  Vec3 point, normal;
};
/// Decided by whether `distance` is affine in and around `near`.
std::optional<Plane> as_plane(const BoundaryView& solid, const ViewBounds& near);

}  // namespace pf
