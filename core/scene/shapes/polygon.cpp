#include "core/scene/shapes/shape_solid.hpp"

namespace pf {
namespace {

/// A polygon in 2D, convex or not, of either orientation. Of one that crosses itself the inside is what an odd
/// number of edges surrounds.
class Polygon final : public ShapeSolid {
 public:
  explicit Polygon(const std::vector<Vec3>& points) : ShapeSolid(2) {
    for (const Vec3& p : points)
      if (points_.empty() || flat(p) != points_.back()) points_.push_back(flat(p));
    while (points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
    area_ = signed_area();
    if (area_ < 0) {
      std::reverse(points_.begin(), points_.end());
      area_ = -area_;
    }
    convex_ = area_ > 0 && is_convex();
  }

  double distance(const Vec3& p) const override {
    const Nearest nearest = find_nearest(flat(p));
    const double d = (flat(p) - nearest.point).norm();
    return nearest.inside ? -d : d;
  }

  Vec3 normal(const Vec3& p) const override {
    const Nearest nearest = find_nearest(flat(p));
    const Vec3 r = flat(p) - nearest.point;
    const double length = r.norm();
    // On an edge or next to it the direction from the nearest point is only rounding.
    if (!(length > 1e-9 * edge(nearest.edge).norm()) || !std::isfinite(length)) return edge_normal(nearest.edge);
    return nearest.inside ? Vec3(-r / length) : Vec3(r / length);
  }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    const Nearest nearest = find_nearest(flat(p));
    const double r = (flat(p) - nearest.point).norm(), d = nearest.inside ? -r : r;
    if (!inverted) {
      if (d <= tolerance) normals.push_back(edge_normal(nearest.edge));
      return;
    }
    if (!(d >= -tolerance)) return;
    const std::size_t first = normals.size();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      // Beyond an edge: beyond its line where the container is convex; else only at the part that is nearest.
      const double beyond = (flat(p) - points_[i]).dot(edge_normal(i));
      const bool near = convex_ || (flat(p) - closest(i, flat(p))).norm() <= r + tolerance;
      if (near && beyond >= -tolerance) normals.push_back(-edge_normal(i));
    }
    drop_repeated(normals, first);
  }

  Bounds bounds() const override {
    Bounds b{points_[0], points_[0]};
    for (const Vec3& p : points_) {
      b.min = b.min.cwiseMin(p);
      b.max = b.max.cwiseMax(p);
    }
    return b;
  }

  double measure(double) const override { return area_; }

  void add_surface(double h, const Bounds&, std::vector<SurfacePoint>& points) const override {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double length = edge(i).norm();
      const int n = pieces(length, h);
      for (int k = 0; k < n; ++k) points.push_back({points_[i] + (k + 0.5) / n * edge(i), edge_normal(i), length / n});
    }
  }

 private:
  struct Nearest {
    std::size_t edge;
    Vec3 point;
    bool inside;
  };

  Vec3 edge(std::size_t i) const { return points_[i + 1 == points_.size() ? 0 : i + 1] - points_[i]; }
  /// Outward: the corners run counter-clockwise.
  Vec3 edge_normal(std::size_t i) const {
    const Vec3 e = edge(i);
    const double length = e.norm();
    return length > 0 ? Vec3(e.y() / length, -e.x() / length, 0) : Vec3::UnitX();
  }
  Vec3 closest(std::size_t i, const Vec3& p) const {
    const Vec3 e = edge(i);
    const double length2 = e.squaredNorm();
    const double s = length2 > 0 ? std::clamp((p - points_[i]).dot(e) / length2, 0.0, 1.0) : 0.0;
    return points_[i] + s * e;
  }

  Nearest find_nearest(const Vec3& p) const {
    Nearest nearest{0, points_[0], false};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec3 a = points_[i], e = edge(i), b = a + e;
      const Vec3 q = closest(i, p);
      const double d2 = (p - q).squaredNorm();
      if (d2 < least) {
        least = d2;
        nearest.edge = i;
        nearest.point = q;
      }
      // Crossings of the ray to the right, half-open in y so that a corner counts once.
      if ((a.y() <= p.y()) != (b.y() <= p.y()) && ((p.x() - a.x()) * e.y() < (p.y() - a.y()) * e.x()) == (e.y() > 0))
        nearest.inside = !nearest.inside;
    }
    if (!p.allFinite()) nearest = {0, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), false};
    return nearest;
  }

  double signed_area() const {
    double twice = 0;  // about the first corner: far from the origin little cancels
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec3 a = points_[i] - points_[0], e = edge(i);
      twice += a.x() * e.y() - a.y() * e.x();
    }
    return 0.5 * twice;
  }
  bool is_convex() const {
    double turned = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec3 a = edge(i), b = edge(i + 1 == points_.size() ? 0 : i + 1);
      const double sine = a.x() * b.y() - a.y() * b.x();
      if (sine < 0) return false;
      turned += std::atan2(sine, a.dot(b));
    }
    return turned < 7;  // once round: 2 pi; a star that crosses itself turns twice
  }

  std::vector<Vec3> points_;
  double area_ = 0;
  bool convex_ = false;
};

}  // namespace

SolidPointer make_polygon(const Shape& shape) {
  return std::make_unique<Polygon>(shape.points);
}

}  // namespace pf
