// Which entries a legend has, how large it is and where it hides least.
#include <algorithm>

#include "core/charts/placing.hpp"

namespace pf::placing {
namespace {

constexpr float row_height = 1.5f, swatch_width = 1.9f, gap = 0.55f, padding = 0.55f, column_gap = 1.4f;  // [em]

float widest_entry(std::span<const LegendEntry> entries, const ChartTheme& theme) {
  float widest = 0;
  for (const LegendEntry& entry : entries) widest = std::max(widest, entry.text.box.width());
  return widest + (swatch_width + gap) * theme.font_size;
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

int legend_columns(std::span<const LegendEntry> entries, float width, const ChartTheme& theme) {
  const float em = theme.font_size, column = widest_entry(entries, theme) + column_gap * em;
  const int most = static_cast<int>((width - (2 * padding - column_gap) * em) / column);
  return std::clamp(most, 1, std::max(1, static_cast<int>(entries.size())));
}

Point2 legend_size(std::span<const LegendEntry> entries, int columns, const ChartTheme& theme) {
  const float em = theme.font_size, count = static_cast<float>(columns);
  const int rows = (static_cast<int>(entries.size()) + columns - 1) / columns;
  return {count * widest_entry(entries, theme) + (count - 1) * column_gap * em + 2 * padding * em,
          static_cast<float>(rows) * row_height * em + 2 * padding * em * 0.6f};
}

void place_legend(std::vector<LegendEntry> entries, Point2 at, int columns, const ChartTheme& theme,
                  PlacedLegend& legend) {
  const float em = theme.font_size, column = widest_entry(entries, theme) + column_gap * em;
  const Point2 size = legend_size(entries, columns, theme);
  legend.box = {at, {at.x + size.x, at.y + size.y}};
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto row = static_cast<float>(static_cast<int>(k) / columns),
               place = static_cast<float>(static_cast<int>(k) % columns);
    const float x = at.x + padding * em + place * column,
                middle = at.y + (0.6f * padding + (row + 0.5f) * row_height) * em;
    LegendEntry& entry = entries[k];
    entry.swatch = {{x, middle - 0.45f * em}, {x + swatch_width * em, middle + 0.45f * em}};
    const Point2 baseline{entry.swatch.max.x + gap * em, middle + 0.36f * em};
    const Point2 shift{baseline.x - entry.text.at.x, baseline.y - entry.text.at.y};
    entry.text.at = baseline;
    entry.text.box = {{entry.text.box.min.x + shift.x, entry.text.box.min.y + shift.y},
                      {entry.text.box.max.x + shift.x, entry.text.box.max.y + shift.y}};
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
