#include "core/scene/shapes/cells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace pf {
namespace {

/// Where the surface is inside a simplex, and how much of it lies inside.
struct Sums {
  double inside = 0;
  double area = 0;
  Vec3 moment = Vec3::Zero();  ///< of the area
  Vec3 normal = Vec3::Zero();  ///< area-weighted
};

struct Corner {
  Vec3 at;
  double value;
  bool inside() const { return value < 0; }
};

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}
double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return std::abs((b - a).cross(c - a).dot(d - a)) / 6;
}

class Walk {
 public:
  Walk(const LevelSet& set, int cells, std::vector<SurfacePoint>* surface)
      : set_(set), D_(set.dimension), surface_(surface) {
    const Vec3 extent = set.domain.max - set.domain.min;
    // Roots of about the same size in every direction, so that long domains do not get long cells.
    for (depth_ = 0; depth_ < 5 && (8 << depth_) < cells; ++depth_) {
    }
    const double root = extent.maxCoeff() / std::max(1.0, std::ceil(cells / double(1 << depth_)));
    for (int a = 0; a < D_; ++a) roots_[a] = std::max(1, static_cast<int>(std::ceil(extent[a] / root * (1 - 1e-9))));
  }

  double run() {
    const Vec3 extent = set_.domain.max - set_.domain.min;
    for (int a = 0; a < D_; ++a)
      if (!(extent[a] > 0)) return 0;
    Vec3 size = Vec3::Zero();
    for (int a = 0; a < D_; ++a) size[a] = extent[a] / roots_[a];
    double sum = 0;
    for (int k = 0; k < roots_[2]; ++k)
      for (int j = 0; j < roots_[1]; ++j)
        for (int i = 0; i < roots_[0]; ++i)
          sum += cell(set_.domain.min + Vec3(i, j, k).cwiseProduct(size), size, depth_);
    return sum;
  }

 private:
  double full(const Vec3& size) const { return size.head(D_).prod(); }

  double cell(const Vec3& min, const Vec3& size, int depth) {
    if (set_.is_bound) {
      const double d = set_.value(min + 0.5 * size);
      if (std::abs(d) > 0.5 * size.norm()) return d < 0 ? full(size) : 0;
    }
    // Without a bound only the last two levels may trust the signs at the corners.
    const bool judge = depth == 0 || (!set_.is_bound && depth <= 2);
    std::array<Corner, 8> corners;
    if (judge) {
      const int inside = read_corners(min, size, corners);
      const int n = 1 << D_;
      if (inside == 0 || inside == n) return inside == 0 ? 0 : full(size);
      if (depth == 0) return cut(corners);
    }
    const Vec3 half = 0.5 * size;
    double sum = 0;
    for (int c = 0; c < 1 << D_; ++c) sum += cell(min + offset(c).cwiseProduct(half), half, depth - 1);
    return sum;
  }

