#include <numbers>

#include "core/scene/shapes/shape_solid.hpp"

namespace pf {
namespace {

using std::numbers::pi;

class Ball final : public ShapeSolid {
 public:
  Ball(const Vec3& center, double radius, int dimension)
      : ShapeSolid(dimension), center_(flat(center)), radius_(radius) {}

  double distance(const Vec3& p) const override { return (flat(p) - center_).norm() - radius_; }

  Vec3 normal(const Vec3& p) const override {
    const Vec3 r = flat(p) - center_;
    const double length = r.stableNorm();
    if (!(length > 0) || !std::isfinite(length)) return Vec3::UnitX();  // the centre has no nearest point
    return r / length;
  }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    const double d = distance(p);
    if (!inverted && d <= tolerance) normals.push_back(normal(p));
    if (inverted && d >= -tolerance) normals.push_back(-normal(p));
  }

  Bounds bounds() const override {
    const Vec3 r = flat(Vec3::Constant(radius_));
    return {center_ - r, center_ + r};
  }

  double measure(double) const override {
    return dimension() == 2 ? pi * radius_ * radius_ : 4.0 / 3.0 * pi * radius_ * radius_ * radius_;
  }

  void add_surface(double h, const Bounds&, std::vector<SurfacePoint>& points) const override {
    if (dimension() == 2) {
      add_ring(0, radius_, 2 * pi * radius_, h, points);
      return;
    }
    // Bands of equal height in latitude; Archimedes: a band's area is 2 pi r times its extent along the axis.
    const int bands = std::max(2, pieces(pi * radius_, h));
    for (int b = 0; b < bands; ++b) {
      const double top = std::cos(pi * b / bands), bottom = std::cos(pi * (b + 1) / bands);
      const double z = 0.5 * (top + bottom) * radius_;
      add_ring(z, std::sqrt(radius_ * radius_ - z * z), 2 * pi * radius_ * radius_ * (top - bottom), h, points);
    }
  }

 private:
  void add_ring(double z, double ring, double area, double h, std::vector<SurfacePoint>& points) const {
    const int n = std::max(3, pieces(2 * pi * ring, h));
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * pi * (i + 0.5) / n;
      const Vec3 r(ring * std::cos(angle), ring * std::sin(angle), z);
      points.push_back({center_ + r, r.normalized(), area / n});
    }
  }

  Vec3 center_;
  double radius_;
};

}  // namespace

SolidPointer make_ball(const Shape& shape, int dimension) {
  return std::make_unique<Ball>(shape.center, shape.radius, dimension);
}

}  // namespace pf
