// What the mouse does to a chart: find a point, zoom, pan.
#include <algorithm>
#include <cmath>

#include "core/charts/layout.hpp"

namespace pf {
namespace {

/// Moves the axis' view to [low, high] unless the numbers would end there.
void set_view(Axis& axis, double low, double high) {
  const double magnitude = std::max(std::abs(low), std::abs(high));
  if (!std::isfinite(low) || !std::isfinite(high) || magnitude > 1e300) return;
  if (axis.scale == AxisScale::linear ? high - low < 1e-10 * magnitude || high - low < 1e-290
                                      : low < 1e-300 || high / low < 1 + 1e-6)
    return;
  axis.min = low;
  axis.max = high;
}

/// The view whose ends are now at these pixels.
void view_pixels(Axis& axis, const AxisMap& map, double from, double to) {
  set_view(axis, map.value(from), map.value(to));
}

}  // namespace

std::optional<ChartHit> hit_test(const Chart& chart, const ChartLayout& layout, Point2 at, float radius) {
  if (!layout.plot.contains(at)) return std::nullopt;
  std::optional<ChartHit> hit;
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    const Series& series = chart.series[s];
    // Only the stretch of x within reach is looked at in y.
    const double left = layout.x.map.value(at.x - radius), right = layout.x.map.value(at.x + radius);
    for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
      if (!(series.x[k] >= left && series.x[k] <= right)) continue;
      const Point2 p = layout.place(chart, {s, k});
      const float distance = std::hypot(p.x - at.x, p.y - at.y);
      if (!(distance <= radius) || (hit && distance >= hit->distance) || !layout.plot.grown(0.5f).contains(p)) continue;
      hit = ChartHit{{s, k}, series.x[k], series.y[k], p, distance};
    }
  }
  return hit;
}

std::optional<std::size_t> cell_at(const Chart& chart, const ChartLayout& layout, Point2 at) {
  if (!layout.plot.contains(at)) return std::nullopt;
  const double x = layout.x.map.value(at.x), y = layout.y.map.value(at.y);
  for (std::size_t k = chart.cells.size(); k-- > 0;) {
    const Cell& cell = chart.cells[k];
    if (x >= cell.x_min && x <= cell.x_max && y >= cell.y_min && y <= cell.y_max) return k;
  }
  return std::nullopt;
}

void zoom(Chart& chart, const ChartLayout& layout, Point2 at, double factor, bool along_x, bool along_y) {
  if (!(factor > 0)) return;
  const auto about = [&](Axis& axis, const AxisMap& map, double centre) {
    view_pixels(axis, map, centre + factor * (map.from - centre), centre + factor * (map.to - centre));
  };
  if (along_x) about(chart.x, layout.x.map, at.x);
  if (along_y) about(chart.y, layout.y.map, at.y);
  if (along_y && chart.right && layout.right) about(*chart.right, layout.right->map, at.y);
}

void pan(Chart& chart, const ChartLayout& layout, Point2 by) {
  const auto along = [](Axis& axis, const AxisMap& map, double shift) {
    view_pixels(axis, map, map.from - shift, map.to - shift);
  };
  along(chart.x, layout.x.map, by.x);
  along(chart.y, layout.y.map, by.y);
  if (chart.right && layout.right) along(*chart.right, layout.right->map, by.y);
}

void reset_view(Chart& chart) {
  for (Axis* axis : {&chart.x, &chart.y, chart.right ? &*chart.right : nullptr}) {
    if (axis) axis->min = axis->max = std::nullopt;
  }
}

}  // namespace pf
