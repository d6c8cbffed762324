// Paints onto an Image, anti-aliased, in software: charts without a display, overlays on rendered pictures.
#pragma once

#include <vector>

#include "core/charts/raster.hpp"

namespace pf {

class PngPainter final : public Painter {
 public:
  /// Draws on the image as it is; `scale` image pixels a unit of the painter (2 for print and HiDPI).
  explicit PngPainter(Image& image, float scale = 1);

  void polyline(std::span<const Point2> points, Color color, float width, float dash = 0) override;
  void polygon(std::span<const Point2> points, Color fill) override;
  void rectangle(Point2 min, Point2 max, Color fill, float rounding = 0) override;
  void circle(Point2 centre, float radius, Color fill) override;
  void ring(Point2 centre, float radius, Color color, float width) override;
  void text(Point2 at, std::string_view text, float size, Color color, TextAlign align = TextAlign::left,
            FontWeight weight = FontWeight::regular, int quarter_turns = 0) override;
  float text_width(std::string_view text, float size, FontWeight weight = FontWeight::regular) const override;
  void push_clip(Point2 min, Point2 max) override;
  void pop_clip() override;

 private:
  Point2 scaled(Point2 p) const { return {scale_ * p.x, scale_ * p.y}; }

  Raster raster_;
  float scale_;
  std::vector<PixelRect> clips_;
};

}  // namespace pf
