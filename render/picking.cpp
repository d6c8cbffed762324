// What a snapshot occupies, and which particle is under the mouse: camera.hpp declares both.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "render/camera.hpp"
#include "render/particle_shape.hpp"

namespace pf {

namespace {

/// Radius of the ball of volume 1.
constexpr double unit_ball = 0.6203504909;

Vec3 position(const Snapshot& s, std::size_t p) {
  return s.dimension == 2 ? Vec3(s.x[2 * p], s.x[2 * p + 1], 0) : Vec3(s.x[3 * p], s.x[3 * p + 1], s.x[3 * p + 2]);
}

/// Half the side of the particle's reference cell, at least.
double half_side(const Snapshot& s, std::size_t p) {
  return 0.5 * static_cast<double>(side_of(s, p));
}

/// Is `offset` from the particle's centre inside its square mapped by F?
bool in_mapped_square(const Snapshot& s, std::size_t p, const Vec<2>& offset) {
  if (s.F.size() < 4 * (p + 1)) return offset.cwiseAbs().maxCoeff() <= half_side(s, p);
  const float* const f = s.F.data() + 4 * p;
  const glm::mat2 mapped = mapped_by(s, p, glm::mat2(f[0], f[1], f[2], f[3]));
  const Mat<2> F = Eigen::Map<const Eigen::Matrix2f>(&mapped[0][0]).cast<double>();
  const double J = F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
  if (std::abs(J) < 1e-12) return false;
  const Vec<2> X(F(1, 1) * offset.x() - F(0, 1) * offset.y(), -F(1, 0) * offset.x() + F(0, 0) * offset.y());
  return (X / J).cwiseAbs().maxCoeff() <= half_side(s, p);
}

std::optional<std::size_t> pick_flat(const Snapshot& s, const Camera2D& camera, ViewSize size, const Vec<2>& pixel,
                                     double reach) {
  const Vec<2> at = camera.to_world(pixel, size).head<2>();
  std::optional<std::size_t> best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vec<2> offset = at - position(s, p).head<2>();
    const double d = offset.norm();
    const bool hit = d * camera.pixels_per_metre <= reach || in_mapped_square(s, p, offset);
    if (hit && d < best_distance) {
      best = p;
      best_distance = d;
    }
  }
  return best;
}

/// Where the ray from the eye enters the particle's ball mapped by F, as it is drawn; infinite where it misses.
/// `centre` is relative to the eye.
double ellipsoid_entry(const Snapshot& s, std::size_t p, const Vec3& centre, const Vec3& ray) {
  const double infinity = std::numeric_limits<double>::infinity(), radius = unit_ball * 2 * half_side(s, p);
  Mat3 A = Mat3::Identity();
  if (s.F.size() >= 9 * (p + 1)) A = Eigen::Map<const Eigen::Matrix3f>(s.F.data() + 9 * p).cast<double>();
  const double largest = radius * A.norm();  // no singular value is larger
  if ((centre - ray.dot(centre) * ray).squaredNorm() > largest * largest || std::abs(A.determinant()) < 1e-6)
    return infinity;
  const Mat3 inverse = A.inverse() / radius;
  const Vec3 o = -(inverse * centre), d = inverse * ray;
  const double a = d.squaredNorm(), b = o.dot(d), discriminant = b * b - a * (o.squaredNorm() - 1);
  return discriminant < 0 ? infinity : (-b - std::sqrt(discriminant)) / a;
}

std::optional<std::size_t> pick_solid(const Snapshot& s, const OrbitCamera& camera, ViewSize size, const Vec<2>& pixel,
                                      double reach) {
  const Vec3 eye = camera.eye(), ray = camera.ray(pixel, size);
  const double radians_per_pixel = 1 / (camera.pixels_per_metre(size) * camera.distance);
  std::optional<std::size_t> inside, near;
  double inside_depth = std::numeric_limits<double>::infinity(), near_miss = inside_depth;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vec3 d = position(s, p) - eye;
    const double depth = d.dot(ray);
    if (depth <= 0) continue;
    const double miss = (d - depth * ray).norm(), radius = 2 * unit_ball * half_side(s, p);
    const double entry = ellipsoid_entry(s, p, d, ray);
    if (entry < inside_depth) {
      inside = p;
      inside_depth = entry;
    }
    const double angle = (miss - radius) / depth;
    if (angle <= reach * radians_per_pixel && angle < near_miss) {
      near = p;
      near_miss = angle;
    }
  }
  return inside ? inside : near;
}

}  // namespace

