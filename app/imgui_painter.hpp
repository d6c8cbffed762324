// core/charts' Painter over an ImDrawList: charts, legends and the view's overlay in the window.
#pragma once

#include "core/charts/painter.hpp"

struct ImDrawList;
struct ImFont;

namespace pf::app {

class ImGuiPainter : public Painter {
 public:
  explicit ImGuiPainter(ImDrawList& list) : list_(list) {}
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
  void dashes(std::span<const Point2> points, unsigned color, float width, float dash);
  ImDrawList& list_;
};

}  // namespace pf::app
