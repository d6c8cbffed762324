// Lines, arrows and marks whose width is given in pixels, in 2D and 3D alike. Internal to render/.
#pragma once

#include <vector>

#include "render/frame.hpp"

namespace pf {

struct Segment {
  glm::vec3 from, to;
  Rgba8 color;
};
enum class MarkStyle { dot = 0, ring = 1, cross = 2, square = 3 };
struct Mark {
  glm::vec3 at;
  Rgba8 color;
  float radius;  ///< in layout pixels
  float style;   ///< MarkStyle
};

/// The programs that all ink shares.
struct InkPrograms {
  Program segment{"segment"}, marker{"marker"};
};

class Ink {
 public:
  Ink();
  /// Coordinates relative to `anchor`.
  void upload(const std::vector<Segment>& segments, const std::vector<Mark>& marks);
  /// `width` in layout pixels; `head` > 0 makes arrows with heads of that length; a `rim` of a
  /// pixel sets lines off from what is below.
  void draw(InkPrograms& programs, const Frame& frame, const Anchor& anchor, float width, float head = 0,
            Color rim = {0, 0, 0, 0}) const;

 private:
  gl::Batch segments_, marks_;
};

}  // namespace pf
