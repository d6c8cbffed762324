// A shape made ready for use: containment, distance, normals, exact measure, surface quadrature.
// In 2D every z is 0 and that of an argument is ignored; areas and volumes are per unit thickness.
#pragma once

#include <memory>
#include <vector>

#include "core/math/expression.hpp"
#include "core/scene/scene.hpp"

namespace pf {

/// Axis-aligned bounds; infinite where the shape is (half spaces).
struct Bounds {
  Vec3 min, max;
};

/// A quadrature point of a reference surface: THEORY T3, "points of the loaded surface".
struct SurfacePoint {
  Vec3 position;
  Vec3 normal;  ///< outward, unit
  double area;  ///< [m^2]; in 2D length times unit thickness
};

/// A closed set of points in 2D or 3D. `tolerance` is absolute [m]; INTERFACE fine print 4 uses 1e-9 dx.
class Solid {
 public:
  virtual ~Solid() = default;
  virtual bool contains(const Vec3& p, double tolerance) const = 0;
  /// Signed distance, negative inside; exact for primitives, a bound of the right sign for booleans and `where`.
  virtual double distance(const Vec3& p) const = 0;
  /// |distance(p)| never exceeds the distance from p to the surface: a ball of that radius has no surface in it.
  virtual bool distance_is_bound() const = 0;
  /// Outward unit normal of the nearest surface point (gradient of distance()).
  virtual Vec3 normal(const Vec3& p) const = 0;
  /// Contact (THEORY T7): appends the unit normals, pointing out of the solid, of every face that p lies behind.
  /// Not inverted: the nearest face (a convex body pushes one way); union: those of every member that holds p.
  /// Inverted (the solid is the outside): every face of the container beyond which p lies, so that a corner
  /// gives two or three constraints and not one diagonal one. Nothing when p is outside the solid.
  virtual void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const = 0;
  virtual Bounds bounds() const = 0;
  /// Area (2D, unit thickness) or volume; exact for box, ball, cylinder and polygon, by sub-cell integration
  /// with cell size `h` otherwise. Infinite for unbounded shapes.
  virtual double measure(double h) const = 0;
  /// Points of the surface, spaced by at most `h`, whose areas add up to the surface's own (booleans and `where`: to
  /// the order of h). Faces without end (a half space by itself) have none.
  virtual std::vector<SurfacePoint> surface(double h) const = 0;
};

/// `shape` has been checked: its type exists in this dimension, its numbers are finite, its members are there; else
/// std::invalid_argument. Expressions in it may use `constants` (else ExpressionError). `scale`, `rotate` and
/// `translate` apply about the centre of the shape's bounds; a half space's centre is its point, and where a boolean
/// has no end its centre has coordinate 0.
std::unique_ptr<Solid> make_solid(const Shape& shape, int dimension, const Constants& constants);

}  // namespace pf
