// What lies behind the particles of a 2D view, kept while it stays the same. Internal to render/.
#pragma once

#include "render/frame.hpp"

namespace pf {

/// Background and solids change with the camera, hardly ever with the state. A processor that plays the graphics card
/// copies them much faster than it shades them.
class Backdrop {
 public:
  /// Whether this frame's backdrop is the one kept: then show() draws it.
  bool serves(const Frame& frame) const { return kept_ && key_ == Key::of(frame); }
  void show(const Frame& frame) const;
  /// The framebuffer that is bound holds this frame's backdrop now. It is kept from the second time on: a camera that
  /// moves would keep in vain.
  void offer(const Frame& frame);
  void invalidate() { key_ = {}, kept_ = false; }

 private:
  struct Key {
    std::shared_ptr<const SceneView> scene;  ///< kept alive, so that its address identifies it
    Camera camera;
    ViewSize size;
    std::vector<Vec3> displacement;
    RenderTheme theme;
    bool grid = false, boundaries = false;
    float scale = 0;
    double spacing = 0;
    bool operator==(const Key&) const = default;
    static Key of(const Frame& frame);
  };
  Key key_;
  bool kept_ = false;
  ViewSize size_{0, 0};
  gl::Framebuffer framebuffer_;
  gl::Renderbuffer color_;
};

}  // namespace pf
