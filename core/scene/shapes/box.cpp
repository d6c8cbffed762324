#include "core/scene/shapes/shape_solid.hpp"

namespace pf {
namespace {

class Box final : public ShapeSolid {
 public:
  Box(const Vec3& min, const Vec3& max, int dimension)
      : ShapeSolid(dimension), min_(flat(min)), max_(flat(max)), center_(0.5 * min_ + 0.5 * max_) {}

  double distance(const Vec3& p) const override {
    const Vec3 q = beyond(p);
    double inside = q[0], outside = 0;
    for (int a = 0; a < dimension(); ++a) {
      inside = larger(inside, q[a]);  // keeps NaN
      outside += q[a] > 0 ? q[a] * q[a] : 0;
    }
    return inside > 0 ? std::sqrt(outside) : inside;
  }

  Vec3 normal(const Vec3& p) const override {
    const Vec3 q = beyond(p).cwiseMax(0.0);
    const double length = q.stableNorm();
    if (!(length > 0) || !std::isfinite(length)) return nearest_face(p);
    return (q / length).cwiseProduct(side(p));
  }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    if (!inverted) {
      if (contains(p, tolerance)) normals.push_back(nearest_face(p));
      return;
    }
    for (int a = 0; a < dimension(); ++a) {
      if (p[a] <= min_[a] + tolerance) normals.push_back(Vec3::Unit(a));
      if (p[a] >= max_[a] - tolerance) normals.push_back(-Vec3::Unit(a));
    }
  }

  Bounds bounds() const override { return {min_, max_}; }

  double measure(double) const override { return (max_ - min_).head(dimension()).prod(); }

  void add_surface(double h, const Bounds&, std::vector<SurfacePoint>& points) const override {
    for (int a = 0; a < dimension(); ++a) {
      for (const double sign : {-1.0, 1.0}) add_face(a, sign, h, points);
    }
  }

 private:
  /// By how much p lies beyond the face of its side, negative before it; meaningful up to the dimension.
  Vec3 beyond(const Vec3& p) const {
    Vec3 q = Vec3::Zero();
    for (int a = 0; a < dimension(); ++a) q[a] = larger(min_[a] - p[a], p[a] - max_[a]);
    return q;
  }
  Vec3 side(const Vec3& p) const {
    return (flat(p) - center_).unaryExpr([](double v) { return v < 0 ? -1.0 : 1.0; });
  }
  Vec3 nearest_face(const Vec3& p) const {
    const Vec3 q = beyond(p);
    int axis = 0;
    for (int a = 1; a < dimension(); ++a)
      if (q[a] > q[axis]) axis = a;
    return side(p)[axis] * Vec3::Unit(axis);
  }

  void add_face(int axis, double sign, double h, std::vector<SurfacePoint>& points) const {
    const Vec3 size = max_ - min_;
    const int u = (axis + 1) % dimension(), v = dimension() == 3 ? (axis + 2) % 3 : 2;
    const int nu = pieces(size[u], h), nv = dimension() == 3 ? pieces(size[v], h) : 1;
    const double area = size[u] / nu * (dimension() == 3 ? size[v] / nv : 1);
    for (int j = 0; j < nv; ++j) {
      for (int i = 0; i < nu; ++i) {
        Vec3 p = min_;
        p[axis] = sign < 0 ? min_[axis] : max_[axis];
        p[u] += (i + 0.5) * size[u] / nu;
        if (dimension() == 3) p[v] += (j + 0.5) * size[v] / nv;
        points.push_back({p, sign * Vec3::Unit(axis), area});
      }
    }
  }

  Vec3 min_, max_, center_;
};

}  // namespace

SolidPointer make_box(const Shape& shape, int dimension) {
  return std::make_unique<Box>(shape.min, shape.max, dimension);
}

}  // namespace pf
