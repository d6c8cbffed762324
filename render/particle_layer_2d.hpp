// Particles of a 2D scene. Internal to render/.
#pragma once

#include "render/color_texture.hpp"
#include "render/ink.hpp"
#include "render/splats_2d.hpp"

namespace pf {

class ParticleLayer2D {
 public:
  ParticleLayer2D();
  void draw(const Frame& frame, ColorTexture& colors, InkPrograms& ink);
  void invalidate() { key_ = {}; }

 private:
  void upload(const Frame& frame);
  void draw_squares(const Frame& frame);

  Program squares_{"particle2d"};
  gl::Batch square_data_;
  Splats2D splats_;
  Ink marks_;
  Anchor anchor_;
  DataKey key_;
  bool cheap_ = false;
};

}  // namespace pf
