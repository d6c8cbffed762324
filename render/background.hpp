// What is behind everything: gradient and, in 2D, the lattice. Internal to render/.
#pragma once

#include "render/frame.hpp"

namespace pf {

class Background {
 public:
  void draw(const Frame& frame);

 private:
  Program program_{"background2d"};
  gl::FullScreen full_screen_;
};

}  // namespace pf
