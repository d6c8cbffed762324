// Paints a chart with any Painter, and writes it to files.
#pragma once

#include <filesystem>
#include <string>

#include "core/charts/image.hpp"
#include "core/charts/layout.hpp"

namespace pf {

/// Draws into the rectangle and returns where everything went, for hit_test, zoom and pan.
ChartLayout draw(const Chart& chart, const ChartTheme& theme, Point2 min, Point2 max, Painter& painter);
/// The same with a layout made before.
void draw(const Chart& chart, const ChartTheme& theme, const ChartLayout& layout, Painter& painter);
/// A ring at the point and a note with its series and values, kept inside the chart.
void draw_hover(const Chart& chart, const ChartTheme& theme, const ChartLayout& layout, const ChartHit& hit,
                Painter& painter);

/// width, height: in the chart's own pixels; the PNG has `scale` times as many. Throw FileError.
void write_chart_png(const Chart& chart, const ChartTheme& theme, int width, int height,
                     const std::filesystem::path& file, float scale = 2, const ImageText& text = {});
void write_chart_svg(const Chart& chart, const ChartTheme& theme, int width, int height,
                     const std::filesystem::path& file, const ImageText& text = {});
void write_chart_csv(const Chart& chart, const std::filesystem::path& file);

}  // namespace pf
