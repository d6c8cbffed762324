// Rigid solids and regions of a 2D scene. Internal to render/.
#pragma once

#include <initializer_list>

#include "render/distance_map.hpp"
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
  /// Pixels of the view from its lower left corner.
  struct Box {
    int left = 0, bottom = 0, right = 0, top = 0;
    bool empty() const { return left >= right || bottom >= top; }
  };
  Box reach(const DistanceMap& map, std::initializer_list<std::size_t> channels, double margin) const;
  void draw(const Frame& frame, bool solids);

  Program program_{"solid2d"};
  gl::FullScreen full_screen_;
  gl::Texture distance_;
  glm::vec2 uv_scale_{1}, uv_shift_{0};
  Box solids_, regions_;  ///< all that they cover: nothing else is shaded
  // What the distances were sampled for.
  const SceneView* scene_ = nullptr;
  Camera2D camera_;
  ViewSize size_;
  std::vector<Vec3> displacement_;
};

}  // namespace pf
