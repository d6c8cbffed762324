#include "core/charts/raster.hpp"

#include <algorithm>
#include <cmath>

namespace pf {
namespace {

bool finite(Point2 p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

/// The pixels that [min, max], widened by `margin`, touches within `clip`.
PixelRect covering(Point2 min, Point2 max, float margin, const PixelRect& clip) {
  const auto low = [&](float v, int end) {
    return static_cast<int>(std::floor(std::clamp(v - margin, -1.0f, static_cast<float>(end))));
  };
  const auto high = [&](float v, int end) {
    return static_cast<int>(std::ceil(std::clamp(v + margin, -1.0f, static_cast<float>(end))));
  };
  return intersection({low(min.x, clip.x1), low(min.y, clip.y1), high(max.x, clip.x1), high(max.y, clip.y1)}, clip);
}

float distance_to_segment(Point2 p, Point2 a, Point2 b) {
  const float dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  const float t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0f, 1.0f) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

Point2 centre_of(int x, int y) {
  return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
}

}  // namespace

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

void Raster::begin(const PixelRect& box) {
  coverage_.assign(static_cast<std::size_t>(box.x1 - box.x0 + 1) * static_cast<std::size_t>(box.y1 - box.y0), 0.0f);
}

void Raster::blend(const PixelRect& box, Color color) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const float alpha = coverage(box, x, y) * color.a;
      if (alpha < 1.0f / 512) continue;
      std::uint8_t* p = image_.at(x, y);
      const float below = static_cast<float>(p[3]) / 255 * (1 - alpha), total = alpha + below;
      const float source[] = {color.r, color.g, color.b};
      for (int a = 0; a < 3; ++a) {
        const float mixed = (255 * source[a] * alpha + static_cast<float>(p[a]) * below) / total;
        p[a] = static_cast<std::uint8_t>(std::clamp(mixed + 0.5f, 0.0f, 255.0f));
      }
      p[3] = static_cast<std::uint8_t>(std::min(255 * total + 0.5f, 255.0f));
    }
  }
}

/// Adds the edge's signed area to the right of it: each cell of a row gets the change of coverage that a running sum
/// over the row turns into coverage (R. Levien, font-rs).
void Raster::add_edge(const PixelRect& box, Point2 a, Point2 b) {
  if (a.y == b.y) return;
  const float direction = a.y < b.y ? 1.0f : -1.0f;
  if (a.y > b.y) std::swap(a, b);
  const float slope = (b.x - a.x) / (b.y - a.y), left = static_cast<float>(box.x0), right = static_cast<float>(box.x1);
  const int first = std::max(box.y0, static_cast<int>(std::floor(std::max(a.y, static_cast<float>(box.y0)))));
  const int end = std::min(box.y1, static_cast<int>(std::ceil(std::min(b.y, static_cast<float>(box.y1)))));
  for (int y = first; y < end; ++y) {
    const float top = std::max(a.y, static_cast<float>(y)), bottom = std::min(b.y, static_cast<float>(y + 1));
    if (bottom <= top) continue;
    // Beyond the box's sides the edge acts as if it lay on them.
    const float xa = std::clamp(a.x + (top - a.y) * slope, left, right),
                xb = std::clamp(a.x + (bottom - a.y) * slope, left, right);
    const float x0 = std::min(xa, xb), x1 = std::max(xa, xb), height = direction * (bottom - top);
    const int cell = std::min(static_cast<int>(std::floor(x0)), box.x1 - 1), last = static_cast<int>(std::ceil(x1));
    if (last <= cell + 1) {
      const float inside = 1 - (0.5f * (x0 + x1) - static_cast<float>(cell));
      coverage(box, cell, y) += height * inside;
      coverage(box, cell + 1, y) += height * (1 - inside);
      continue;
    }
    // The edge crosses several cells: the area right of it, cell by cell.
    float before = 0;
    for (int x = cell; x < last; ++x) {
      const float from = std::max(x0, static_cast<float>(x)), to = std::min(x1, static_cast<float>(x + 1));
      const float share = (to - from) / (x1 - x0), done = (from - x0) / (x1 - x0);
      const float covered = done * 1.0f + share * (static_cast<float>(x + 1) - 0.5f * (from + to));
      coverage(box, x, y) += height * (covered - before);
      before = covered;
    }
    coverage(box, last, y) += height * (1 - before);
  }
}

