// Drawing without a display: an EGL context and a multisampled framebuffer to read pictures back from.
#pragma once

#include <memory>

#include "core/charts/image.hpp"
#include "render/camera.hpp"

namespace pf {

/// An OpenGL 3.3 core context that needs no window system; current on the thread that made it until destroyed.
/// Throws std::runtime_error, saying what was tried, when none can be had.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;
  void make_current();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A framebuffer with colour and depth. Needs a current context, off-screen or a window's.
class OffscreenTarget {
 public:
  /// `samples`: 1 is without multisampling; fewer are used where the machine offers fewer.
  OffscreenTarget(ViewSize size, int samples = 4);
  ~OffscreenTarget();
  OffscreenTarget(const OffscreenTarget&) = delete;
  OffscreenTarget& operator=(const OffscreenTarget&) = delete;

  ViewSize size() const;
  void bind();
  /// Copies what was drawn to the framebuffer that is bound for drawing (of one sample a pixel), its lower left corner
  /// to x, y. `drawn_anew`: since the last copy.
  void copy_to(int x, int y, bool drawn_anew);
  Image read();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pf
