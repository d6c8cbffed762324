// What the shapes have in common, and how each is made.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/scene/solid.hpp"

namespace pf {

/// Implements what follows from a signed distance; adds the clipped surface that booleans need of their members.
class ShapeSolid : public Solid {
 public:
  explicit ShapeSolid(int dimension) : dimension_(dimension) {}
  bool contains(const Vec3& p, double tolerance) const override { return distance(p) <= tolerance; }
  bool distance_is_bound() const override { return true; }
  std::vector<SurfacePoint> surface(double h) const final {
    std::vector<SurfacePoint> points;
    add_surface(h, bounds(), points);
    return points;
  }
  /// As surface(), appended; parts outside `clip` may be left out.
  virtual void add_surface(double h, const Bounds& clip, std::vector<SurfacePoint>& points) const = 0;
  int dimension() const { return dimension_; }

 protected:
  /// p with z = 0 in 2D.
  Vec3 flat(const Vec3& p) const { return dimension_ == 2 ? Vec3(p.x(), p.y(), 0) : p; }

 private:
  int dimension_;
};

using SolidPointer = std::unique_ptr<ShapeSolid>;

SolidPointer make_box(const Shape& shape, int dimension);
SolidPointer make_ball(const Shape& shape, int dimension);
SolidPointer make_cylinder(const Shape& shape);
SolidPointer make_polygon(const Shape& shape);
SolidPointer make_half_space(const Shape& shape, int dimension);
SolidPointer make_where(const Shape& shape, int dimension, const Constants& constants);
SolidPointer make_union(std::vector<SolidPointer> members, int dimension);
SolidPointer make_intersection(std::vector<SolidPointer> members, int dimension);
/// The first member without all others.
SolidPointer make_difference(std::vector<SolidPointer> members, int dimension);
/// x -> center + rotation scale (x - center) + translation.
SolidPointer make_transformed(SolidPointer inner, double scale, const Mat3& rotation, const Vec3& center,
                              const Vec3& translation);

/// How many equal pieces of at most h make up a length; at least 1.
inline int pieces(double length, double h) {
  return static_cast<int>(std::clamp(std::ceil(length / h * (1 - 1e-12)), 1.0, 1e6));
}
inline bool is_finite(const Bounds& b) {
  return b.min.allFinite() && b.max.allFinite();
}
/// Two vectors at right angles to the unit vector `n` and each other.
void complete_basis(const Vec3& n, Vec3& u, Vec3& v);
/// Of equal normals from number `first` on keeps the first.
void drop_repeated(std::vector<Vec3>& normals, std::size_t first);

}  // namespace pf
