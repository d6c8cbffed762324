// Textures that the 3D picture is put together in. Internal to render/.
#pragma once

#include "render/frame.hpp"

namespace pf {

/// Colour and depth textures of one size, made again when the size changes.
class TextureTarget {
 public:
  /// `color` false: depth only, with comparison (a shadow map).
  explicit TextureTarget(bool color = true) : has_color_(color) {}
  void resize(ViewSize size);
  /// Draws go here, over the whole of it.
  void bind() const;
  void bind_color(int unit) const;
  void bind_depth(int unit) const;
  ViewSize size() const { return size_; }

 private:
  bool has_color_;
  ViewSize size_{0, 0};
  gl::Framebuffer framebuffer_;
  gl::Texture color_, depth_;
};

}  // namespace pf
