#include "app/inside/marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pf::app {

void mark_line(Painter& painter, Point2 a, Point2 b, Color color, float width) {
  const std::array line{a, b};
  Color rim = mark_rim;
  rim.a *= color.a;
  painter.polyline(line, rim, 2.2F * width);
  painter.polyline(line, color, width);
}

void mark_arrow(Painter& painter, Point2 from, Point2 to, Color color, float em) {
  const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length < 0.15F * em) return;
  const float ux = dx / length, uy = dy / length, head = std::min(0.55F * em, 0.6F * length), half = 0.45F * head;
  const Point2 base{to.x - head * ux, to.y - head * uy};
  mark_line(painter, from, base, color, 0.12F * em);
  const auto tip = [&](float more) {
    return std::array{Point2{to.x + more * ux, to.y + more * uy},
                      Point2{base.x - more * ux - (half + more) * uy, base.y - more * uy + (half + more) * ux},
                      Point2{base.x - more * ux + (half + more) * uy, base.y - more * uy - (half + more) * ux}};
  };
  const auto rim = tip(0.08F * em), inner = tip(0);
  painter.polygon(rim, mark_rim);
  painter.polygon(inner, color);
}

void mark_disc(Painter& painter, Point2 at, float radius, Color color) {
  painter.circle(at, radius + 1.2F, mark_rim);
  painter.circle(at, radius, color);
}

void mark_label(Painter& painter, Point2 at, const std::string& text, float em) {
  const float size = 0.86F * em, pad = 0.3F * em, width = painter.text_width(text, size);
  const Point2 low{at.x + 0.6F * em, at.y - 1.5F * em};
  painter.rectangle(low, {low.x + width + 2 * pad, low.y + size + 1.6F * pad}, {0, 0, 0, 0.74F}, 0.25F * em);
  painter.text({low.x + pad, low.y + 0.7F * pad + 0.82F * size}, text, size, {1, 1, 1, 1});
}

}  // namespace pf::app
