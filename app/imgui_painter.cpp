#include "app/imgui_painter.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/theme.hpp"

namespace pf::app {
namespace {

ImU32 packed(Color c) {
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a});
}
ImVec2 vec(Point2 p) {
  return {p.x, p.y};
}

std::vector<ImVec2>& copied(std::span<const Point2> points, std::vector<ImVec2>& into) {
  into.resize(points.size());
  std::transform(points.begin(), points.end(), into.begin(), vec);
  return into;
}

/// Glyphs are sharp at the size they were made for: a size close to it is drawn in it.
float sharp(float size, const ImFont& font) {
  return std::abs(font.FontSize - size) < 0.09f * size ? font.FontSize : size;
}

/// Twice the signed area of the corner a b c.
float turn(Point2 a, Point2 b, Point2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool inside(Point2 p, Point2 a, Point2 b, Point2 c) {
  const float u = turn(a, b, p), v = turn(b, c, p), w = turn(c, a, p);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

bool convex(std::span<const Point2> p) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const float t = turn(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]);
    left |= t > 0;
    right |= t < 0;
  }
  return !(left && right);
}

}  // namespace

std::vector<Point2> ImGuiPainter::scaled(std::span<const Point2> points) const {
  std::vector<Point2> out(points.size());
  std::transform(points.begin(), points.end(), out.begin(), [this](Point2 p) { return scaled(p); });
  return out;
}

void ImGuiPainter::polyline(std::span<const Point2> points, Color color, float width, float dash) {
  if (points.size() < 2) return;
  const std::vector<Point2> there = scaled(points);
  if (dash > 0) return dashes(there, packed(color), width * scale_, dash * scale_);
  std::vector<ImVec2> line;
  copied(there, line);
  list_.AddPolyline(line.data(), static_cast<int>(line.size()), packed(color), ImDrawFlags_None, width * scale_);
}

void ImGuiPainter::dashes(std::span<const Point2> points, unsigned color, float width, float dash) {
  float walked = 0;  // along the line, so that the pattern runs on around corners
  std::vector<ImVec2> piece;
  const auto flush = [&] {
    if (piece.size() > 1)
      list_.AddPolyline(piece.data(), static_cast<int>(piece.size()), color, ImDrawFlags_None, width);
    piece.clear();
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point2 a = points[i], b = points[i + 1];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    for (float s = 0; s < length;) {
      const bool drawn = std::fmod(walked, 2 * dash) < dash;
      // At least a hundredth of a pixel, so that rounding cannot stop the walk.
      const float step = std::min(length - s, std::max(dash - std::fmod(walked, dash), 0.01f));
      const auto at = [&](float t) { return ImVec2(a.x + (b.x - a.x) * t / length, a.y + (b.y - a.y) * t / length); };
      if (drawn) {
        if (piece.empty()) piece.push_back(at(s));
        piece.push_back(at(s + step));
      } else {
        flush();
      }
      s += step;
      walked += step;
    }
  }
  flush();
}

void ImGuiPainter::polygon(std::span<const Point2> unscaled, Color fill) {
  const std::vector<Point2> points = scaled(unscaled);
  if (points.size() < 3) return;
  if (convex(points)) {
    std::vector<ImVec2> outline;
    copied(points, outline);
    // ImGui smooths the rim outwards only of polygons that run clockwise.
    if (turn(points[0], points[1], points[2]) < 0) std::reverse(outline.begin(), outline.end());
    list_.AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()), packed(fill));
    return;
  }
  // Ears are cut off until a triangle remains. Their rims are not smoothed: that would show where they meet.
  const ImDrawListFlags flags = list_.Flags;
  list_.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  std::vector<Point2> left = points;
  float area = 0;
  for (std::size_t i = 1; i + 1 < left.size(); ++i) area += turn(left[0], left[i], left[i + 1]);
  const float side = area >= 0 ? 1.0f : -1.0f;
  while (left.size() > 2) {
    bool cut = false;
    for (std::size_t i = 0; i < left.size() && !cut; ++i) {
      const std::size_t n = left.size();
      const Point2 a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
      if (side * turn(a, b, c) < 0) continue;
      cut = true;
      for (std::size_t k = 0; k < n && cut; ++k)
        if (k != i && k != (i + 1) % n && k != (i + n - 1) % n && inside(left[k], a, b, c)) cut = false;
      if (!cut) continue;
      list_.AddTriangleFilled(vec(a), vec(b), vec(c), packed(fill));
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    }
    if (!cut) break;  // crosses itself: outside of what the interface promises
  }
  list_.Flags = flags;
}

void ImGuiPainter::rectangle(Point2 min, Point2 max, Color fill, float rounding) {
  list_.AddRectFilled(vec(scaled(min)), vec(scaled(max)), packed(fill), rounding * scale_);
}
void ImGuiPainter::circle(Point2 centre, float radius, Color fill) {
  list_.AddCircleFilled(vec(scaled(centre)), radius * scale_, packed(fill));
}
void ImGuiPainter::ring(Point2 centre, float radius, Color color, float width) {
  list_.AddCircle(vec(scaled(centre)), radius * scale_, packed(color), 0, width * scale_);
}

void ImGuiPainter::text(Point2 where, std::string_view text, float units, Color color, TextAlign align,
                        FontWeight weight, int quarter_turns) {
  const Point2 at = scaled(where);
  ImFont* font = font_for(scale_ * units, weight);
  const float width = scale_ * text_width(text, units, weight), size = sharp(scale_ * units, *font);
  const float shift = align == TextAlign::left ? 0 : align == TextAlign::centre ? width / 2 : width;
  const float baseline = font->Ascent * size / font->FontSize;
  const ImVec2 corner{std::round(at.x - (quarter_turns % 4 ? 0 : shift)), std::round(at.y - baseline)};
  if (quarter_turns % 4 == 0) {
    list_.AddText(font, size, corner, packed(color), text.data(), text.data() + text.size());
    return;
  }
  const int first = list_.VtxBuffer.Size;
  // Nothing may be left out for where it lies before the turn; the list's own clip holds after it.
  font->RenderText(&list_, size, corner, packed(color), {-1e6f, -1e6f, 1e6f, 1e6f}, text.data(),
                   text.data() + text.size());
  // Turn the glyphs' corners about `at`, after moving the text along its own line.
  const float angle = static_cast<float>(quarter_turns) * 1.5707963f;
  const float c = std::round(std::cos(angle)), s = std::round(std::sin(angle));
  for (int i = first; i < list_.VtxBuffer.Size; ++i) {
    ImVec2& p = list_.VtxBuffer[i].pos;
    const float x = p.x - std::round(at.x) - std::round(shift), y = p.y - std::round(at.y);
    p = {std::round(at.x) + c * x + s * y, std::round(at.y) - s * x + c * y};
  }
}

float ImGuiPainter::text_width(std::string_view text, float size, FontWeight weight) const {
  const ImFont* font = font_for(scale_ * size, weight);
  const float pixels = sharp(scale_ * size, *font);
  return font->CalcTextSizeA(pixels, 1e9f, 0, text.data(), text.data() + text.size()).x / scale_;
}

void ImGuiPainter::push_clip(Point2 min, Point2 max) {
  list_.PushClipRect(vec(scaled(min)), vec(scaled(max)), true);
}
void ImGuiPainter::pop_clip() {
  list_.PopClipRect();
}

}  // namespace pf::app
