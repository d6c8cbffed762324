// Rigid solids and regions of a 3D scene. Internal to render/.
#pragma once

#include "render/ink.hpp"
#include "render/particle_layer_3d.hpp"
#include "render/surface_mesh.hpp"

namespace pf {

class BoundaryLayer3D {
 public:
  BoundaryLayer3D();
  /// Makes planes and meshes, once a scene; `body` says where an unbounded solid is of interest.
  void prepare(const Frame& frame, const ViewBounds& body);
  /// Planes and meshes into the bound target. The body's depth lies on texture unit 1.
  void draw_solids(const Frame& frame, const Shadow& shadow, const ViewBounds& body);
  /// Depth of the meshes along the light, into the bound shadow map.
  void draw_shadow(const Frame& frame, const glm::mat4& view_projection);
  /// `body` and the bounded solids beside it.
  ViewBounds with_solids(const Snapshot& snapshot, const ViewBounds& body) const;
  void draw_regions(const Frame& frame, InkPrograms& ink);
  void invalidate() { scene_ = nullptr; }

 private:
  void upload_regions(const Frame& frame);
  void draw_plane(const Frame& frame, const Shadow& shadow, const ViewBounds& body, const Plane& plane);

  struct Solid {
    std::size_t boundary;
    std::optional<Plane> plane;
    bool container;  ///< solid outside
    ViewBounds bounds;
    Vec3 centre;  ///< that the mesh's coordinates are relative to
    gl::Batch mesh;
  };
  ReceiverProgram plane_program_{"ground3d"}, mesh_program_{"mesh3d"};
  gl::FullScreen square_;
  std::vector<Solid> solids_;
  Ink regions_;
  Anchor region_anchor_;
  const SceneView* scene_ = nullptr;
};

}  // namespace pf
