// Which entries a legend has, how large it is and where it hides least.
#include <algorithm>

#include "core/charts/placing.hpp"

namespace pf::placing {
namespace {

constexpr float row_height = 1.5f, swatch_width = 1.9f, gap = 0.55f, padding = 0.55f, column_gap = 1.4f;  // [em]

/// Widths of the columns when entries fill row by row.
std::vector<float> column_widths(std::span<const LegendEntry> entries, int columns, const ChartTheme& theme) {
  std::vector<float> widths(static_cast<std::size_t>(columns), 0.0f);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    float& width = widths[k % widths.size()];
    width = std::max(width, entries[k].text.box.width() + (swatch_width + gap) * theme.font_size);
  }
  return widths;
}

}  // namespace

std::vector<LegendEntry> legend_entries(const Chart& chart, const ChartTheme& theme, float widest,
                                        const Painter& painter) {
  std::vector<LegendEntry> entries;
  const float room = widest - (swatch_width + gap + 2 * padding) * theme.font_size;
  const auto add = [&](const std::string& label, LegendEntry::Kind kind, std::size_t index) {
    if (label.empty()) return;
    const std::string text = shortened(label, room, theme.font_size, FontWeight::regular, painter);
    entries.push_back({kind, index, {}, placed_text({.text = text, .size = theme.font_size}, painter)});
  };
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    const bool right = chart.right && chart.series[k].right_axis && !chart.series[k].label.empty();
    add(chart.series[k].label + (right ? " (right)" : ""), LegendEntry::Kind::series, k);
  }
  for (std::size_t k = 0; k < chart.bands.size(); ++k) add(chart.bands[k].label, LegendEntry::Kind::band, k);
  for (std::size_t k = 0; k < chart.keys.size(); ++k) add(chart.keys[k].label, LegendEntry::Kind::key, k);
  if (chart.mark_pareto && pareto_front(chart).size() > 1) add("Pareto front", LegendEntry::Kind::pareto, 0);
  return entries;
}

float legend_padding(const ChartTheme& theme) {
  return padding * theme.font_size;
}

int legend_rows(float height, const ChartTheme& theme) {
  return std::max(1, static_cast<int>((height / theme.font_size - 1.2f * padding) / row_height));
}

void cap_legend(std::vector<LegendEntry>& entries, int most) {
  const auto room = static_cast<std::size_t>(std::max(most, 1));
  if (entries.size() <= room) return;
  const std::size_t missing = entries.size() - room + 1;
  entries.resize(room);
  entries.back().kind = LegendEntry::Kind::more;
  entries.back().text.text = "+ " + std::to_string(missing);
}

int legend_columns(std::span<const LegendEntry> entries, float width, const ChartTheme& theme) {
  int columns = std::max(1, static_cast<int>(entries.size()));
  while (columns > 1 && legend_size(entries, columns, theme).x > width + 2 * padding * theme.font_size) --columns;
  return columns;
}

Point2 legend_size(std::span<const LegendEntry> entries, int columns, const ChartTheme& theme) {
  const float em = theme.font_size;
  float width = (column_gap * static_cast<float>(columns - 1) + 2 * padding) * em;
  for (const float column : column_widths(entries, columns, theme)) width += column;
  const int rows = (static_cast<int>(entries.size()) + columns - 1) / columns;
  return {width, (static_cast<float>(rows) * row_height + 1.2f * padding) * em};
}

void place_legend(std::vector<LegendEntry> entries, Point2 at, int columns, const ChartTheme& theme,
                  PlacedLegend& legend) {
  const float em = theme.font_size;
  const Point2 size = legend_size(entries, columns, theme);
  legend.box = {at, {at.x + size.x, at.y + size.y}};
  const std::vector<float> widths = column_widths(entries, columns, theme);
  Point2 corner{at.x + padding * em, at.y + 0.6f * padding * em};
  for (std::size_t k = 0; k < entries.size(); ++k) {
    LegendEntry& entry = entries[k];
    const float middle = corner.y + 0.5f * row_height * em;
    entry.swatch = {{corner.x, middle - 0.45f * em}, {corner.x + swatch_width * em, middle + 0.45f * em}};
    const Point2 baseline{entry.swatch.max.x + gap * em, middle + 0.36f * em};
    const Point2 shift{baseline.x - entry.text.at.x, baseline.y - entry.text.at.y};
    entry.text.at = baseline;
    entry.text.box = {{entry.text.box.min.x + shift.x, entry.text.box.min.y + shift.y},
                      {entry.text.box.max.x + shift.x, entry.text.box.max.y + shift.y}};
    const std::size_t column = k % widths.size();
    const bool last = column + 1 == widths.size();
    corner.x = last ? at.x + padding * em : corner.x + widths[column] + column_gap * em;
    if (last) corner.y += row_height * em;
  }
  legend.entries = std::move(entries);
}

Point2 best_corner(const ChartLayout& layout, Point2 size, const ChartTheme& theme, double& covered) {
  const float inset = 0.6f * theme.font_size;
  const float left = layout.plot.min.x + inset, right = layout.plot.max.x - inset - size.x;
  const float top = layout.plot.min.y + inset, bottom = layout.plot.max.y - inset - size.y;
  const std::vector<Point2> points = occupied(layout);
  Point2 best{right, top};
  covered = 2;
  for (const Point2 at : {Point2{right, top}, Point2{left, top}, Point2{right, bottom}, Point2{left, bottom}}) {
    const Box box = Box{at, {at.x + size.x, at.y + size.y}};
    double share = 0;
    for (const Point2 p : points) share += box.grown(3).contains(p);
    share /= std::max<double>(1, static_cast<double>(points.size()));
    for (const PlacedText& text : layout.texts) share += text.box.overlaps(box);
    if (share < covered) {
      covered = share;
      best = at;
    }
  }
  return best;
}

}  // namespace pf::placing
