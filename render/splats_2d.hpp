// Very many particles of a 2D scene where the processor plays the graphics card: each an upright square, filled by
// ourselves. That is several times faster than to have OpenGL's general machinery run on the processor for them.
// Internal to render/.
#pragma once

#include "render/frame.hpp"

namespace pf {

class Splats2D {
 public:
  void draw(const Frame& frame);

 private:
  /// Rows of `pixels_` that hold something: [first, last).
  struct Rows {
    int first = 0, last = 0;
  };
  Rows fill(const Frame& frame);

  Program program_{"splats2d"};
  gl::FullScreen full_screen_;
  gl::Texture texture_;
  ViewSize size_{0, 0};
  std::vector<std::uint32_t> pixels_;  ///< RGBA8, rows from the bottom
};

}  // namespace pf
