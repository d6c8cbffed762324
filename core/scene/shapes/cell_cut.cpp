#include "core/scene/shapes/cell_cut.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pf {
namespace {

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}
double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return std::abs((b - a).cross(c - a).dot(d - a)) / 6;
}

}  // namespace

double CellCut::measure(const Vec3& min, const Vec3& size, const Values& values) {
  const int n = 1 << set_.dimension;
  const auto inside = std::count_if(values.begin(), values.begin() + n, [](double v) { return v < 0; });
  if (inside == 0) return 0;
  if (inside == n) return whole(min, size);
  min_ = min;
  size_ = size;
  inside_ = area_ = 0;
  moment_ = normal_ = Vec3::Zero();
  known_ = 0;
  const auto corner = [&](int i) { return Corner{i, values[static_cast<std::size_t>(i)]}; };
  if (set_.dimension == 2) {
    triangle({corner(0), corner(1), corner(3)});
    triangle({corner(0), corner(3), corner(2)});
  } else {  // around the diagonal 0-7
    constexpr std::array<std::array<int, 2>, 6> edges = {{{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}}};
    for (const auto& [i, j] : edges) tetrahedron({corner(0), corner(i), corner(j), corner(7)});
  }
  const double length = normal_.norm();
  if (surface_ && area_ > 0 && length > 0) surface_->push_back({moment_ / area_, normal_ / length, area_});
  return inside_;
}

double CellCut::whole(const Vec3& min, const Vec3& size) {
  if (moments_) moments_->add_box(min, size, set_.dimension);
  return box_measure(size, set_.dimension);
}

Vec3 CellCut::at(const Corner& c) const {
  return min_ + Vec3(c.index & 1, c.index >> 1 & 1, c.index >> 2 & 1).cwiseProduct(size_);
}

Vec3 CellCut::crossing(const Corner& in, const Corner& out) {
  const auto slot = 8 * static_cast<std::size_t>(in.index) + static_cast<std::size_t>(out.index);
  if ((known_ >> slot & 1u) == 0) {
    crossing_[slot] = find_crossing(in, out);
    known_ |= std::uint64_t{1} << slot;
  }
  return crossing_[slot];
}

/// A smooth value needs a step or two of the secant; one that jumps ends as bisection.
Vec3 CellCut::find_crossing(const Corner& in, const Corner& out) const {
  const Vec3 from = at(in), way = at(out) - from;
  double a = 0, fa = in.value, b = 1, fb = out.value;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (a + b);
    const double secant = std::isfinite(fa) && std::isfinite(fb) ? a + (b - a) * fa / (fa - fb) : middle;
    const double t = i % 2 == 0 ? std::clamp(secant, a + 0.02 * (b - a), b - 0.02 * (b - a)) : middle;
    const double f = set_.value(from + t * way);
    if (std::abs(f) < 1e-3 * std::abs(in.value - out.value) && t == secant)
      return from + (f < 0 ? t + (b - t) * f / (f - fb) : a + (t - a) * fa / (fa - f)) * way;
    (f < 0 ? a : b) = t;
    (f < 0 ? fa : fb) = f;
  }
  return from + 0.5 * (a + b) * way;
}

void CellCut::triangle(std::array<Corner, 3> c) {
  const auto first_outside = std::stable_partition(c.begin(), c.end(), [](const Corner& k) { return k.inside(); });
  const auto inside = first_outside - c.begin();
  if (inside == 0) return;
  const Vec3 a = at(c[0]), b = at(c[1]), d = at(c[2]);
  const double whole = triangle_area(a, b, d);
  if (inside == 3) return add_inside(whole, a, b, d);
  const bool one = inside == 1;
  const Vec3 tip = one ? a : d;
  const Vec3 p = one ? crossing(c[0], c[1]) : crossing(c[0], c[2]);
  const Vec3 q = one ? crossing(c[0], c[2]) : crossing(c[1], c[2]);
  const double corner = triangle_area(tip, p, q);
  if (!one) add_inside(whole, a, b, d);
  add_inside(one ? corner : -corner, tip, p, q);
  const Vec3 line = q - p, normal(line.y(), -line.x(), 0);
  add_piece(0.5 * (p + q), (p - tip).dot(normal) * (one ? 1 : -1) < 0 ? Vec3(-normal) : normal);
}

void CellCut::tetrahedron(std::array<Corner, 4> c) {
  const auto first_outside = std::stable_partition(c.begin(), c.end(), [](const Corner& k) { return k.inside(); });
  const auto inside = first_outside - c.begin();
  const double whole = size_.prod() / 6;
  if (inside == 0) return;
  if (inside == 4) {
    add_inside(whole, at(c[0]), at(c[1]), at(c[2]), at(c[3]));
  } else if (inside == 2) {
    const Vec3 p = crossing(c[0], c[2]), q = crossing(c[0], c[3]), r = crossing(c[1], c[2]), s = crossing(c[1], c[3]);
    // The wedge between the inner edge 0-1 and the quadrilateral p q s r.
    const Vec3 tip = at(c[0]), other = at(c[1]);
    add_inside(tet_volume(tip, p, q, s), tip, p, q, s);
    add_inside(tet_volume(tip, p, s, r), tip, p, s, r);
    add_inside(tet_volume(tip, other, r, s), tip, other, r, s);
    add_triangle(p, q, s, at(c[2]));
    add_triangle(p, s, r, at(c[2]));
  } else {
    const bool one = inside == 1;
    const Corner& tip = one ? c[0] : c[3];
    const Vec3 p = one ? crossing(tip, c[1]) : crossing(c[0], tip);
    const Vec3 q = one ? crossing(tip, c[2]) : crossing(c[1], tip);
    const Vec3 r = one ? crossing(tip, c[3]) : crossing(c[2], tip);
    const double corner = tet_volume(at(tip), p, q, r);
    if (!one) add_inside(whole, at(c[0]), at(c[1]), at(c[2]), at(c[3]));
    add_inside(one ? corner : -corner, at(tip), p, q, r);
    add_triangle(p, q, r, one ? Vec3(2 * p - at(tip)) : at(tip));
  }
}

void CellCut::add_triangle(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& outside) {
  if (!surface_) return;
  const Vec3 normal = 0.5 * (q - p).cross(r - p);
  add_piece((p + q + r) / 3, (outside - p).dot(normal) < 0 ? Vec3(-normal) : normal);
}

void CellCut::add_piece(const Vec3& at, const Vec3& normal) {
  const double area = normal.norm();
  area_ += area;
  moment_ += area * at;
  normal_ += normal;
}

}  // namespace pf
