#include "core/charts/png_painter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/charts/font.hpp"

namespace pf {
namespace {

/// The drawn stretches of a dashed polyline as segments. Round caps lengthen each by `width`, so it is cut shorter.
std::vector<Point2> dashes(std::span<const Point2> points, float dash, float width) {
  std::vector<Point2> segments;
  const float on = std::max(dash - width, 0.01f), period = 2 * dash;
  float travelled = 0.5f * width;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Point2 a = points[k], b = points[k + 1];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    if (!std::isfinite(length) || length == 0) continue;
    const auto along = [&](float s) { return Point2{a.x + s / length * (b.x - a.x), a.y + s / length * (b.y - a.y)}; };
    for (float n = std::floor(travelled / period); n * period < travelled + length; ++n) {
      const float from = std::max(n * period - travelled, 0.0f), to = std::min(n * period + on - travelled, length);
      if (to <= from) continue;
      segments.push_back(along(from));
      segments.push_back(along(to));
    }
    travelled += length;
  }
  return segments;
}

}  // namespace

PngPainter::PngPainter(Image& image, float scale)
    : raster_(image), scale_(scale), clips_{{0, 0, image.width, image.height}} {}

void PngPainter::polyline(std::span<const Point2> points, Color color, float width, float dash) {
  std::vector<Point2> line(points.size());
  std::ranges::transform(points, line.begin(), [&](Point2 p) { return scaled(p); });
  std::vector<Point2> segments;
  if (dash > 0) {
    segments = dashes(line, scale_ * dash, scale_ * width);
  } else {
    for (std::size_t k = 0; k + 1 < line.size(); ++k) segments.insert(segments.end(), {line[k], line[k + 1]});
  }
  raster_.stroke(segments, scale_ * width, color, clips_.back());
}

void PngPainter::polygon(std::span<const Point2> points, Color fill) {
  std::vector<std::vector<Point2>> outlines(1);
  for (const Point2 p : points) outlines[0].push_back(scaled(p));
  raster_.fill(outlines, fill, clips_.back());
}

void PngPainter::rectangle(Point2 min, Point2 max, Color fill, float rounding) {
  raster_.rectangle(scaled(min), scaled(max), scale_ * rounding, fill, clips_.back());
}

void PngPainter::circle(Point2 centre, float radius, Color fill) {
  raster_.annulus(scaled(centre), 0, scale_ * radius, fill, clips_.back());
}

void PngPainter::ring(Point2 centre, float radius, Color color, float width) {
  const float half = 0.5f * std::max(1.0f, scale_ * width);
  raster_.annulus(scaled(centre), scale_ * radius - half, scale_ * radius + half, color, clips_.back());
}

void PngPainter::text(Point2 at, std::string_view text, float size, Color color, TextAlign align, FontWeight weight,
                      int quarter_turns) {
  Outlines outlines = shipped_font(weight).outlines(text, scale_ * size);
  float shift = 0;
  if (align != TextAlign::left)
    shift = scale_ * text_width(text, size, weight) * (align == TextAlign::centre ? 0.5f : 1.0f);
  // The baseline on whole pixels keeps stems and bars sharp.
  Point2 origin = scaled(at);
  (quarter_turns % 2 == 0 ? origin.y : origin.x) = std::round(quarter_turns % 2 == 0 ? origin.y : origin.x);
  for (auto& outline : outlines) {
    for (Point2& p : outline) {
      p.x -= shift;
      for (int turn = 0; turn < (quarter_turns % 4 + 4) % 4; ++turn) p = {p.y, -p.x};
      p = {p.x + origin.x, p.y + origin.y};
    }
  }
  raster_.fill(outlines, color, clips_.back());
}

float PngPainter::text_width(std::string_view text, float size, FontWeight weight) const {
  return shipped_font(weight).width(text, size);
}

void PngPainter::push_clip(Point2 min, Point2 max) {
  const auto whole = [](float v) { return static_cast<int>(std::lround(std::clamp(v, -1e6f, 1e6f))); };
  const Point2 a = scaled(min), b = scaled(max);
  clips_.push_back(intersection({whole(a.x), whole(a.y), whole(b.x), whole(b.y)}, clips_.back()));
}

void PngPainter::pop_clip() {
  assert(clips_.size() > 1);
  clips_.pop_back();
}

}  // namespace pf
