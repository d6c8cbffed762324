#include "app/tools/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pf::app {

namespace {

/// How far apart the members of a sweep may be, in radii: notches are then a hundredth of the radius deep.
constexpr double apart = 0.28;
constexpr double most = 200;

/// Shares of the way at which a member stands; the end last.
std::vector<double> stations(double way, double radius) {
  const double count = std::clamp(std::ceil(way / (apart * radius)), 1.0, most);
  std::vector<double> at;
  for (int k = 1; k <= static_cast<int>(count); ++k) at.push_back(k / count);
  return at;
}

Shape united(std::vector<Shape> shapes) {
  if (shapes.size() == 1) return std::move(shapes.front());
  Shape all;
  all.type = "union";
  all.of = std::move(shapes);
  return all;
}

Vec3 place(const Snapshot& s, std::size_t p) {
  return {s.x[3 * p], s.x[3 * p + 1], s.x[3 * p + 2]};
}

}  // namespace

Shape swept_balls(const Vec3& from, const Vec3& to, double radius) {
  std::vector<Shape> balls;
  for (const double f : stations((to - from).norm(), radius)) {
    Shape ball;
    ball.type = "ball";
    ball.center = from + f * (to - from);
    ball.radius = radius;
    balls.push_back(std::move(ball));
  }
  return united(std::move(balls));
}

Shape swept_rays(const ViewMouse& from, const ViewMouse& to, const Vec3& near, double radius, const Snapshot& s) {
  std::vector<Shape> rays;
  for (const double f : stations((to.on_plane(near) - from.on_plane(near)).norm(), radius)) {
    const Vec3 origin = from.origin + f * (to.origin - from.origin);
    const Vec3 direction = (from.direction + f * (to.direction - from.direction)).normalized();
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (std::size_t p = 0; p < s.particles; ++p) {
      const double depth = (place(s, p) - origin).dot(direction);
      first = std::min(first, depth);
      last = std::max(last, depth);
    }
    Shape ray;
    ray.type = "cylinder";
    ray.from = origin + std::max(0.0, first - radius) * direction;
    ray.to = origin + (last + radius) * direction;
    ray.radius = radius;
    rays.push_back(std::move(ray));
  }
  return united(std::move(rays));
}

std::optional<Vec3> met_first(const ViewMouse& mouse, const Snapshot& s, double reach) {
  std::optional<Vec3> met;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vec3 way = place(s, p) - mouse.origin;
    const double depth = way.dot(mouse.direction);
    if (depth <= 0 || depth >= nearest || way.squaredNorm() - depth * depth > reach * reach) continue;
    nearest = depth;
    met = place(s, p);
  }
  return met;
}

}  // namespace pf::app
