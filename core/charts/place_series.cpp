// From a series' values to the polylines and marks that can be seen.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/charts/clip_segment.hpp"
#include "core/charts/placing.hpp"

namespace pf::placing {
namespace {

struct Pixel {
  double x, y;
  bool valid() const { return std::isfinite(x) && std::isfinite(y); }
};

Point2 to_point(Pixel p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

/// Builds polylines clipped to a box, so that no painter meets the far ends of a zoomed line.
class ClippedLines {
 public:
  explicit ClippedLines(const Box& box) : box_(box) {}

  void segment(Pixel a, Pixel b) {
    double t0 = 0, t1 = 1;
    const double dx = b.x - a.x, dy = b.y - a.y;
    const bool visible = clip_segment(a.x, a.y, b.x, b.y, box_.min.x, box_.min.y, box_.max.x, box_.max.y, t0, t1);
    if (!visible) {
      open_ = false;
      return;
    }
    if (!open_ || t0 > 0) lines_.push_back({to_point({a.x + t0 * dx, a.y + t0 * dy})});
    lines_.back().push_back(to_point({a.x + t1 * dx, a.y + t1 * dy}));
    open_ = t1 >= 1;
  }
  void lift() { open_ = false; }
  std::vector<std::vector<Point2>> take() { return std::move(lines_); }

 private:
  Box box_;
  bool open_ = false;
  std::vector<std::vector<Point2>> lines_;
};

/// Replaces runs of points in one pixel column by their first, lowest, highest and last: the same picture.
std::vector<Pixel> thinned(const std::vector<Pixel>& points) {
  std::vector<Pixel> out;
  for (std::size_t k = 0; k < points.size();) {
    if (!points[k].valid()) {
      out.push_back(points[k++]);
      continue;
    }
    const double column = std::floor(points[k].x);
    std::size_t low = k, high = k, end = k;
    for (; end < points.size() && points[end].valid() && std::floor(points[end].x) == column; ++end) {
      if (points[end].y < points[low].y) low = end;
      if (points[end].y > points[high].y) high = end;
    }
    std::size_t kept[] = {k, std::min(low, high), std::max(low, high), end - 1};
    for (std::size_t j = 0; j < 4; ++j) {
      if (j == 0 || kept[j] != kept[j - 1]) out.push_back(points[kept[j]]);
    }
    k = end;
  }
  return out;
}

/// Leaves one mark for each half pixel.
std::vector<Point2> distinct(std::vector<Point2> marks) {
  if (marks.size() < 1000) return marks;
  const auto key = [](Point2 p) { return std::pair(std::lround(2 * p.x), std::lround(2 * p.y)); };
  std::ranges::sort(marks, {}, key);
  const auto rest = std::ranges::unique(marks, {}, key);
  marks.erase(rest.begin(), rest.end());
  return marks;
}

}  // namespace

PlacedSeries place_series(const Chart& chart, const ChartLayout& layout, std::size_t index) {
  const Series& series = chart.series[index];
  const AxisMap &x = layout.x.map, &y = layout.vertical(chart, index);
  std::vector<Pixel> points(std::min(series.x.size(), series.y.size()));
  for (std::size_t k = 0; k < points.size(); ++k) points[k] = {x.place(series.x[k]), y.place(series.y[k])};

  PlacedSeries placed;
  std::vector<Point2> marks;
  const bool draws_line = series.style != SeriesStyle::points, draws_marks = series.style != SeriesStyle::line;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool lone = (k == 0 || !points[k - 1].valid()) && (k + 1 == points.size() || !points[k + 1].valid());
    if (!points[k].valid() || !(draws_marks || lone)) continue;
    // A hair beyond the frame still counts: rounding must not lose a point on the axis.
    if (layout.plot.grown(0.5f).contains(to_point(points[k]))) marks.push_back(to_point(points[k]));
  }
  placed.marks = distinct(std::move(marks));
  if (!draws_line) return placed;

  if (static_cast<double>(points.size()) > 4 * std::max(1.0f, layout.plot.width())) points = thinned(points);
  ClippedLines lines(layout.plot.grown(4));
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (points[k].valid() && points[k + 1].valid()) {
      lines.segment(points[k], points[k + 1]);
    } else {
      lines.lift();
    }
  }
  placed.lines = lines.take();
  return placed;
}

std::vector<Point2> occupied(const ChartLayout& layout) {
  constexpr float spacing = 5;
  std::vector<Point2> points;
  const auto along = [&](Point2 a, Point2 b) {
    const int pieces = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / spacing);
    for (int k = 0; k <= pieces; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(pieces);
      points.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  };
  for (const PlacedSeries& series : layout.series) {
    points.insert(points.end(), series.marks.begin(), series.marks.end());
    for (const auto& line : series.lines) {
      for (std::size_t k = 0; k + 1 < line.size(); ++k) along(line[k], line[k + 1]);
    }
  }
  for (const PlacedTriangle& triangle : layout.triangles) {
    for (int k = 0; k < 3; ++k) along(triangle.corners[k], triangle.corners[(k + 1) % 3]);
  }
  return points;
}

}  // namespace pf::placing
