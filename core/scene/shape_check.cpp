// Shapes that are well formed key by key and yet no shape.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/params/json_text.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

bool is_bounded(const Shape& shape) {
  if (shape.type == "half_space") return false;
  if (shape.type == "union") return std::all_of(shape.of.begin(), shape.of.end(), is_bounded);
  if (shape.type == "difference") return is_bounded(shape.of.front());
  if (shape.type == "intersection") return std::any_of(shape.of.begin(), shape.of.end(), is_bounded);
  return true;
}

double cross(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}
bool within_box(const Vec3& a, const Vec3& b, const Vec3& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) && std::min(a.y(), b.y()) <= p.y() &&
         p.y() <= std::max(a.y(), b.y());
}
/// Do the closed segments ab and cd share a point?
bool segments_meet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double abc = cross(a, b, c), abd = cross(a, b, d), cda = cross(c, d, a), cdb = cross(c, d, b);
  if (((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) && ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0))) return true;
  return (abc == 0 && within_box(a, b, c)) || (abd == 0 && within_box(a, b, d)) || (cda == 0 && within_box(c, d, a)) ||
         (cdb == 0 && within_box(c, d, b));
}

/// Two edges of a closed polygon, by the index of their first corner, that meet where they should not.
bool edges_conflict(const std::vector<Vec3>& p, std::size_t i, std::size_t j) {
  const std::size_t n = p.size(), i1 = (i + 1) % n, j1 = (j + 1) % n;
  if (i1 == j || j1 == i) {  // neighbours share a corner: they must not fold back
    const Vec3 &shared = i1 == j ? p[j] : p[i], &before = i1 == j ? p[i] : p[j], &after = i1 == j ? p[j1] : p[i1];
    return cross(before, shared, after) == 0 && (shared - before).dot(after - shared) < 0;
  }
  return segments_meet(p[i], p[i1], p[j], p[j1]);
}

/// Sweeps along x, so that only edges whose spans overlap are compared.
void check_polygon(Reader& reader, const std::vector<Vec3>& p) {
  const std::size_t n = p.size();
  if (n < 3) return reader.refuse("/points", std::to_string(n) + " points", "3 points or more");
  const auto low = [&](std::size_t e) { return std::min(p[e].x(), p[(e + 1) % n].x()); };
  const auto high = [&](std::size_t e) { return std::max(p[e].x(), p[(e + 1) % n].x()); };
  for (std::size_t e = 0; e < n; ++e) {
    if (p[e] == p[(e + 1) % n])
      return reader.refuse("/points/" + std::to_string(e), "the same point twice in a row", "each corner once");
  }
  double area = 0;
  for (std::size_t e = 0; e < n; ++e) area += 0.5 * cross(p[0], p[e], p[(e + 1) % n]);
  if (area == 0) return reader.refuse("/points", "a polygon without area", "corners that are not on one line");
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t l = k + 1; l < n && low(order[l]) <= high(order[k]); ++l) {
      const auto [i, j] = std::minmax(order[k], order[l]);
      if (!edges_conflict(p, i, j)) continue;
      return reader.refuse(
          "/points/" + std::to_string(j),
          "a polygon that crosses or touches itself: edges " + std::to_string(i) + " and " + std::to_string(j),
          "a simple polygon");
    }
  }
}

void check_corners(Reader& reader, const Shape& shape, ShapeUse use) {
  static constexpr const char* axis = "xyz";
  for (int a = 0; a < reader.dimension(); ++a) {
    const bool good =
        use == ShapeUse::region && shape.type == "box" ? shape.min[a] <= shape.max[a] : shape.min[a] < shape.max[a];
    if (good) continue;
    reader.refuse("/max/" + std::to_string(a), number_text(shape.max[a]),
                  std::string(use == ShapeUse::region ? "at least" : "more than") + " the " + axis[a] +
                      " of \"min\", " + number_text(shape.min[a]));
  }
}

}  // namespace

void check_shape(Reader& reader, const Shape& shape, ShapeUse use) {
  if (shape.type == "box" || shape.type == "where") check_corners(reader, shape, use);
  if (shape.type == "polygon") check_polygon(reader, shape.points);
  if (shape.type == "half_space" && shape.normal.isZero(0))
    reader.refuse("/normal", "a zero normal", "any other vector");
  if (shape.type == "cylinder" && shape.from == shape.to)
    reader.refuse("/to", "the same point as \"from\"", "another point");
  if (use == ShapeUse::body && !is_bounded(shape))
    reader.refuse("a " + shape.type + " without bounds", "bodies that end: intersect it with a box, for instance");
}

}  // namespace pf