void Raster::fill(std::span<const std::vector<Point2>> outlines, Color color, const PixelRect& clip) {
  Point2 min{1e30f, 1e30f}, max{-1e30f, -1e30f};
  for (const auto& outline : outlines) {
    for (const Point2 p : outline) {
      if (!finite(p)) return;
      min = {std::min(min.x, p.x), std::min(min.y, p.y)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
  }
  const PixelRect box = covering(min, max, 0, clip);
  if (box.empty()) return;
  begin(box);
  for (const auto& outline : outlines) {
    for (std::size_t k = 0; k < outline.size(); ++k) add_edge(box, outline[k], outline[(k + 1) % outline.size()]);
  }
  for (int y = box.y0; y < box.y1; ++y) {
    float sum = 0;
    for (int x = box.x0; x < box.x1; ++x) {
      sum += coverage(box, x, y);
      coverage(box, x, y) = std::min(std::abs(sum), 1.0f);
    }
  }
  blend(box, color);
}

void Raster::stroke(std::span<const Point2> segments, float width, Color color, const PixelRect& clip) {
  const float half = 0.5f * std::max(width, 1.0f);
  color.a *= std::min(width, 1.0f);
  Point2 min{1e30f, 1e30f}, max{-1e30f, -1e30f};
  for (const Point2 p : segments) {
    if (!finite(p)) continue;
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  const PixelRect box = covering(min, max, half + 1, clip);
  if (box.empty()) return;
  begin(box);
  for (std::size_t k = 0; k + 1 < segments.size(); k += 2) {
    const Point2 a = segments[k], b = segments[k + 1];
    if (!finite(a) || !finite(b)) continue;
    const PixelRect near =
        covering({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}, half + 1, box);
    for (int y = near.y0; y < near.y1; ++y) {
      for (int x = near.x0; x < near.x1; ++x) {
        float& covered = coverage(box, x, y);
        if (covered >= 1) continue;
        const float d = distance_to_segment(centre_of(x, y), a, b);
        covered = std::max(covered, std::clamp(half + 0.5f - d, 0.0f, 1.0f));
      }
    }
  }
  blend(box, color);
}

void Raster::rectangle(Point2 min, Point2 max, float rounding, Color color, const PixelRect& clip) {
  if (!finite(min) || !finite(max) || max.x <= min.x || max.y <= min.y) return;
  const PixelRect box = covering(min, max, 0, clip);
  if (box.empty()) return;
  begin(box);
  rounding = std::min({rounding, 0.5f * (max.x - min.x), 0.5f * (max.y - min.y)});
  const Point2 centre{0.5f * (min.x + max.x), 0.5f * (min.y + max.y)};
  const Point2 straight{0.5f * (max.x - min.x) - rounding, 0.5f * (max.y - min.y) - rounding};
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const float fx = static_cast<float>(x), fy = static_cast<float>(y);
      float covered = (std::min(max.x, fx + 1) - std::max(min.x, fx)) * (std::min(max.y, fy + 1) - std::max(min.y, fy));
      const Point2 p = centre_of(x, y);
      const float dx = std::abs(p.x - centre.x) - straight.x, dy = std::abs(p.y - centre.y) - straight.y;
      if (rounding > 0 && dx > 0 && dy > 0) {
        covered = std::min(covered, std::clamp(rounding + 0.5f - std::hypot(dx, dy), 0.0f, 1.0f));
      }
      coverage(box, x, y) = covered;
    }
  }
  blend(box, color);
}

void Raster::annulus(Point2 centre, float inner, float outer, Color color, const PixelRect& clip) {
  if (!finite(centre) || !(outer > 0)) return;
  const PixelRect box = covering(centre, centre, outer + 1, clip);
  if (box.empty()) return;
  begin(box);
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const Point2 p = centre_of(x, y);
      const float d = std::hypot(p.x - centre.x, p.y - centre.y);
      float covered = std::clamp(outer + 0.5f - d, 0.0f, 1.0f);
      if (inner > 0) covered = std::min(covered, std::clamp(d - inner + 0.5f, 0.0f, 1.0f));
      coverage(box, x, y) = covered;
    }
  }
  blend(box, color);
}

}  // namespace pf
