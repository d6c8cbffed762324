// Integration over { value < 0 } and over its surface by small boxes, here called cells.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/scene/shapes/moments.hpp"
#include "core/scene/solid.hpp"

namespace pf {

/// Area in 2D, volume in 3D, of a box with these sides.
inline double box_measure(const Vec3& sides, int dimension) {
  return sides.x() * sides.y() * (dimension == 3 ? sides.z() : 1);
}

struct LevelSet {
  std::function<double(const Vec3&)> value;  ///< negative inside; may jump; NaN counts as outside
  /// Optional: the values at first, first + step, first + 2 step, ..., where that is faster than one by one.
  std::function<void(const Vec3& first, const Vec3& step, std::span<double> values)> row;
  bool is_bound;  ///< |value(p)| is at most p's distance to the surface
  Bounds domain;  ///< finite; what lies outside is left out
  int dimension;
};

/// Area or volume of the inside. `cells`: along the domain's longest side. Inside a cell the surface is flat between
/// the points where it cuts the edges, which are found to a small part of a cell: second order for smooth surfaces.
/// Where |value| is a bound, only cells near the surface are looked at; else all, and what is smaller is missed.
double inside_measure(const LevelSet& set, int cells);

/// The same with the moments of the inside.
Moments inside_moments(const LevelSet& set, int cells);

/// Appends a point for each cell that the surface passes: its pieces' centre, mean outward normal and area.
void add_level_surface(const LevelSet& set, int cells, std::vector<SurfacePoint>& points);

}  // namespace pf
