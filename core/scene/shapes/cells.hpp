// Integration over { value < 0 } and over its surface by cells: a tree of boxes refined where the surface is.
#pragma once

#include <functional>
#include <vector>

#include "core/scene/solid.hpp"

namespace pf {

struct LevelSet {
  std::function<double(const Vec3&)> value;  ///< negative inside; may jump
  bool is_bound;                             ///< |value(p)| is at most p's distance to the surface
  Bounds domain;                             ///< finite; what lies outside is left out
  int dimension;
};

/// Area or volume of the inside. `cells`: of the smallest size along the domain's longest side. Inside a smallest
/// cell the surface is flat between the points where it cuts the edges, which are found to a fraction of a cell:
/// second order for smooth surfaces. Where |value| is no bound, features below a quarter of `cells` may be missed.
double inside_measure(const LevelSet& set, int cells);

/// Appends a point a smallest cell of the surface: its pieces' centre, mean outward normal and area.
void add_level_surface(const LevelSet& set, int cells, std::vector<SurfacePoint>& points);

}  // namespace pf
