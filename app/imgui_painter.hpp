// core/charts' Painter over an ImDrawList: charts, legends and the view's overlay in the window.
#pragma once

#include <vector>

#include "core/charts/painter.hpp"

struct ImDrawList;
struct ImFont;

namespace pf::app {

class ImGuiPainter : public Painter {
 public:
  /// `scale` pixels of ImGui a unit of the painter.
  explicit ImGuiPainter(ImDrawList& list, float scale = 1) : list_(list), scale_(scale) {}
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
  std::vector<Point2> scaled(std::span<const Point2> points) const;
  void dashes(std::span<const Point2> points, unsigned color, float width, float dash);

  ImDrawList& list_;
  float scale_;
};

}  // namespace pf::app
