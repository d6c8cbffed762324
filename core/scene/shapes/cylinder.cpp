#include <numbers>

#include "core/scene/shapes/shape_solid.hpp"

namespace pf {
namespace {

using std::numbers::pi;

/// A solid, capped cylinder; 3D.
class Cylinder final : public ShapeSolid {
 public:
  Cylinder(const Vec3& from, const Vec3& to, double radius)
      : ShapeSolid(3), center_(0.5 * (from + to)), half_(0.5 * (to - from).norm()), radius_(radius) {
    axis_ = half_ > 0 ? Vec3((to - from) / (2 * half_)) : Vec3::UnitZ();
    complete_basis(axis_, u_, v_);
  }

  double distance(const Vec3& p) const override {
    const Local q = local(p);
    const double side = q.radial - radius_, cap = std::abs(q.axial) - half_;
    if (side > 0 && cap > 0) return std::hypot(side, cap);
    return larger(side, cap);
  }

  Vec3 normal(const Vec3& p) const override {
    const Local q = local(p);
    const double side = q.radial - radius_, cap = std::abs(q.axial) - half_;
    if (side > 0 && cap > 0) return (side * q.direction + cap * cap_normal(q)).stableNormalized();
    return side >= cap ? q.direction : cap_normal(q);
  }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    const Local q = local(p);
    const double side = q.radial - radius_, cap = std::abs(q.axial) - half_;
    if (!inverted) {
      if (contains(p, tolerance)) normals.push_back(side >= cap ? q.direction : cap_normal(q));
      return;
    }
    if (side >= -tolerance) normals.push_back(-q.direction);
    if (q.axial >= half_ - tolerance) normals.push_back(-axis_);
    if (q.axial <= -half_ + tolerance) normals.push_back(axis_);
  }

  Bounds bounds() const override {
    // A disc of normal n reaches sqrt(1 - n_a^2) r along axis a.
    const Vec3 disc = radius_ * (1 - axis_.array().square()).max(0.0).sqrt().matrix();
    const Vec3 reach = half_ * axis_.cwiseAbs() + disc;
    return {center_ - reach, center_ + reach};
  }

  double measure(double) const override { return 2 * half_ * pi * radius_ * radius_; }

  void add_surface(double h, const Bounds&, std::vector<SurfacePoint>& points) const override {
    const int around = std::max(3, pieces(2 * pi * radius_, h)), along = pieces(2 * half_, h);
    const double area = 2 * pi * radius_ / around * (2 * half_ / along);
    for (int j = 0; j < along; ++j) {
      const double z = (2 * (j + 0.5) / along - 1) * half_;
      for (int i = 0; i < around; ++i) {
        const Vec3 n = direction(2 * pi * (i + 0.5) / around);
        points.push_back({center_ + z * axis_ + radius_ * n, n, area});
      }
    }
    for (const double sign : {-1.0, 1.0}) add_cap(sign, h, points);
  }

 private:
  struct Local {
    double axial, radial;
    Vec3 direction;  ///< away from the axis, unit
  };
  Local local(const Vec3& p) const {
    const Vec3 r = p - center_;
    const double axial = r.dot(axis_);
    const Vec3 across = r - axial * axis_;
    const double radial = across.norm();
    return {axial, radial, radial > 0 && std::isfinite(radial) ? Vec3(across / radial) : u_};
  }
  Vec3 cap_normal(const Local& q) const { return q.axial < 0 ? Vec3(-axis_) : axis_; }
  Vec3 direction(double angle) const { return std::cos(angle) * u_ + std::sin(angle) * v_; }

  void add_cap(double sign, double h, std::vector<SurfacePoint>& points) const {
    const int rings = pieces(radius_, h);
    for (int k = 0; k < rings; ++k) {
      const double inner = radius_ * k / rings, outer = radius_ * (k + 1) / rings, mid = 0.5 * (inner + outer);
      const int around = std::max(3, pieces(2 * pi * mid, h));
      const double area = pi * (outer * outer - inner * inner) / around;
      for (int i = 0; i < around; ++i)
        points.push_back(
            {center_ + sign * half_ * axis_ + mid * direction(2 * pi * (i + 0.5) / around), sign * axis_, area});
    }
  }

  Vec3 center_, axis_, u_, v_;
  double half_, radius_;
};

}  // namespace

SolidPointer make_cylinder(const Shape& shape) {
  return std::make_unique<Cylinder>(shape.from, shape.to, shape.radius);
}

}  // namespace pf
