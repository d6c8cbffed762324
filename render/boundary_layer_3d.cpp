#include "render/boundary_layer_3d.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

namespace pf {

namespace {

struct MeshVertex {
  glm::vec3 x, normal;
};
constexpr std::array mesh_layout{gl::Attribute{0, 3, offsetof(MeshVertex, x)},
                                 gl::Attribute{1, 3, offsetof(MeshVertex, normal)}};
/// Cells along a mesh's longest side.
int mesh_resolution(const Frame& frame) {
  return frame.software && !frame.options.best_quality ? 24 : 56;
}

glm::vec3 to_glm(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Bounded solids with a little room; of unbounded ones the part around the body.
ViewBounds mesh_bounds(const BoundaryView& solid, const ViewBounds& body) {
  const Vec3 reach = Vec3::Constant(1.5 * body.size().maxCoeff());
  ViewBounds b{body.min - reach, body.max + reach};
  for (int a = 0; a < 3; ++a) {
    if (std::isfinite(solid.min[a])) b.min[a] = solid.min[a];
    if (std::isfinite(solid.max[a])) b.max[a] = solid.max[a];
  }
  const Vec3 room = Vec3::Constant(0.03 * b.size().maxCoeff());
  return {b.min - room, b.max + room};
}

std::vector<MeshVertex> relative_to(const Vec3& centre, const std::vector<SurfaceVertex>& mesh) {
  std::vector<MeshVertex> out;
  out.reserve(mesh.size());
  for (const SurfaceVertex& v : mesh) out.push_back({to_glm(v.position - centre), to_glm(v.normal)});
  return out;
}

Vec3 displacement(const Snapshot& s, std::size_t boundary) {
  return boundary < s.boundary_displacement.size() ? s.boundary_displacement[boundary] : Vec3::Zero();
}

/// 1, 2 or 5 times a power of ten, at most `most`.
double round_step(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1);
}

/// The twelve edges of a box.
void add_box(const RegionView& region, const Anchor& anchor, Rgba8 color, std::vector<Segment>& segments) {
  const auto corner = [&](int c) {
    return Vec3(c & 1 ? region.max.x() : region.min.x(), c & 2 ? region.max.y() : region.min.y(),
                c & 4 ? region.max.z() : region.min.z());
  };
  for (int c = 0; c < 8; ++c)
    for (const int bit : {1, 2, 4})
      if (!(c & bit)) segments.push_back({relative(corner(c), anchor), relative(corner(c | bit), anchor), color});
}

}  // namespace

BoundaryLayer3D::BoundaryLayer3D() = default;

void BoundaryLayer3D::prepare(const Frame& frame, const ViewBounds& body) {
  const Snapshot& s = frame.snapshot;
  if (scene_ == s.scene.get()) return;
  scene_ = s.scene.get();
  solids_.clear();
  if (!s.scene) return;
  for (std::size_t b = 0; b < s.scene->boundaries.size(); ++b) {
    const BoundaryView& view = s.scene->boundaries[b];
    if (!view.distance) continue;
    Solid solid{b, as_plane(view, body), false, {}, Vec3::Zero(), gl::Batch(sizeof(MeshVertex), mesh_layout, false)};
    if (!solid.plane) {
      solid.bounds = mesh_bounds(view, body);
      solid.centre = solid.bounds.centre();
      solid.container = view.distance(solid.bounds.min) < 0 && view.distance(solid.bounds.max) < 0;
      solid.mesh.upload(relative_to(solid.centre, surface_mesh(view.distance, solid.bounds, mesh_resolution(frame))));
    }
    solids_.push_back(std::move(solid));
  }
  upload_regions(frame);
}

void BoundaryLayer3D::upload_regions(const Frame& frame) {
  region_anchor_.drop_at(frame);
  std::vector<Segment> segments;
  for (const RegionView& r : frame.snapshot.scene->regions) {
    if (!r.min.allFinite() || !r.max.allFinite()) continue;
    Color color = r.kind == "load" ? frame.theme().load : frame.theme().constraint;
    color.a = 0.8f;
    add_box(r, region_anchor_, rgba8(color), segments);
  }
  regions_.upload(segments, {});
}

void BoundaryLayer3D::draw_plane(const Frame& frame, const Shadow& shadow, const ViewBounds& body, const Plane& plane) {
  const auto& camera = std::get<OrbitCamera>(frame.camera);
  const double reach = std::max(3 * body.size().maxCoeff(), 1.2 * camera.distance);
  const Vec3 n = plane.normal;
  if (n.dot(camera.eye() - plane.point) <= 0) return;  // seen from inside of the solid
  const Vec3 tangent = n.cross(std::abs(n.y()) > 0.9 ? Vec3::UnitZ() : Vec3::UnitY()).normalized();
  const Vec3 bitangent = n.cross(tangent);
  // The lattice belongs to the world; its middle is below the body.
  const Vec3 middle = body.centre() - n * n.dot(body.centre() - plane.point);
  const double pitch = round_step(body.size().maxCoeff() / 6);
  const auto phase = [&](const Vec3& axis) {
    const double q = axis.dot(middle) / (5 * pitch);
    return 5 * (q - std::floor(q));
  };
  Program& p = plane_program_.form(shadow.on);
  p.use();
  p.set("u_view_projection", frame.view_projection);
  p.set("u_point", to_glm(middle - frame.origin));
  p.set("u_tangent", to_glm(tangent));
  p.set("u_bitangent", to_glm(bitangent));
  p.set("u_phase", glm::vec2(phase(tangent), phase(bitangent)));
  p.set("u_pitch", static_cast<float>(pitch));
  p.set("u_reach", static_cast<float>(reach));
  p.set("u_fill", rgb(frame.theme().ground));
  p.set("u_line", rgb(frame.theme().ground_line));
  shadow.set(p);
  square_.draw_square();
}

void BoundaryLayer3D::draw_solids(const Frame& frame, const Shadow& shadow, const ViewBounds& body) {
  const auto& camera = std::get<OrbitCamera>(frame.camera);
  for (const Solid& solid : solids_) {
    const Vec3 shift = displacement(frame.snapshot, solid.boundary);
    if (solid.plane) {
      draw_plane(frame, shadow, body, {solid.plane->point + shift, solid.plane->normal});
      continue;
    }
    Program& mesh = mesh_program_.form(shadow.on);
    mesh.use();
    mesh.set("u_view_projection", frame.view_projection);
    mesh.set("u_offset", to_glm(solid.centre + shift - frame.origin));
    mesh.set("u_eye", to_glm(camera.eye() - frame.origin));
    mesh.set("u_fill", rgb(frame.theme().solid_3d));
    mesh.set("u_body_depth", 1);
    mesh.set("u_veil", 0.3f);
    mesh.set("u_casting", false);
    shadow.set(mesh);
    solid.mesh.draw_vertices(GL_TRIANGLES);
  }
}

void BoundaryLayer3D::draw_shadow(const Frame& frame, const glm::mat4& view_projection) {
  Program& mesh = mesh_program_.form(false);
  mesh.use();
  mesh.set("u_view_projection", view_projection);
  mesh.set("u_casting", true);
  for (const Solid& solid : solids_) {
    // Containers would darken everything that they hold.
    if (solid.plane || solid.container) continue;
    const Vec3 shift = displacement(frame.snapshot, solid.boundary);
    mesh.set("u_offset", to_glm(solid.centre + shift - frame.origin));
    solid.mesh.draw_vertices(GL_TRIANGLES);
  }
}

ViewBounds BoundaryLayer3D::with_solids(const Snapshot& snapshot, const ViewBounds& body) const {
  ViewBounds all = body;
  const Vec3 reach = Vec3::Constant(1.5 * body.size().maxCoeff());
  for (const Solid& solid : solids_) {
    if (solid.plane || solid.container) continue;
    const Vec3 shift = displacement(snapshot, solid.boundary);
    all.min = all.min.cwiseMin((solid.bounds.min + shift).cwiseMax(body.min - reach));
    all.max = all.max.cwiseMax((solid.bounds.max + shift).cwiseMin(body.max + reach));
  }
  return all;
}

void BoundaryLayer3D::draw_regions(const Frame& frame, InkPrograms& ink) {
  if (!region_anchor_.serves(frame) && frame.snapshot.scene) upload_regions(frame);
  regions_.draw(ink, frame, region_anchor_, 1.2f);
}

}  // namespace pf
