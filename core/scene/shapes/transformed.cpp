#include "core/scene/shapes/shape_solid.hpp"

namespace pf {
namespace {

/// Bounds of A x + b for x in `bounds`, which may be infinite.
Bounds mapped(const Bounds& bounds, const Mat3& A, const Vec3& b) {
  Bounds result{b, b};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (A(i, j) == 0) continue;  // not 0 * infinity
      const double u = A(i, j) * bounds.min[j], v = A(i, j) * bounds.max[j];
      result.min[i] += std::min(u, v);
      result.max[i] += std::max(u, v);
    }
  return result;
}

/// x -> c + R s (x - c) + T, with c the inner shape's centre.
class Transformed final : public ShapeSolid {
 public:
  Transformed(SolidPointer inner, double scale, const Mat3& rotation, const Vec3& center, const Vec3& translation)
      : ShapeSolid(inner->dimension()),
        inner_(std::move(inner)),
        scale_(scale),
        rotation_(rotation),
        center_(center),
        moved_(center + translation) {}

  bool contains(const Vec3& p, double tolerance) const override {
    return inner_->contains(to_inner(p), tolerance / scale_);
  }
  double distance(const Vec3& p) const override { return scale_ * inner_->distance(to_inner(p)); }
  bool distance_is_bound() const override { return inner_->distance_is_bound(); }
  Vec3 normal(const Vec3& p) const override { return rotation_ * inner_->normal(to_inner(p)); }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    const std::size_t before = normals.size();
    inner_->contact_normals(to_inner(p), inverted, tolerance / scale_, normals);
    for (std::size_t i = before; i < normals.size(); ++i) normals[i] = rotation_ * normals[i];
  }

  Bounds bounds() const override {
    const Mat3 A = scale_ * rotation_;
    return mapped(inner_->bounds(), A, moved_ - A * center_);
  }

  double measure(double h) const override { return std::pow(scale_, dimension()) * inner_->measure(h / scale_); }

  void add_surface(double h, const Bounds& clip, std::vector<SurfacePoint>& points) const override {
    const std::size_t before = points.size();
    const Mat3 A = rotation_.transpose() / scale_;
    inner_->add_surface(h / scale_, mapped(clip, A, center_ - A * moved_), points);
    for (std::size_t i = before; i < points.size(); ++i) {
      SurfacePoint& s = points[i];
      s.position = moved_ + scale_ * (rotation_ * (s.position - center_));
      s.normal = rotation_ * s.normal;
      s.area *= std::pow(scale_, dimension() - 1);
    }
  }

 private:
  Vec3 to_inner(const Vec3& p) const { return center_ + rotation_.transpose() * (flat(p) - moved_) / scale_; }

  SolidPointer inner_;
  double scale_;
  Mat3 rotation_;
  Vec3 center_, moved_;
};

}  // namespace

SolidPointer make_transformed(SolidPointer inner, double scale, const Mat3& rotation, const Vec3& center,
                              const Vec3& translation) {
  return std::make_unique<Transformed>(std::move(inner), scale, rotation, center, translation);
}

}  // namespace pf
