// Puts the 3D picture together. Internal to render/.
#pragma once

#include "render/background.hpp"
#include "render/boundary_layer_3d.hpp"
#include "render/grid_layer.hpp"
#include "render/particle_layer_3d.hpp"
#include "render/target_3d.hpp"

namespace pf {

/// Body into its own colour and depth; then, in a second target, background, body with eye-dome shading, solids
/// (which know the body's depth and become a veil in front of it), grid and marks; at last, averaged, into the
/// framebuffer that was bound.
class View3D {
 public:
  void draw(Frame& frame, Background& background, GridLayer& grid, ColorTexture& colors, InkPrograms& ink,
            const gl::TargetGuard& destination);
  void invalidate();

 private:
  Shadow draw_shadow(const Frame& frame);
  void compose(const Frame& inner);
  void resolve(const Frame& frame);

  ParticleLayer3D particles_;
  BoundaryLayer3D boundaries_;
  Program composite_{"composite3d"}, resolve_{"resolve"};
  gl::FullScreen full_screen_;
  TextureTarget body_, picture_, shadow_map_{false};
  float near_ = 0.1f, far_ = 100;
};

}  // namespace pf
