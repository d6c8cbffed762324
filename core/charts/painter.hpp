// What a chart, a legend or an overlay is drawn with; ImDrawList, SVG and PNG each implement it once.
#pragma once

#include <span>
#include <string_view>

namespace pf {

/// Straight (not premultiplied) sRGB, each in [0, 1].
struct Color {
  float r = 0, g = 0, b = 0, a = 1;
  bool operator==(const Color&) const = default;
};
/// Pixels, y downwards.
struct Point2 {
  float x = 0, y = 0;
};
enum class TextAlign { left, centre, right };
enum class FontWeight { regular, bold };

class Painter {
 public:
  virtual ~Painter() = default;
  /// Open polyline, round joins. `dash` <= 0: solid; else dash and gap length in pixels.
  virtual void polyline(std::span<const Point2> points, Color color, float width, float dash = 0) = 0;
  /// Convex or not, not self-intersecting; filled.
  virtual void polygon(std::span<const Point2> points, Color fill) = 0;
  virtual void rectangle(Point2 min, Point2 max, Color fill, float rounding = 0) = 0;
  virtual void circle(Point2 centre, float radius, Color fill) = 0;
  virtual void ring(Point2 centre, float radius, Color color, float width) = 0;
  /// UTF-8. `size`: the em in pixels (not ascent to descent, which is 1.36 em). `at`: baseline-left/centre/right by
  /// `align`; `quarter_turns` counter-clockwise.
  virtual void text(Point2 at, std::string_view text, float size, Color color, TextAlign align = TextAlign::left,
                    FontWeight weight = FontWeight::regular, int quarter_turns = 0) = 0;
  virtual float text_width(std::string_view text, float size, FontWeight weight = FontWeight::regular) const = 0;
  virtual void push_clip(Point2 min, Point2 max) = 0;
  virtual void pop_clip() = 0;
};

}  // namespace pf
