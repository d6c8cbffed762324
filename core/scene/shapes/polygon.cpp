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
    build(0, points_.size());
  }

  double distance(const Vec3& p) const override {
    const Nearest nearest = find_nearest(flat(p));
    const double d = (flat(p) - nearest.point).norm();
    return is_inside(flat(p), 0) ? -d : d;
  }

  Vec3 normal(const Vec3& p) const override {
    const Nearest nearest = find_nearest(flat(p));
    const Vec3 r = flat(p) - nearest.point;
    const double length = r.norm();
    // On an edge or next to it the direction from the nearest point is only rounding.
    if (!(length > 1e-9 * edge(nearest.edge).norm()) || !std::isfinite(length)) return edge_normal(nearest.edge);
    return is_inside(flat(p), 0) ? Vec3(-r / length) : Vec3(r / length);
  }

  void contact_normals(const Vec3& p, bool inverted, double tolerance, std::vector<Vec3>& normals) const override {
    const Nearest nearest = find_nearest(flat(p));
    const double r = (flat(p) - nearest.point).norm(), d = is_inside(flat(p), 0) ? -r : r;
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
    std::size_t edge = 0;
    Vec3 point = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    double square = std::numeric_limits<double>::infinity();  ///< of the distance
  };
  /// A run of edges, from corner `first` to corner `last`, and its bounds. Runs halve down to a few edges, so that a
  /// polygon of thousands of corners is asked in about log n.
  struct Run {
    std::size_t first, last;
    Vec3 min, max;
    std::size_t halves = 0;  ///< number of the first half, the second is `second`; 0: too short to halve
    std::size_t second = 0;
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

  const Vec3& corner(std::size_t i) const { return points_[i < points_.size() ? i : 0]; }

  std::size_t build(std::size_t first, std::size_t last) {
    const std::size_t number = runs_.size();
    runs_.push_back({first, last, corner(first), corner(first)});
    for (std::size_t i = first; i <= last; ++i) {
      runs_[number].min = runs_[number].min.cwiseMin(corner(i));
      runs_[number].max = runs_[number].max.cwiseMax(corner(i));
    }
    if (last - first > 8) {
      const std::size_t middle = first + (last - first) / 2;
      const std::size_t halves = build(first, middle), second = build(middle, last);
      runs_[number].halves = halves;
      runs_[number].second = second;
    }
    return number;
  }

  Nearest find_nearest(const Vec3& p) const {
    Nearest nearest;
    look_in(0, p, nearest);
    return nearest;
  }
  static double square_distance(const Run& run, const Vec3& p) {
    return (run.min - p).cwiseMax(p - run.max).cwiseMax(0.0).squaredNorm();
  }
  void look_in(std::size_t number, const Vec3& p, Nearest& nearest) const {
    const Run& run = runs_[number];
    if (run.halves == 0) {
      for (std::size_t i = run.first; i < run.last; ++i) {
        const Vec3 q = closest(i, p);
        const double square = (p - q).squaredNorm();
        if (square < nearest.square) nearest = {i, q, square};
      }
      return;
    }
    double near = square_distance(runs_[run.halves], p), far = square_distance(runs_[run.second], p);
    std::size_t first = run.halves, second = run.second;
    if (far < near) {
      std::swap(near, far);
      std::swap(first, second);
    }
    if (near < nearest.square) look_in(first, p, nearest);
    if (far < nearest.square) look_in(second, p, nearest);
  }

  /// Does the ray from p to the right cross run `number` an odd number of times? Edges are half-open in y, so that a
  /// corner counts once.
  bool is_inside(const Vec3& p, std::size_t number) const {
    const Run& run = runs_[number];
    if (!(p.y() >= run.min.y() && p.y() < run.max.y() && p.x() <= run.max.x())) return false;
    const auto above = [&](std::size_t i) { return corner(i).y() > p.y(); };
    if (p.x() < run.min.x()) return above(run.first) != above(run.last);  // whatever the run does in between
    if (run.halves != 0) return is_inside(p, run.halves) != is_inside(p, run.second);
    bool odd = false;
    for (std::size_t i = run.first; i < run.last; ++i) {
      const Vec3 a = corner(i), e = edge(i);
      if (above(i) != above(i + 1) && ((p.x() - a.x()) * e.y() < (p.y() - a.y()) * e.x()) == (e.y() > 0)) odd = !odd;
    }
    return odd;
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
  std::vector<Run> runs_;
  double area_ = 0;
  bool convex_ = false;
};

}  // namespace

SolidPointer make_polygon(const Shape& shape) {
  return std::make_unique<Polygon>(shape.points);
}

}  // namespace pf
