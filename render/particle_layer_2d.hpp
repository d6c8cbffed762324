// Particles of a 2D scene. Internal to render/.
#pragma once

#include "render/color_texture.hpp"
#include "render/ink.hpp"

namespace pf {

class ParticleLayer2D {
 public:
  ParticleLayer2D();
  void draw(const Frame& frame, ColorTexture& colors, InkPrograms& ink);
  void invalidate() { key_ = {}; }

 private:
  void upload(const Frame& frame);
  void draw_points(const Frame& frame);
  void draw_squares(const Frame& frame);

  Program squares_{"particle2d"}, points_{"points"};
  gl::Batch square_data_, point_data_;
  Ink marks_;
  Anchor anchor_;
  DataKey key_;
  bool cheap_ = false;
};

}  // namespace pf
