// Particles of a 3D scene. Internal to render/.
#pragma once

#include "render/color_texture.hpp"
#include "render/ink.hpp"

namespace pf {

/// The soft shadow that the body casts.
struct Shadow {
  bool on = false;
  glm::mat4 to_map{1};  ///< relative to the frame's origin -> texture coordinates and depth
  float softness = 0;   ///< in texture coordinates
  /// Sets the uniforms that all receivers share; the map lies on texture unit 2.
  void set(Program& program) const;
};

class ParticleLayer3D {
 public:
  ParticleLayer3D();
  /// Uploads what changed.
  void prepare(const Frame& frame);
  /// Lit particles into the bound target; depth is written.
  void draw(const Frame& frame, const glm::mat4& view, const glm::mat4& projection, const Shadow& shadow,
            ColorTexture& colors);
  /// Depth only, along the light.
  void draw_shadow(const Frame& frame, const glm::mat4& view, const glm::mat4& projection);
  /// Marks of inverted and selected particles.
  void draw_marks(const Frame& frame, InkPrograms& ink) { marks_.draw(ink, frame, anchor_, 1); }
  /// Bounds of the particles uploaded last [m].
  const ViewBounds& bounds() const { return bounds_; }
  void invalidate() { key_ = {}; }

 private:
  void upload(const Frame& frame);
  /// The program for balls, in use, with what every use of it sets.
  Program& balls(const Frame& frame, const glm::mat4& view, const glm::mat4& projection, bool shadows);

  ReceiverProgram balls_{"ellipsoid3d"};
  Program points_{"points"};
  gl::Batch ball_data_, point_data_;
  Ink marks_;
  Anchor anchor_;
  DataKey key_;
  ViewBounds bounds_;
  bool cheap_ = false;
};

}  // namespace pf
