#include "core/scene/solid.hpp"

#include <Eigen/Geometry>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/scene/shapes/shape_types.hpp"

namespace pf {
namespace {

constexpr int max_nesting = 64;

SolidPointer make(const Shape& shape, const ShapeContext& context);

std::vector<SolidPointer> make_members(const Shape& shape, const ShapeContext& context) {
  if (shape.of.empty()) throw std::invalid_argument("a " + shape.type + " of nothing");
  ShapeContext deeper = context;
  ++deeper.nesting;
  std::vector<SolidPointer> members;
  for (const Shape& member : shape.of) members.push_back(make(member, deeper));
  return members;
}

Vec3 center_of(const Shape& shape, const Solid& solid) {
  if (shape.type == "half_space") return shape.point;
  const Bounds b = solid.bounds();
  Vec3 center = Vec3::Zero();
  for (int a = 0; a < 3; ++a)
    if (std::isfinite(b.min[a]) && std::isfinite(b.max[a])) center[a] = 0.5 * b.min[a] + 0.5 * b.max[a];
  return center;
}

Mat3 rotation_of(const Shape& shape, int dimension) {
  const Vec3 axis = dimension == 2 ? Vec3::UnitZ() : shape.rotate_axis.stableNormalized();
  Mat3 R = Eigen::AngleAxisd(shape.rotate_degrees * std::numbers::pi / 180, axis).toRotationMatrix();
  // A quarter turn keeps faces parallel to the axes, exactly.
  for (int i = 0; i < 9; ++i)
    for (const double exact : {-1.0, 0.0, 1.0})
      if (std::abs(R(i) - exact) < 1e-15) R(i) = exact;
  return R;
}

SolidPointer make(const Shape& shape, const ShapeContext& context) {
  const int dimension = context.dimension;
  if (context.nesting > max_nesting) throw std::invalid_argument("shapes are nested too deep");
  const ShapeType* type = find_shape_type(shape.type);
  if (!type) throw std::invalid_argument("no shape is called \"" + shape.type + "\"");
  if (type->dimension != 0 && type->dimension != dimension)
    throw std::invalid_argument("a " + shape.type + " needs " + std::to_string(type->dimension) + " dimensions");
  SolidPointer solid = type->make(shape, context);
  const bool moved = shape.scale != 1 || shape.rotate_degrees != 0 || !shape.translate.isZero(0);
  if (!moved) return solid;
  Vec3 translation = shape.translate, center = center_of(shape, *solid);
  if (dimension == 2) translation.z() = center.z() = 0;
  return make_transformed(std::move(solid), shape.scale, rotation_of(shape, dimension), center, translation);
}

}  // namespace

std::unique_ptr<Solid> make_solid(const Shape& shape, int dimension, const Constants& constants) {
  return make(shape, {dimension, constants, make_members, 0});
}

void complete_basis(const Vec3& n, Vec3& u, Vec3& v) {
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  u = n.cross(Vec3::Unit(least)).normalized();
  v = n.cross(u);
}

void drop_repeated(std::vector<Vec3>& normals, std::size_t first) {
  std::size_t kept = first;
  for (std::size_t i = first; i < normals.size(); ++i) {
    const auto same = [&](const Vec3& n) { return n.dot(normals[i]) > 1 - 1e-12; };
    const auto begin = normals.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = normals.begin() + static_cast<std::ptrdiff_t>(kept);
    if (std::none_of(begin, end, same)) normals[kept++] = normals[i];
  }
  normals.resize(kept);
}

}  // namespace pf
