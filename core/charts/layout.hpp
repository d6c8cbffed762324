// Where everything of a chart goes: pure geometry, from data, theme and text widths. Drawing only paints it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/charts/chart.hpp"
#include "core/charts/theme.hpp"
#include "core/charts/ticks.hpp"

namespace pf {

struct Box {
  Point2 min = {}, max = {};
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
  Point2 centre() const { return {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)}; }
  bool contains(Point2 p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
  bool overlaps(const Box& o) const { return min.x < o.max.x && o.min.x < max.x && min.y < o.max.y && o.min.y < max.y; }
  Box grown(float by) const { return {{min.x - by, min.y - by}, {max.x + by, max.y + by}}; }
};

/// Values <-> pixels along one axis.
struct AxisMap {
  AxisScale scale = AxisScale::linear;
  double min = 0, max = 1;  ///< values at the ends, min < max
  double from = 0, to = 1;  ///< pixels there
  /// NaN where the value has no place; unbounded outside the range.
  double place(double value) const;
  double value(double pixel) const;
};

struct PlacedAxis {
  AxisMap map;
  TickSet ticks;
};

enum class TextRole { title, normal, muted, on_light, on_dark };  ///< the last two: on a cell of that lightness

/// A text and the rectangle that it fills.
struct PlacedText {
  Point2 at = {};  ///< baseline, as Painter::text takes it
  std::string text = {};
  float size = 0;
  TextRole role = TextRole::normal;
  TextAlign align = TextAlign::left;
  FontWeight weight = FontWeight::regular;
  int quarter_turns = 0;
  Box box = {};
};

/// A series in pixels: clipped to the plot and thinned to what can be seen.
struct PlacedSeries {
  std::vector<std::vector<Point2>> lines;
  std::vector<Point2> marks;  ///< of points; of a line only those without a neighbour
};

struct PlacedTriangle {
  Point2 corners[3];  ///< the right angle in the middle
};

struct LegendEntry {
  enum class Kind { series, band, key, pareto, more } kind = Kind::series;
  std::size_t index = 0;
  Box swatch = {};
  PlacedText text = {};
};

struct PlacedLegend {
  Box box;
  bool covers_plot = false;
  std::vector<LegendEntry> entries;  ///< none: no legend
};

struct ChartLayout {
  Box outer, plot;
  PlacedAxis x, y;
  std::optional<PlacedAxis> right, color;
  Box color_bar;
  std::vector<PlacedSeries> series;  ///< one a series of the chart
  std::vector<PlacedTriangle> triangles;
  std::vector<PlacedText> texts;  ///< all but the legend's
  PlacedLegend legend;

  const AxisMap& vertical(const Chart& chart, std::size_t series_index) const;
  /// The pixel of a data point; NaN where it has no place.
  Point2 place(const Chart& chart, PointId point) const;
};

/// The painter is only asked for text widths.
ChartLayout lay_out(const Chart& chart, const ChartTheme& theme, Point2 min, Point2 max, const Painter& painter);

/// The data point nearest to a pixel.
struct ChartHit {
  PointId point;
  double x = 0, y = 0;  ///< its values
  Point2 at;            ///< its pixel
  float distance = 0;   ///< [pixels]
};
/// Nothing within `radius` pixels, or `at` outside the plot: nullopt.
std::optional<ChartHit> hit_test(const Chart& chart, const ChartLayout& layout, Point2 at, float radius = 12);

/// The topmost cell under a pixel of the plot.
std::optional<std::size_t> cell_at(const Chart& chart, const ChartLayout& layout, Point2 at);

/// Scale the view by `factor` (< 1 zooms in) about the pixel `at`, on the axes asked for; spans stay representable.
void zoom(Chart& chart, const ChartLayout& layout, Point2 at, double factor, bool along_x = true, bool along_y = true);
/// Move the view with the mouse by pixels.
void pan(Chart& chart, const ChartLayout& layout, Point2 by);
/// Back to the data's own range.
void reset_view(Chart& chart);

}  // namespace pf
