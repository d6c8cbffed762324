#include "render/camera.hpp"

#include <algorithm>
#include <cmath>

namespace pf {

namespace {
constexpr double smallest_scale = 1e-9, largest_scale = 1e12;  // [px/m]

/// The part of the viewport that margins leave, at least a quarter of it.
struct Room {
  double width, height;
  Vec<2> centre;  // [px]
};
Room room(ViewSize size, const ViewMargins& m) {
  const double w = std::max(size.width - m.left - m.right, 0.25 * size.width);
  const double h = std::max(size.height - m.top - m.bottom, 0.25 * size.height);
  return {w, h, Vec<2>(0.5 * (size.width + m.left - m.right), 0.5 * (size.height + m.top - m.bottom))};
}
}  // namespace

Vec<2> Camera2D::to_pixel(const Vec3& world, ViewSize size) const {
  return {0.5 * size.width + (world.x() - centre.x()) * pixels_per_metre,
          0.5 * size.height - (world.y() - centre.y()) * pixels_per_metre};
}

Vec3 Camera2D::to_world(const Vec<2>& pixel, ViewSize size) const {
  return {centre.x() + (pixel.x() - 0.5 * size.width) / pixels_per_metre,
          centre.y() - (pixel.y() - 0.5 * size.height) / pixels_per_metre, 0};
}

void Camera2D::pan(const Vec<2>& pixels) {
  centre += Vec<2>(-pixels.x(), pixels.y()) / pixels_per_metre;
}

void Camera2D::zoom(double factor, const Vec<2>& pixel, ViewSize size) {
  const Vec3 before = to_world(pixel, size);
  pixels_per_metre = std::clamp(pixels_per_metre * factor, smallest_scale, largest_scale);
  const Vec3 after = to_world(pixel, size);
  centre += (before - after).head<2>();
}

void Camera2D::fit(const ViewBounds& bounds, ViewSize size, const ViewMargins& margins) {
  const Room r = room(size, margins);
  const Vec3 extent = bounds.size().cwiseMax(1e-9);
  pixels_per_metre = std::clamp(std::min(r.width / extent.x(), r.height / extent.y()), smallest_scale, largest_scale);
  const Vec<2> shift = r.centre - 0.5 * Vec<2>(size.width, size.height);
  centre = bounds.centre().head<2>() - Vec<2>(shift.x(), -shift.y()) / pixels_per_metre;
}

Vec3 OrbitCamera::forward() const {
  return {-std::cos(pitch) * std::sin(yaw), -std::sin(pitch), -std::cos(pitch) * std::cos(yaw)};
}
Vec3 OrbitCamera::right() const {
  return {std::cos(yaw), 0, -std::sin(yaw)};
}
Vec3 OrbitCamera::up() const {
  return {-std::sin(pitch) * std::sin(yaw), std::cos(pitch), -std::sin(pitch) * std::cos(yaw)};
}
Vec3 OrbitCamera::eye() const {
  return target - distance * forward();
}

std::optional<Vec<2>> OrbitCamera::to_pixel(const Vec3& world, ViewSize size) const {
  const Vec3 d = world - target;
  const double depth = d.dot(forward()) + distance;
  if (depth <= 1e-6 * distance) return std::nullopt;
  const double scale = 0.5 * size.height / (std::tan(0.5 * field_of_view) * depth);
  return Vec<2>(0.5 * size.width + d.dot(right()) * scale, 0.5 * size.height - d.dot(up()) * scale);
}

Vec3 OrbitCamera::ray(const Vec<2>& pixel, ViewSize size) const {
  const double scale = std::tan(0.5 * field_of_view) / (0.5 * size.height);
  return (forward() + (pixel.x() - 0.5 * size.width) * scale * right() - (pixel.y() - 0.5 * size.height) * scale * up())
      .normalized();
}

Vec3 OrbitCamera::to_world(const Vec<2>& pixel, ViewSize size, const Vec3& through) const {
  const Vec3 direction = ray(pixel, size);
  return eye() + direction * ((through - eye()).dot(forward()) / direction.dot(forward()));
}

double OrbitCamera::pixels_per_metre(ViewSize size) const {
  return 0.5 * size.height / (std::tan(0.5 * field_of_view) * distance);
}

void OrbitCamera::rotate(double yaw_by, double pitch_by) {
  yaw = std::remainder(yaw + yaw_by, 2 * 3.14159265358979324);
  pitch = std::clamp(pitch + pitch_by, -1.55, 1.55);
}

void OrbitCamera::pan(const Vec<2>& pixels, ViewSize size) {
  target += (-pixels.x() * right() + pixels.y() * up()) / pixels_per_metre(size);
}

void OrbitCamera::zoom(double factor) {
  distance = std::clamp(distance / factor, 1e-9, 1e12);
}

void OrbitCamera::fit(const ViewBounds& bounds, ViewSize size, const ViewMargins& margins) {
  const Room r = room(size, margins);
  target = bounds.centre();
  const double tan_y = std::tan(0.5 * field_of_view) * r.height / size.height;
  const double tan_x = std::tan(0.5 * field_of_view) * r.width / size.height;
  // The eye steps back until every corner of the box is in the picture.
  distance = 1e-9;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 half = 0.5 * bounds.size();
    const Vec3 d(corner & 1 ? half.x() : -half.x(), corner & 2 ? half.y() : -half.y(),
                 corner & 4 ? half.z() : -half.z());
    const double needed = std::max(std::abs(d.dot(right())) / tan_x, std::abs(d.dot(up())) / tan_y);
    distance = std::max(distance, needed - d.dot(forward()));
  }
  const Vec<2> shift = r.centre - 0.5 * Vec<2>(size.width, size.height);
  pan(shift, size);
}

ViewMargins settled(const ViewMargins& m, const Camera& camera, const ViewBounds& bounds, ViewSize size) {
  const ViewMargins above{m.left, m.right, m.top, m.bottom};
  if (m.left_corner + m.right_corner <= 0) return above;
  const ViewMargins between{std::max(m.left, m.left_corner), std::max(m.right, m.right_corner), m.top, m.between};
  const auto largeness = [&](const ViewMargins& margins) {
    Camera fitted = camera;
    std::visit([&](auto& c) { c.fit(bounds, size, margins); }, fitted);
    if (const auto* flat = std::get_if<Camera2D>(&fitted)) return flat->pixels_per_metre;
    return std::get<OrbitCamera>(fitted).pixels_per_metre(size);
  };
  const bool room = size.width - between.left - between.right > 0.25 * size.width;
  return room && largeness(between) > largeness(above) ? between : above;
}

Camera fitted_camera(int dimension, const ViewBounds& bounds, ViewSize size, const ViewMargins& margins) {
  if (dimension == 2) {
    Camera2D camera;
    camera.fit(bounds, size, margins);
    return camera;
  }
  OrbitCamera camera;
  camera.fit(bounds, size, margins);
  return camera;
}

std::optional<Vec<2>> to_pixel(const Camera& camera, const Vec3& world, ViewSize size) {
  if (const auto* flat = std::get_if<Camera2D>(&camera)) return flat->to_pixel(world, size);
  return std::get<OrbitCamera>(camera).to_pixel(world, size);
}

}  // namespace pf
