// A chart as a file: PNG, SVG, CSV.
#include <cmath>

#include "core/charts/draw.hpp"
#include "core/charts/png_painter.hpp"
#include "core/charts/svg_painter.hpp"
#include "core/files.hpp"

namespace pf {

void write_chart_png(const Chart& chart, const ChartTheme& theme, int width, int height,
                     const std::filesystem::path& file, float scale, const ImageText& text) {
  const auto pixels = [&](int length) { return static_cast<int>(std::lround(scale * static_cast<float>(length))); };
  Image image(pixels(width), pixels(height), theme.surface);
  PngPainter painter(image, scale);
  draw(chart, theme, {0, 0}, {static_cast<float>(width), static_cast<float>(height)}, painter);
  write_png(image, file, text);
}

void write_chart_svg(const Chart& chart, const ChartTheme& theme, int width, int height,
                     const std::filesystem::path& file, const ImageText& text) {
  const Point2 size{static_cast<float>(width), static_cast<float>(height)};
  SvgPainter painter(size.x, size.y);
  draw(chart, theme, {0, 0}, size, painter);
  write_atomically(file, painter.document(chart.title, text));
}

void write_chart_csv(const Chart& chart, const std::filesystem::path& file) {
  write_atomically(file, chart_csv(chart));
}

}  // namespace pf
