#include "core/scene/shapes/cells.hpp"
#include "core/scene/shapes/shape_solid.hpp"

namespace pf {
namespace {

/// { expression > 0 } within a box.
class Where final : public ShapeSolid {
 public:
  Where(const Shape& shape, int dimension, const Constants& constants)
      : ShapeSolid(dimension),
        expression_(Expression::compile(shape.where, constants, mask_reference)),
        box_(make_box(shape, dimension)),
        size_((box_->bounds().max - box_->bounds().min).norm()) {}

  bool contains(const Vec3& p, double tolerance) const override {
    if (!box_->contains(p, tolerance)) return false;
    if (value(p) > 0) return true;
    const Level level = level_at(p);
    return level.smooth && level.distance <= tolerance;
  }
  double distance(const Vec3& p) const override { return larger(level_at(p).distance, box_->distance(p)); }
  bool distance_is_bound() const override { return false; }

  Vec3 normal(const Vec3& p) const override {
    const Level level = level_at(p);
    return level.distance >= box_->distance(p) ? level.normal : box_->normal(p);
  }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    const Level level = level_at(p);
    if (!inverted) {
      if (!contains(p, tolerance)) return;
      if (level.distance >= box_->distance(p)) {
        normals.push_back(level.normal);
      } else {
        box_->contact_normals(p, false, tolerance, normals);
      }
      return;
    }
    const std::size_t first = normals.size();
    box_->contact_normals(p, true, tolerance, normals);
    if (level.distance >= -tolerance) normals.push_back(-level.normal);
    drop_repeated(normals, first);
  }

  Bounds bounds() const override { return box_->bounds(); }

  double measure(double) const override {
    // Two resolutions: extrapolation removes the leading error of flat pieces on a curved surface.
    const int cells = dimension() == 2 ? 512 : 96;
    const double fine = inside_measure(level_set(), cells), coarse = inside_measure(level_set(), cells / 2);
    return std::max(0.0, fine + (fine - coarse) / 3);
  }

  void add_surface(double h, const Bounds& clip, std::vector<SurfacePoint>& points) const override {
    const Vec3 extent = bounds().max - bounds().min;
    add_level_surface(level_set(), std::clamp(pieces(extent.maxCoeff(), h), 16, dimension() == 2 ? 4096 : 256), points);
    std::vector<SurfacePoint> faces;
    box_->add_surface(h, clip, faces);
    for (const SurfacePoint& s : faces)
      if (value(s.position - 1e-6 * h * s.normal) > 0) points.push_back(s);
  }

 private:
  struct Level {
    double distance;  ///< to the level 0, to first order; negative inside
    Vec3 normal;      ///< out of the inside
    bool smooth;      ///< the expression has a slope here
  };

  double value(const Vec3& p) const {
    const std::array<double, variable_count> v = {p.x(), p.y(), dimension() == 2 ? 0 : p.z(), 0, 0, 0, 0};
    return expression_(std::span<const double>(v));
  }
  LevelSet level_set() const {
    return {[this](const Vec3& p) { return -value(p); },
            [this](const Vec3& first, const Vec3& step, std::span<double> values) { row(first, step, values); }, false,
            bounds(), dimension()};
  }
  void row(const Vec3& first, const Vec3& step, std::span<double> values) const {
    std::vector<double> X(values.size());
    for (std::size_t i = 0; i < X.size(); ++i) X[i] = first.x() + static_cast<double>(i) * step.x();
    const std::span<const double> Y(&first.y(), 1), Z(&first.z(), 1);
    expression_.evaluate({X, Y, Z, {}, {}, {}, {}}, values);
    for (double& v : values) v = -v;
  }

  Level level_at(const Vec3& p) const {
    std::array<Jet2, variable_count> v;
    for (int a = 0; a < dimension(); ++a) v[a] = Jet2::variable(p[a], a);
    const Jet2 f = expression_(std::span<const Jet2>(v));
    const Vec3 slope = flat(f.gradient.head<3>());
    const double length = slope.norm();
    if (!(length > 0) || !std::isfinite(length) || !std::isfinite(f.value)) return search(p, f.value > 0);
    return {std::clamp(-f.value / length, -size_, size_), -slope / length, true};
  }

  /// Without a slope (an expression of comparisons only): the smallest of a row of spheres around p that is partly
  /// inside and partly outside says how far and where the surface is.
  Level search(const Vec3& p, bool inside) const {
    for (double radius = size_ / 4096; radius <= size_; radius *= 2) {
      Vec3 normal = Vec3::Zero();
      bool mixed = false;
      for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j)
          for (int k = dimension() == 3 ? -2 : 0; k <= (dimension() == 3 ? 2 : 0); ++k) {
            if (std::max({std::abs(i), std::abs(j), std::abs(k)}) != 2) continue;
            const Vec3 direction = Vec3(i, j, k).normalized();
            const bool there = value(p + radius * direction) > 0;
            mixed |= there != inside;
            normal += there ? Vec3(-direction) : direction;
          }
      if (mixed && normal.norm() > 1e-9) return {inside ? -radius : radius, normal.normalized(), false};
    }
    return {inside ? -size_ : size_, box_->normal(p), false};
  }

  Expression expression_;
  SolidPointer box_;
  double size_;
};

}  // namespace

SolidPointer make_where(const Shape& shape, int dimension, const Constants& constants) {
  return std::make_unique<Where>(shape, dimension, constants);
}

}  // namespace pf
