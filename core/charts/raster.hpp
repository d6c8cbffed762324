// Anti-aliased filling of shapes in software: how much of each pixel a shape covers, blended onto an Image.
#pragma once

#include <span>
#include <vector>

#include "core/charts/image.hpp"

namespace pf {

/// Pixels [x0, x1) x [y0, y1).
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};
PixelRect intersection(const PixelRect& a, const PixelRect& b);

/// Each call draws one shape within `clip`. Coordinates are pixels, pixel (0, 0) spans [0, 1] x [0, 1]; what is not
/// finite is left out.
class Raster {
 public:
  explicit Raster(Image& image) : image_(image) {}

  /// Closed outlines by the non-zero rule for outlines that do not cross themselves; holes run the other way.
  /// Exact area of each pixel.
  void fill(std::span<const std::vector<Point2>> outlines, Color color, const PixelRect& clip);
  /// All points within width / 2 of the segments (pairs of points): round joins and caps, no double blending where
  /// they overlap. Narrower than a pixel fades instead.
  void stroke(std::span<const Point2> segments, float width, Color color, const PixelRect& clip);
  /// Axis-parallel, corners rounded by `rounding`.
  void rectangle(Point2 min, Point2 max, float rounding, Color color, const PixelRect& clip);
  /// The ring between two radii; inner 0 or less: a disc.
  void annulus(Point2 centre, float inner, float outer, Color color, const PixelRect& clip);

 private:
  void begin(const PixelRect& box);
  void blend(const PixelRect& box, Color color);
  float& coverage(const PixelRect& box, int x, int y) {
    return coverage_[static_cast<std::size_t>(y - box.y0) * static_cast<std::size_t>(box.x1 - box.x0 + 1) +
                     static_cast<std::size_t>(x - box.x0)];
  }
  void add_edge(const PixelRect& box, Point2 a, Point2 b);

  Image& image_;
  std::vector<float> coverage_;  ///< of the current shape's box, a spare column at the right
};

}  // namespace pf
