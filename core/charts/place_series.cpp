// From a series' values to the polylines and marks that can be seen.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/charts/clip_segment.hpp"
#include "core/charts/placing.hpp"

namespace pf::placing {
namespace {

struct Pixel {
  double x, y;
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

/// What an AxisMap does, with its logarithms taken once: a series may have a million points.
class FastMap {
 public:
  explicit FastMap(const AxisMap& map) : logarithmic_(map.scale == AxisScale::logarithmic) {
    const double low = logarithmic_ ? std::log(map.min) : map.min, high = logarithmic_ ? std::log(map.max) : map.max;
    slope_ = (map.to - map.from) / (high - low);
    low_ = low;
    from_ = map.from;
  }
  /// Also false where differences would overflow.
  bool holds(double value) const { return std::abs(value) <= 1e300 && (!logarithmic_ || value > 0); }
  double place(double value) const { return from_ + slope_ * ((logarithmic_ ? std::log(value) : value) - low_); }

 private:
  bool logarithmic_;
  double slope_, low_, from_;
};

/// The points of a series that can be drawn, and their pixels.
class Points {
 public:
  Points(const Series& series, const AxisMap& x, const AxisMap& y)
      : series_(series), x_(x), y_(y), size_(std::min(series.x.size(), series.y.size())) {}
  std::size_t size() const { return size_; }
  bool valid(std::size_t k) const { return x_.holds(series_.x[k]) && y_.holds(series_.y[k]); }
  double column(std::size_t k) const { return std::floor(x_.place(series_.x[k])); }
  double y(std::size_t k) const { return series_.y[k]; }
  Pixel pixel(std::size_t k) const { return {x_.place(series_.x[k]), y_.place(series_.y[k])}; }

 private:
  const Series& series_;
  FastMap x_, y_;
  std::size_t size_;
};

/// The end, excluded, of the run of valid points that begins at `first` and stays in its pixel column; the points of
/// the run with the least and the largest value.
std::size_t end_of_column(const Points& points, std::size_t first, std::size_t& low, std::size_t& high) {
  low = high = first;
  const double column = points.column(first);
  std::size_t k = first + 1;
  for (; k < points.size() && points.valid(k) && points.column(k) == column; ++k) {
    if (points.y(k) < points.y(low)) low = k;
    if (points.y(k) > points.y(high)) high = k;
  }
  return k;
}

std::vector<std::vector<Point2>> place_lines(const Points& points, const Box& plot) {
  const bool thin = static_cast<double>(points.size()) > 4 * std::max(1.0f, plot.width());
  ClippedLines lines(plot.grown(4));
  std::optional<Pixel> before;
  const auto draw_to = [&](std::size_t k) {
    const Pixel at = points.pixel(k);
    if (before) lines.segment(*before, at);
    before = at;
  };
  for (std::size_t k = 0; k < points.size();) {
    if (!points.valid(k)) {
      lines.lift();
      before.reset();
      ++k;
    } else if (!thin) {
      draw_to(k++);
    } else {
      // The first, lowest, highest and last of a column give the same picture as all of them.
      std::size_t low = k, high = k;
      const std::size_t end = end_of_column(points, k, low, high);
      const std::size_t kept[] = {k, std::min(low, high), std::max(low, high), end - 1};
      for (std::size_t j = 0; j < 4; ++j) {
        if (j == 0 || kept[j] != kept[j - 1]) draw_to(kept[j]);
      }
      k = end;
    }
  }
  return lines.take();
}

/// Leaves one mark for each half pixel.
std::vector<Point2> distinct(std::vector<Point2> marks) {
  if (marks.size() < 1000) return marks;
  const auto key = [](Point2 p) { return std::pair(std::lround(2 * p.x), std::lround(2 * p.y)); };
  std::ranges::sort(marks, {}, key);
  const auto same = [&key](Point2 a, Point2 b) { return key(a) == key(b); };
  marks.erase(std::unique(marks.begin(), marks.end(), same), marks.end());
  return marks;
}

}  // namespace

PlacedSeries place_series(const Chart& chart, const ChartLayout& layout, std::size_t index) {
  const Series& series = chart.series[index];
  const Points points(series, layout.x.map, layout.vertical(chart, index));
  PlacedSeries placed;
  std::vector<Point2> marks;
  const bool draws_marks = series.style != SeriesStyle::line;
  // A hair beyond the frame still counts: rounding must not lose a point on the axis.
  const Box frame = layout.plot.grown(0.5f);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!points.valid(k)) continue;
    const bool lone = (k == 0 || !points.valid(k - 1)) && (k + 1 == points.size() || !points.valid(k + 1));
    if (!draws_marks && !lone) continue;
    const Point2 at = to_point(points.pixel(k));
    if (frame.contains(at)) marks.push_back(at);
  }
  placed.marks = distinct(std::move(marks));
  if (series.style != SeriesStyle::points) placed.lines = place_lines(points, layout.plot);
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