std::optional<std::size_t> pick_particle(const Snapshot& snapshot, const Camera& camera, ViewSize size,
                                         const Vec<2>& pixel, double reach) {
  if (const auto* flat = std::get_if<Camera2D>(&camera)) return pick_flat(snapshot, *flat, size, pixel, reach);
  return pick_solid(snapshot, std::get<OrbitCamera>(camera), size, pixel, reach);
}

ViewBounds widened(const ViewBounds& seen, const ViewBounds& body, double size) {
  const Vec3 centre = seen.centre(), most = Vec3::Constant(1.5 * size);
  return {seen.min.cwiseMin(body.min.cwiseMax(centre - most)), seen.max.cwiseMax(body.max.cwiseMin(centre + most))};
}

ViewBounds particle_bounds(const Snapshot& snapshot) {
  const double infinity = std::numeric_limits<double>::infinity();
  ViewBounds b{Vec3::Constant(infinity), Vec3::Constant(-infinity)};
  for (std::size_t p = 0; p < snapshot.particles; ++p) {
    const Vec3 x = position(snapshot, p);
    if (!x.allFinite()) continue;
    const Vec3 h = Vec3::Constant(half_side(snapshot, p));
    b.min = b.min.cwiseMin(x - h);
    b.max = b.max.cwiseMax(x + h);
  }
  if (!(b.min.x() <= b.max.x())) return {Vec3::Constant(-0.5), Vec3::Constant(0.5)};
  if (snapshot.dimension == 2) b.min.z() = b.max.z() = 0;
  return b;
}

namespace {
/// The upper corner of a solid, or of what is of interest of a container: bodies fall, so its upper part stays empty.
Vec3 with_lid_cut(const BoundaryView& solid, const ViewBounds& body) {
  Vec3 max = solid.max;
  const bool holds_body = (solid.min.head<2>().array() <= body.min.head<2>().array()).all() &&
                          (solid.max.head<2>().array() >= body.max.head<2>().array()).all();
  if (holds_body) max.y() = std::min(max.y(), body.max.y() + 0.15 * (body.max.y() - solid.min.y()));
  return max;
}
}  // namespace

ViewBounds scene_bounds(const Snapshot& first) {
  const ViewBounds body = particle_bounds(first);
  ViewBounds b = body;
  const double reach = body.size().maxCoeff();
  if (!first.scene) return b;
  const auto include = [&](const Vec3& min, const Vec3& max, double limit) {
    for (int a = 0; a < first.dimension; ++a) {
      if (std::isfinite(min[a])) b.min[a] = std::min(b.min[a], std::max(min[a], body.min[a] - limit));
      if (std::isfinite(max[a])) b.max[a] = std::max(b.max[a], std::min(max[a], body.max[a] + limit));
    }
  };
  for (const BoundaryView& solid : first.scene->boundaries) {
    if (solid.min.head(first.dimension).allFinite() && solid.max.head(first.dimension).allFinite())
      include(solid.min, with_lid_cut(solid, body), 1.5 * reach);
    if (!solid.distance) continue;
    // The way from the body down to an unbounded floor, with some of the floor itself.
    const Vec3 below(body.centre().x(), body.min.y(), body.centre().z());
    for (double d = 0; d < 3 * reach; d += 0.02 * reach) {
      if (solid.distance(below - Vec3(0, d, 0)) > 0) continue;
      const double ground = below.y() - d - 0.06 * reach;
      include(Vec3(INFINITY, ground, INFINITY), Vec3::Constant(INFINITY), 3.1 * reach);
      break;
    }
  }
  return b;
}

}  // namespace pf