  static Vec3 offset(int corner) { return Vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1); }

  int read_corners(const Vec3& min, const Vec3& size, std::array<Corner, 8>& corners) const {
    int inside = 0;
    for (int c = 0; c < 1 << D_; ++c) {
      corners[c].at = min + offset(c).cwiseProduct(size);
      corners[c].value = set_.value(corners[c].at);
      inside += corners[c].inside();
    }
    return inside;
  }

  /// A smallest cell with the surface in it: two triangles, or six tetrahedra around its diagonal.
  double cut(const std::array<Corner, 8>& c) {
    Sums sums;
    if (D_ == 2) {
      for (const std::array<int, 3>& t : {std::array{0, 1, 3}, std::array{0, 3, 2}})
        triangle({c[t[0]], c[t[1]], c[t[2]]}, sums);
    } else {
      for (const std::array<int, 2>& t :
           {std::array{1, 3}, std::array{1, 5}, std::array{2, 3}, std::array{2, 6}, std::array{4, 5}, std::array{4, 6}})
        tetrahedron({c[0], c[t[0]], c[t[1]], c[7]}, sums);
    }
    const double length = sums.normal.norm();
    if (surface_ && sums.area > 0 && length > 0)
      surface_->push_back({sums.moment / sums.area, sums.normal / length, sums.area});
    return sums.inside;
  }

  /// Where the surface cuts the edge from an inner to an outer corner. A smooth value needs a step or two; one that
  /// jumps ends as bisection.
  Vec3 crossing(const Corner& in, const Corner& out) const {
    double a = 0, fa = in.value, b = 1, fb = out.value;
    for (int i = 0; i < 12; ++i) {
      const double secant = std::isfinite(fa) && std::isfinite(fb) ? a + (b - a) * fa / (fa - fb) : 0.5 * (a + b);
      const double t = i % 2 == 0 ? std::clamp(secant, a + 0.02 * (b - a), b - 0.02 * (b - a)) : 0.5 * (a + b);
      const double f = set_.value(in.at + t * (out.at - in.at));
      if (std::abs(f) < 1e-3 * std::abs(in.value - out.value) && t == secant)
        return in.at + (f < 0 ? t + (b - t) * f / (f - fb) : a + (t - a) * fa / (fa - f)) * (out.at - in.at);
      (f < 0 ? a : b) = t;
      (f < 0 ? fa : fb) = f;
    }
    return in.at + 0.5 * (a + b) * (out.at - in.at);
  }

  void triangle(std::array<Corner, 3> c, Sums& sums) const {
    std::ranges::stable_partition(c, [](const Corner& corner) { return corner.inside(); });
    const auto inside = std::ranges::count_if(c, [](const Corner& corner) { return corner.inside(); });
    const double whole = triangle_area(c[0].at, c[1].at, c[2].at);
    if (inside == 0 || inside == 3) {
      sums.inside += inside == 0 ? 0 : whole;
      return;
    }
    const bool one = inside == 1;
    const Vec3 tip = one ? c[0].at : c[2].at;
    const Vec3 p = one ? crossing(c[0], c[1]) : crossing(c[0], c[2]);
    const Vec3 q = one ? crossing(c[0], c[2]) : crossing(c[1], c[2]);
    const double corner = triangle_area(tip, p, q);
    sums.inside += one ? corner : whole - corner;
    if (!surface_) return;
    const Vec3 line = q - p, normal(line.y(), -line.x(), 0);
    add_piece(0.5 * (p + q), (p - tip).dot(normal) * (one ? 1 : -1) < 0 ? Vec3(-normal) : normal, sums);
  }

  void tetrahedron(std::array<Corner, 4> c, Sums& sums) const {
    std::ranges::stable_partition(c, [](const Corner& corner) { return corner.inside(); });
    const auto inside = std::ranges::count_if(c, [](const Corner& corner) { return corner.inside(); });
    const double whole = tet_volume(c[0].at, c[1].at, c[2].at, c[3].at);
    if (inside == 0 || inside == 4) {
      sums.inside += inside == 0 ? 0 : whole;
    } else if (inside == 2) {
      const Vec3 p = crossing(c[0], c[2]), q = crossing(c[0], c[3]), r = crossing(c[1], c[2]), s = crossing(c[1], c[3]);
      // The wedge between the inner edge 0-1 and the quadrilateral p q s r.
      sums.inside += tet_volume(c[0].at, p, q, s) + tet_volume(c[0].at, p, s, r) + tet_volume(c[0].at, c[1].at, r, s);
      add_triangle(p, q, s, c[2].at, sums);
      add_triangle(p, s, r, c[2].at, sums);
    } else {
      const bool one = inside == 1;
      const Corner& tip = one ? c[0] : c[3];
      const Vec3 p = one ? crossing(tip, c[1]) : crossing(c[0], tip);
      const Vec3 q = one ? crossing(tip, c[2]) : crossing(c[1], tip);
      const Vec3 r = one ? crossing(tip, c[3]) : crossing(c[2], tip);
      const double corner = tet_volume(tip.at, p, q, r);
      sums.inside += one ? corner : whole - corner;
      add_triangle(p, q, r, one ? Vec3(2 * p - tip.at) : tip.at, sums);
    }
  }

  /// `outside`: a point on the side that the normal shall point to.
  void add_triangle(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& outside, Sums& sums) const {
    if (!surface_) return;
    const Vec3 normal = 0.5 * (q - p).cross(r - p);
    add_piece((p + q + r) / 3, (outside - p).dot(normal) < 0 ? Vec3(-normal) : normal, sums);
  }

  /// `normal`: as long as the piece is large.
  static void add_piece(const Vec3& at, const Vec3& normal, Sums& sums) {
    const double area = normal.norm();
    sums.area += area;
    sums.moment += area * at;
    sums.normal += normal;
  }

  const LevelSet& set_;
  int D_;
  std::vector<SurfacePoint>* surface_;
  int depth_ = 0;
  std::array<int, 3> roots_ = {1, 1, 1};
};

}  // namespace

double inside_measure(const LevelSet& set, int cells) {
  return Walk(set, cells, nullptr).run();
}

void add_level_surface(const LevelSet& set, int cells, std::vector<SurfacePoint>& points) {
  Walk(set, cells, &points).run();
}

}  // namespace pf
