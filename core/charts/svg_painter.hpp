// Paints into an SVG 1.1 document: text stays text, lines stay lines.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/charts/painter.hpp"

namespace pf {

class SvgPainter final : public Painter {
 public:
  /// width, height [pixels].
  SvgPainter(float width, float height);

  void polyline(std::span<const Point2> points, Color color, float width, float dash = 0) override;
  void polygon(std::span<const Point2> points, Color fill) override;
  void rectangle(Point2 min, Point2 max, Color fill, float rounding = 0) override;
  void circle(Point2 centre, float radius, Color fill) override;
  void ring(Point2 centre, float radius, Color color, float width) override;
  void text(Point2 at, std::string_view text, float size, Color color, TextAlign align = TextAlign::left,
            FontWeight weight = FontWeight::regular, int quarter_turns = 0) override;
  /// By the shipped fonts' metrics; viewers without Noto Sans take the nearest sans, a little wider or narrower.
  float text_width(std::string_view text, float size, FontWeight weight = FontWeight::regular) const override;
  void push_clip(Point2 min, Point2 max) override;
  void pop_clip() override;

  /// The whole document; every clip must have been popped. `title` is its accessible name, `notes` (name, text) go
  /// to <metadata>.
  std::string document(std::string_view title = {},
                       const std::vector<std::pair<std::string, std::string>>& notes = {}) const;

 private:
  float width_, height_;
  int clips_ = 0, open_ = 0;
  std::string body_;
};

/// Text as XML content or attribute: markup escaped, characters that XML forbids replaced by U+FFFD.
std::string xml_escaped(std::string_view text);

}  // namespace pf
