// Rigid solids and regions of a 2D scene. Internal to render/.
#pragma once

#include "render/frame.hpp"

namespace pf {

class BoundaryLayer2D {
 public:
  /// Samples the distances anew when the view or a displacement has changed.
  void prepare(const Frame& frame);
  void draw_solids(const Frame& frame) { draw(frame, true); }
  void draw_regions(const Frame& frame) { draw(frame, false); }
  void invalidate() { scene_ = nullptr; }

 private:
  void draw(const Frame& frame, bool solids);

  Program program_{"solid2d"};
  gl::FullScreen full_screen_;
  gl::Texture distance_;
  glm::vec2 uv_scale_{1}, uv_shift_{0};
  bool solids_ = false, regions_ = false;
  // What the distances were sampled for.
  const SceneView* scene_ = nullptr;
  Camera2D camera_;
  ViewSize size_;
  std::vector<Vec3> displacement_;
};

}  // namespace pf
