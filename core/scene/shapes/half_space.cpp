#include "core/scene/shapes/shape_solid.hpp"

namespace pf {
namespace {

class HalfSpace final : public ShapeSolid {
 public:
  HalfSpace(const Vec3& point, const Vec3& normal, int dimension)
      : ShapeSolid(dimension), point_(flat(point)), normal_(flat(normal).stableNormalized()) {}

  double distance(const Vec3& p) const override { return (flat(p) - point_).dot(normal_); }
  Vec3 normal(const Vec3&) const override { return normal_; }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    const double d = distance(p);
    if (!inverted && d <= tolerance) normals.push_back(normal_);
    if (inverted && d >= -tolerance) normals.push_back(-normal_);
  }

  Bounds bounds() const override {
    const Vec3 infinite = flat(Vec3::Constant(std::numeric_limits<double>::infinity()));
    Bounds b{-infinite, infinite};
    for (int a = 0; a < dimension(); ++a) {
      if (normal_[a] == 1) b.max[a] = point_[a];
      if (normal_[a] == -1) b.min[a] = point_[a];
    }
    return b;
  }

  double measure(double) const override { return std::numeric_limits<double>::infinity(); }

  /// A lattice on the plane, large enough for the clip's circumscribed ball.
  void add_surface(double h, const Bounds& clip, std::vector<SurfacePoint>& points) const override {
    if (!is_finite(clip)) return;
    const Vec3 middle = 0.5 * (clip.min + clip.max);
    const Vec3 center = middle - distance(middle) * normal_;
    const double radius = 0.5 * (clip.max - clip.min).norm();
    Vec3 u(-normal_.y(), normal_.x(), 0), v = Vec3::Zero();
    if (dimension() == 3) complete_basis(normal_, u, v);
    const int n = pieces(2 * radius, h), rows = dimension() == 3 ? n : 1;
    const double step = 2 * radius / n;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < n; ++i) {
        const double a = (i + 0.5) * step - radius, b = (j + 0.5) * step - radius;
        const Vec3 p = center + a * u + b * v;
        if ((p.array() < clip.min.array() - h).any() || (p.array() > clip.max.array() + h).any()) continue;
        points.push_back({p, normal_, dimension() == 3 ? step * step : step});
      }
    }
  }

 private:
  Vec3 point_, normal_;
};

}  // namespace

SolidPointer make_half_space(const Shape& shape, int dimension) {
  return std::make_unique<HalfSpace>(shape.point, shape.normal, dimension);
}

}  // namespace pf
