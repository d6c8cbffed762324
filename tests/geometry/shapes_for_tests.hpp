// Shapes as a scene file would give them, with their exact measure and surface.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/scene/solid.hpp"

namespace pf::test {

inline Shape box(const Vec3& min, const Vec3& max) {
  Shape s;
  s.type = "box";
  s.min = min;
  s.max = max;
  return s;
}
inline Shape ball(const Vec3& center, double radius) {
  Shape s;
  s.type = "ball";
  s.center = center;
  s.radius = radius;
  return s;
}
inline Shape cylinder(const Vec3& from, const Vec3& to, double radius) {
  Shape s;
  s.type = "cylinder";
  s.from = from;
  s.to = to;
  s.radius = radius;
  return s;
}
inline Shape polygon(const std::vector<Vec3>& points) {
  Shape s;
  s.type = "polygon";
  s.points = points;
  return s;
}
inline Shape half_space(const Vec3& point, const Vec3& normal) {
  Shape s;
  s.type = "half_space";
  s.point = point;
  s.normal = normal;
  return s;
}
inline Shape where(const std::string& text, const Vec3& min, const Vec3& max) {
  Shape s = box(min, max);
  s.type = "where";
  s.where = text;
  return s;
}
inline Shape boolean(const std::string& type, const std::vector<Shape>& of) {
  Shape s;
  s.type = type;
  s.of = of;
  return s;
}
inline Shape moved(Shape s, double scale, double degrees, const Vec3& translate, const Vec3& axis = Vec3::UnitZ()) {
  s.scale = scale;
  s.rotate_degrees = degrees;
  s.rotate_axis = axis;
  s.translate = translate;
  return s;
}

struct Case {
  std::string name;
  int dimension;
  Shape shape;
  double measure, surface;
  double tolerance;          ///< relative, of the measure
  double surface_tolerance;  ///< relative, of the surface's area
};

inline const std::vector<Vec3>& l_shape() {
  static const std::vector<Vec3> points = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  return points;
}

inline std::vector<Case> cases() {
  constexpr double pi = std::numbers::pi;
  const Shape unit = box({0, 0, 0}, {1, 1, 1});
  std::vector<Case> list;
  list.push_back({"box", 2, box({-1, 0.5, 0}, {0.25, 0.75, 0}), 0.3125, 3, 1e-14, 1e-12});
  list.push_back({"box", 3, box({-1, 0.5, 2}, {0.25, 0.75, 3}), 0.3125, 2 * (0.3125 + 1.25 + 0.25), 1e-14, 1e-12});
  list.push_back({"ball", 2, ball({1, 2, 0}, 0.5), pi / 4, pi, 1e-14, 1e-12});
  list.push_back({"ball", 3, ball({1, 2, 3}, 0.5), pi / 6, pi, 1e-14, 1e-12});
  list.push_back({"cylinder", 3, cylinder({0, 0, 0}, {1, 2, 2}, 0.5), 3 * pi / 4, 3 * pi + pi / 2, 1e-14, 1e-12});
  list.push_back({"L", 2, polygon(l_shape()), 4, 10, 1e-14, 1e-12});
  list.push_back(
      {"turned ball", 3, moved(ball({1, 2, 3}, 0.5), 2, 33, {1, 0, 0}, {1, 1, 0}), 4 * pi / 3, 4 * pi, 1e-14, 1e-12});
  list.push_back({"turned L", 2, moved(polygon(l_shape()), 0.5, 30, {5, 5, 0}), 1, 5, 1e-14, 1e-12});
  list.push_back(
      {"box less ball", 2, boolean("difference", {unit, ball({0, 0, 0}, 0.5)}), 1 - pi / 16, 3 + pi / 4, 1e-5, 1e-2});
  list.push_back({"box less ball", 3, boolean("difference", {unit, ball({0, 0, 0}, 0.5)}), 1 - pi / 48,
                  6 - 3 * pi / 16 + pi / 8, 1e-4, 1e-2});
  list.push_back({"shell", 3, boolean("difference", {ball({0, 0, 0}, 1), ball({0, 0, 0}, 0.97)}),
                  4 * pi / 3 * (1 - 0.97 * 0.97 * 0.97), 4 * pi * (1 + 0.97 * 0.97), 2e-3, 1e-9});
  list.push_back({"neighbours", 2, boolean("union", {unit, box({1, 0, 0}, {2, 1, 0})}), 2, 6, 1e-6, 1e-9});
  list.push_back({"box and half space", 2, boolean("intersection", {unit, half_space({0.5, 0.5, 0}, {1, 1, 0})}), 0.5,
                  2 + std::sqrt(2.0), 1e-5, 2e-2});
  list.push_back({"box and half space", 3, boolean("intersection", {unit, half_space({0.5, 0, 0}, {1, 0, 0})}), 0.5, 4,
                  1e-4, 2e-2});
  list.push_back(
      {"disc by expression", 2, where("1 - X^2 - Y^2", {-1.1, -1.2, 0}, {1.3, 1.1, 0}), pi, 2 * pi, 1e-5, 1e-3});
  list.push_back({"ball by expression", 3, where("1 - X^2 - Y^2 - Z^2", {-1.1, -1.2, -1.3}, {1.3, 1.1, 1.2}),
                  4 * pi / 3, 4 * pi, 1e-4, 1e-2});
  list.push_back(
      {"disc by comparison", 2, where("X^2 + Y^2 < 1", {-1.1, -1.2, 0}, {1.3, 1.1, 0}), pi, 2 * pi, 1e-4, 1e-2});
  list.push_back({"wave", 2, where("0.5 + 0.1*sin(2*pi*X) - Y", {0, 0, 0}, {1, 1, 0}), 0.5, 2 + 1.0896, 1e-5, 1e-2});
  return list;
}

}  // namespace pf::test
