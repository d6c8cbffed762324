// A shape as lines, for marks over the view.
#pragma once

#include <vector>

#include "app/tools/tool.hpp"
#include "core/scene/scene.hpp"

namespace pf::app {

/// Polylines along the shape's rim: exact for box, ball, polygon and half space (so far as `reach` [m]) in 2D, traced
/// for others; in 3D the edges of its bounds, and three circles of a ball.
std::vector<std::vector<Vec3>> shape_lines(const Shape& shape, const Scene& scene, double reach);

/// The middle of the shape and the radius of a ball about it; a half space has its point and a cell.
struct Around {
  Vec3 centre = Vec3::Zero();
  double radius = 0;
};
Around around(const Shape& shape, const Scene& scene);

/// Bright on a dark rim, so that it shows on every colour.
void draw_lines(Painter& painter, const ViewMap& map, const std::vector<std::vector<Vec3>>& lines, Color color,
                bool dashed = false);

/// The rim of what is selected: where it stands at t = 0, dashed once it has moved on from there.
void draw_selection(Painter& painter, const ViewMap& map, const AppContext& context);

}  // namespace pf::app
