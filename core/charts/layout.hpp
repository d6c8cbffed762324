// Where everything of a chart goes: pure geometry, from data, theme and text widths.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/charts/chart.hpp"
#include "core/charts/theme.hpp"
#include "core/charts/ticks.hpp"

namespace pf {

struct Box {
  Point2 min, max;
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
  bool contains(Point2 p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
};

/// Values <-> pixels along one axis.
struct AxisMap {
  AxisScale scale = AxisScale::linear;
  double min = 0, max = 1;           ///< values at the ends
  float from = 0, to = 1;            ///< pixels at the ends
  double place(double value) const;  ///< NaN where the value has no place; unbounded outside the range
  double value(double pixel) const;
};

struct PlacedAxis {
  AxisMap map;
  TickSet ticks;
  std::string title;  ///< with unit and prefix, shortened to fit
};

struct PlacedLegend {
  Box box{};
  int columns = 1;
  float column_width = 0;
  bool covers_plot = false;
  struct Entry {
    std::string label;  ///< shortened to fit
    enum class Kind { series, band, key, pareto } kind = Kind::series;
    std::size_t index = 0;
  };
  std::vector<Entry> entries;  ///< none: no legend
};

struct ChartLayout {
  Box outer{}, plot{};
  PlacedAxis x, y;
  std::optional<PlacedAxis> right;
  std::string title, subtitle;  ///< shortened to fit
  float title_baseline = 0, subtitle_baseline = 0, x_title_baseline = 0;
  float y_title_x = 0, right_title_x = 0;  ///< baselines of the turned titles
  PlacedLegend legend;
  std::optional<Box> color_bar;
  std::optional<PlacedAxis> color_axis;

  Point2 place(const Chart& chart, PointId point) const;
};

/// The painter is only asked for text widths.
ChartLayout lay_out(const Chart& chart, const ChartTheme& theme, Point2 min, Point2 max, const Painter& painter);

/// The data point nearest to a pixel.
struct ChartHit {
  PointId point;
  double x = 0, y = 0;  ///< its values
  Point2 at{};          ///< its pixel
  float distance = 0;   ///< [pixels]
};
/// Nothing within `radius` pixels, or `at` outside the plot: nullopt.
std::optional<ChartHit> hit_test(const Chart& chart, const ChartLayout& layout, Point2 at, float radius = 12);

/// Scale the view by `factor` (< 1 zooms in) about the pixel `at`, on the axes asked for; limits keep numbers sane.
void zoom(Chart& chart, const ChartLayout& layout, Point2 at, double factor, bool along_x = true, bool along_y = true);
/// Move the view with the mouse by pixels.
void pan(Chart& chart, const ChartLayout& layout, Point2 by);
/// Back to the data's own range.
void reset_view(Chart& chart);

}  // namespace pf
