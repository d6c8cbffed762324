// Steps of lay_out, apart so that each can be read alone. Not for use outside core/charts.
#pragma once

#include <span>

#include "core/charts/layout.hpp"

namespace pf::placing {

/// The values that an axis shows: the data's, its margins and the axis' wishes.
struct Range {
  double min = 0, max = 1;
};
enum class Side { bottom, left, right };
Range axis_range(const Chart& chart, Side side);

/// The text, cut with an ellipsis to at most `width` pixels; "" when not even that fits.
std::string shortened(const std::string& text, float width, float size, FontWeight weight, const Painter& painter);
/// Fills in the box. Superscripts reach 0.86 em above the baseline, descenders 0.24 em below.
PlacedText placed_text(PlacedText text, const Painter& painter);

/// Pixels of a series within the plot.
PlacedSeries place_series(const Chart& chart, const ChartLayout& layout, std::size_t index);
/// Points every few pixels along all that is drawn in the plot: what a legend should not cover.
std::vector<Point2> occupied(const ChartLayout& layout);

/// Reference lines' notes and slope triangles; needs plot, maps and series.
void place_annotations(const Chart& chart, const ChartTheme& theme, const Painter& painter, ChartLayout& layout);

/// Entries without places; and the size of them in so many columns.
std::vector<LegendEntry> legend_entries(const Chart& chart, const ChartTheme& theme, float widest,
                                        const Painter& painter);
Point2 legend_size(std::span<const LegendEntry> entries, int columns, const ChartTheme& theme);
float legend_padding(const ChartTheme& theme);
/// Rows that fit a height, at least 1.
int legend_rows(float height, const ChartTheme& theme);
/// Leaves at most so many entries; the last then says how many are missing.
void cap_legend(std::vector<LegendEntry>& entries, int most);
/// Columns that fit a width.
int legend_columns(std::span<const LegendEntry> entries, float width, const ChartTheme& theme);
/// Gives the entries their places.
void place_legend(std::vector<LegendEntry> entries, Point2 at, int columns, const ChartTheme& theme,
                  PlacedLegend& legend);
/// The corner of the plot where a legend covers least; `covered` becomes the share of what is drawn that it hides.
Point2 best_corner(const ChartLayout& layout, Point2 size, const ChartTheme& theme, double& covered);

}  // namespace pf::placing
