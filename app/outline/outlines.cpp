#include "app/outline/outlines.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "app/outline/items.hpp"
#include "app/theme.hpp"
#include "core/scene/solid.hpp"

namespace pf::app {
namespace {

using Lines = std::vector<std::vector<Vec3>>;

/// `scale`, `rotate` and `translate` about `centre`.
Vec3 transformed(const Shape& s, const Vec3& centre, const Vec3& p) {
  const Eigen::AngleAxisd turn(s.rotate_degrees * std::numbers::pi / 180, s.rotate_axis.normalized());
  return centre + turn * (s.scale * (p - centre)) + s.translate;
}

std::vector<Vec3> circle(const Vec3& centre, double r, const Vec3& a, const Vec3& b) {
  constexpr int pieces = 72;
  std::vector<Vec3> points;
  for (int k = 0; k <= pieces; ++k) {
    const double angle = 2 * std::numbers::pi * k / pieces;
    points.push_back(centre + r * (std::cos(angle) * a + std::sin(angle) * b));
  }
  return points;
}

std::vector<Vec3> rectangle(const Vec3& a, const Vec3& b) {
  return {a, {b.x(), a.y(), 0}, b, {a.x(), b.y(), 0}, a};
}

Lines box_edges(const Bounds& b) {
  Lines lines;
  const auto corner = [&](int k) {
    return Vec3(k & 1 ? b.max.x() : b.min.x(), k & 2 ? b.max.y() : b.min.y(), k & 4 ? b.max.z() : b.min.z());
  };
  for (int k = 0; k < 8; ++k)
    for (const int bit : {1, 2, 4})
      if (!(k & bit)) lines.push_back({corner(k), corner(k | bit)});
  return lines;
}

/// Marching squares along distance = 0.
Lines traced(const Solid& solid, const Bounds& b) {
  constexpr int n = 96;
  const Vec3 pad = 0.02 * (b.max - b.min), low = b.min - pad, size = b.max - b.min + 2 * pad;
  const auto at = [&](int i, int j) { return Vec3(low.x() + size.x() * i / n, low.y() + size.y() * j / n, 0); };
  std::vector<double> value;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) value.push_back(solid.distance(at(i, j)));
  Lines lines;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int ii[] = {i, i + 1, i + 1, i}, jj[] = {j, j, j + 1, j + 1};
      std::vector<Vec3> cut;
      for (int k = 0; k < 4; ++k) {
        const int l = (k + 1) % 4;
        const double a = value[static_cast<std::size_t>(jj[k] * (n + 1) + ii[k])];
        const double c = value[static_cast<std::size_t>(jj[l] * (n + 1) + ii[l])];
        if ((a < 0) != (c < 0)) cut.push_back(at(ii[k], jj[k]) + a / (a - c) * (at(ii[l], jj[l]) - at(ii[k], jj[k])));
      }
      for (std::size_t k = 0; k + 1 < cut.size(); k += 2) lines.push_back({cut[k], cut[k + 1]});
    }
  return lines;
}

Lines half_space(const Shape& s, const Vec3& point, double reach, int dimension) {
  const Eigen::AngleAxisd turn(s.rotate_degrees * std::numbers::pi / 180, s.rotate_axis.normalized());
  const Vec3 n = (turn * s.normal).normalized();
  Vec3 along = dimension == 2 ? Vec3(-n.y(), n.x(), 0) : n.unitOrthogonal();
  if (dimension == 2) return {{point - reach * along, point + reach * along}};
  const Vec3 other = n.cross(along);
  const auto at = [&](double a, double b) { return Vec3(point + reach * (a * along + b * other)); };
  return {{at(-1, -1), at(1, -1), at(1, 1), at(-1, 1), at(-1, -1)}};
}

}  // namespace

Around around(const Shape& shape, const Scene& scene) {
  if (shape.type == "half_space") return {shape.point + shape.translate, 2 * scene.grid.spacing};
  const Bounds b = make_solid(shape, scene.dimension, scene.constants)->bounds();
  if (!b.min.allFinite() || !b.max.allFinite()) return {shape.translate, 2 * scene.grid.spacing};
  Vec3 size = b.max - b.min, centre = (b.min + b.max) / 2;
  if (scene.dimension == 2) size.z() = centre.z() = 0;
  return {centre, size.norm() / 2};
}

std::vector<std::vector<Vec3>> shape_lines(const Shape& s, const Scene& scene, double reach) {
  const bool flat = scene.dimension == 2;
  if (s.type == "half_space") return half_space(s, s.point + s.translate, reach, scene.dimension);
  if (s.type == "ball") {
    const Vec3 c = s.center + s.translate;
    Lines lines{circle(c, s.scale * s.radius, Vec3::UnitX(), Vec3::UnitY())};
    if (flat) return lines;
    lines.push_back(circle(c, s.scale * s.radius, Vec3::UnitY(), Vec3::UnitZ()));
    lines.push_back(circle(c, s.scale * s.radius, Vec3::UnitZ(), Vec3::UnitX()));
    return lines;
  }
  if (s.type == "box") {
    Lines lines = flat ? Lines{rectangle(s.min, s.max)} : box_edges({s.min, s.max});
    for (auto& line : lines)
      for (Vec3& p : line) p = transformed(s, (s.min + s.max) / 2, p);
    return lines;
  }
  if (s.type == "polygon" && !s.points.empty()) {
    Vec3 low = s.points.front(), high = low;
    for (const Vec3& p : s.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    std::vector<Vec3> line;
    for (const Vec3& p : s.points) line.push_back(transformed(s, (low + high) / 2, p));
    line.push_back(line.front());
    return {line};
  }
  const auto solid = make_solid(s, scene.dimension, scene.constants);
  const Bounds b = solid->bounds();
  if (!b.min.allFinite() || !b.max.allFinite()) return {};
  return flat ? traced(*solid, b) : box_edges(b);
}

void draw_lines(Painter& painter, const ViewMap& map, const std::vector<std::vector<Vec3>>& lines, Color color,
                bool dashed) {
  const float em = map.em();
  std::vector<std::vector<Point2>> shown;
  for (const auto& line : lines) {
    std::vector<Point2> points;
    for (const Vec3& p : line)
      if (const auto at = map.to_pixel(p)) points.push_back(*at);
    if (points.size() > 1) shown.push_back(std::move(points));
  }
  if (!dashed)
    for (const auto& points : shown) painter.polyline(points, {0, 0, 0, 0.5F}, 0.24F * em);
  for (const auto& points : shown) painter.polyline(points, color, 0.13F * em, dashed ? 0.4F * em : 0);
}

void draw_selection(Painter& painter, const ViewMap& map, const AppContext& context) {
  if (!context.selected_item) return;
  const Shape* shape = item_shape(context.scene, *context.selected_item);
  if (!shape) return;
  const Color accent = palette(context.view.theme).accent;
  const bool stays = context.selected_item->kind != ItemKind::body || context.status.step == 0;
  draw_lines(painter, map, shape_lines(*shape, context.scene, 1e3 * context.scene.grid.spacing), accent, !stays);
}

}  // namespace pf::app
