#include "core/charts/png_painter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/charts/clip_segment.hpp"
#include "core/charts/font.hpp"

namespace pf {
namespace {

/// The drawn stretches of a dashed polyline as segments, as far as they are seen. Round caps lengthen each by
/// `width`, so it is cut shorter.
std::vector<Point2> dashes(std::span<const Point2> points, double dash, double width, const PixelRect& clip) {
  std::vector<Point2> segments;
  const double on = std::max(dash - width, 0.01), period = 2 * dash;
  double travelled = 0.5 * width;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double ax = points[k].x, ay = points[k].y, dx = points[k + 1].x - ax, dy = points[k + 1].y - ay;
    const double length = std::hypot(dx, dy);
    if (!(length > 0) || !std::isfinite(length)) continue;
    double t0 = 0, t1 = 1;
    if (clip_segment(ax, ay, ax + dx, ay + dy, clip.x0 - width, clip.y0 - width, clip.x1 + width, clip.y1 + width, t0,
                     t1)) {
      const auto along = [&](double s) {
        return Point2{static_cast<float>(ax + s / length * dx), static_cast<float>(ay + s / length * dy)};
      };
      const double first = std::floor((travelled + t0 * length) / period), end = (travelled + t1 * length) / period;
      for (double n = first; n < end; ++n) {
        const double from = std::max(n * period - travelled, t0 * length),
                     to = std::min(n * period + on - travelled, t1 * length);
        if (to > from) segments.insert(segments.end(), {along(from), along(to)});
      }
    }
    travelled = std::fmod(travelled + length, period);
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
    segments = dashes(line, scale_ * dash, scale_ * width, clips_.back());
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
