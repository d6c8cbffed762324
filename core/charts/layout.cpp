#include "core/charts/layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/charts/placing.hpp"

namespace pf {
namespace {

using namespace placing;

/// One arrangement, with the legend at a given place. All lengths follow from the font's size.
class Arranger {
 public:
  Arranger(const Chart& chart, const ChartTheme& theme, Box outer, const Painter& painter)
      : chart_(chart), theme_(theme), painter_(painter), em_(theme.font_size) {
    layout_.outer = outer;
    free_ = outer.grown(-0.75f * em_);
  }

  ChartLayout arrange(LegendPlace place) {
    take_titles();
    reserve_legend(place);
    reserve_axes();
    set_horizontal();
    place_axis_texts();
    for (std::size_t k = 0; k < chart_.series.size(); ++k) layout_.series.push_back(place_series(chart_, layout_, k));
    place_cell_texts();
    place_annotations(chart_, theme_, painter_, layout_);
    return std::move(layout_);
  }

 private:
  bool small_height() const { return layout_.outer.height() < 11 * em_; }
  bool small_width() const { return layout_.outer.width() < 16 * em_; }

  void add_text(PlacedText text) {
    if (!text.text.empty()) layout_.texts.push_back(placed_text(std::move(text), painter_));
  }

  void take_titles() {
    const auto line = [&](const std::string& text, float size, TextRole role, FontWeight weight) {
      if (text.empty() || small_height()) return;
      free_.min.y += 1.3f * size;
      const std::string cut = shortened(text, free_.width(), size, weight, painter_);
      add_text(
          {.at = {free_.min.x, free_.min.y - 0.35f * size}, .text = cut, .size = size, .role = role, .weight = weight});
    };
    line(chart_.title, 1.25f * em_, TextRole::title, FontWeight::bold);
    line(chart_.subtitle, em_, TextRole::muted, FontWeight::regular);
    if (!layout_.texts.empty()) free_.min.y += 0.35f * em_;
  }

  void reserve_legend(LegendPlace place) {
    const bool right = place == LegendPlace::outside_right, above = place == LegendPlace::above;
    if (!right && !above && place != LegendPlace::below) return;
    std::vector<LegendEntry> entries = legend_entries(chart_, theme_, (right ? 0.4f : 1.0f) * free_.width(), painter_);
    const int columns = right ? 1 : legend_columns(entries, free_.width(), theme_);
    cap_legend(entries, columns * legend_rows((right ? 1.0f : 0.4f) * free_.height(), theme_));
    if (entries.empty()) return;
    const Point2 size = legend_size(entries, columns, theme_);
    // Swatches begin where the titles do.
    Point2 at{free_.min.x - legend_padding(theme_), free_.min.y};
    if (right) at.x = free_.max.x -= size.x;
    if (above) free_.min.y += size.y;
    if (place == LegendPlace::below) at.y = free_.max.y -= size.y;
    place_legend(std::move(entries), at, columns, theme_, layout_.legend);
  }

  /// Vertical extents first: they fix the vertical axes' labels, whose widths fix the horizontal extents.
  void reserve_axes() {
    Box& plot = layout_.plot;
    plot.min.y = std::ceil(free_.min.y + 0.5f * em_);
    plot.max.y = std::floor(free_.max.y - (has_title(chart_.x) ? 1.75f * em_ : 0) - 1.55f * em_);
    plot.max.y = std::max(plot.max.y, plot.min.y + 1);
    layout_.y = vertical_axis(chart_.y, axis_range(chart_, Side::left));
    plot.min.x = free_.min.x + axis_width(chart_.y, layout_.y);
    plot.max.x = free_.max.x;
    if (chart_.color_bar) {
      const Axis& axis = chart_.color_bar->axis;
      layout_.color = vertical_axis(axis, {axis.min.value_or(0), axis.max.value_or(1)});
      plot.max.x -= axis_width(axis, *layout_.color) + bar_width();
    }
    if (chart_.right) {
      layout_.right = vertical_axis(*chart_.right, axis_range(chart_, Side::right));
      plot.max.x -= axis_width(*chart_.right, *layout_.right);
    }
    // Whole pixels, so that frame, grid and cells meet without a seam.
    plot.min.x = std::ceil(plot.min.x);
    plot.max.x = std::max(std::floor(plot.max.x), plot.min.x + 1);
  }

  bool has_title(const Axis& axis) const {
    return (!axis.title.empty() || !axis.unit.empty()) && !(&axis == &chart_.x ? small_height() : small_width());
  }
  float bar_width() const { return 2.2f * em_; }

  float axis_width(const Axis& axis, const PlacedAxis& placed) const {
    float widest = 0;
    for (const Tick& tick : placed.ticks.major) widest = std::max(widest, painter_.text_width(tick.label, em_));
    return widest + 0.6f * em_ + (has_title(axis) ? 1.7f * em_ : 0);
  }

  PlacedAxis vertical_axis(const Axis& axis, Range range) const {
    const AxisMap map{axis.scale, range.min, range.max, layout_.plot.max.y, layout_.plot.min.y};
    const auto fit = [&](const std::vector<Tick>& ticks) {
      double before = std::numeric_limits<double>::infinity();
      for (const Tick& tick : ticks) {
        const double at = map.place(tick.value);
        if (before - at < 1.5 * em_) return false;
        before = at;
      }
      return true;
    };
    return {map, ticks_of(axis, map, static_cast<int>(layout_.plot.height() / (2.6f * em_)), fit)};
  }

  TickSet ticks_of(const Axis& axis, const AxisMap& map, int most, const LabelsFit& fit) const {
    if (!axis.ticks.empty()) {
      TickSet set;
      for (const auto& [value, label] : axis.ticks) {
        if (!(value >= map.min && value <= map.max)) continue;
        const float room = &axis == &chart_.x ? free_.width() : 0.35f * free_.width();
        set.major.push_back({value, shortened(label, room, em_, FontWeight::regular, painter_)});
      }
      return set;
    }
    return map.scale == AxisScale::linear ? linear_ticks(map.min, map.max, most, fit)
                                          : logarithmic_ticks(map.min, map.max, most, fit);
  }

  /// The outermost labels may reach beyond the plot; it gives way until they stay inside.
  void set_horizontal() {
    const Range range = axis_range(chart_, Side::bottom);
    const float left_edge = layout_.outer.min.x + 0.2f * em_, right_edge = free_.max.x + 0.4f * em_;
    const bool plain_right = !chart_.right && !chart_.color_bar;
    for (int pass = 0; pass < 3; ++pass) {
      const AxisMap map{chart_.x.scale, range.min, range.max, layout_.plot.min.x, layout_.plot.max.x};
      const auto fit = [&](const std::vector<Tick>& ticks) {
        double before = -std::numeric_limits<double>::infinity();
        for (const Tick& tick : ticks) {
          const double at = map.place(tick.value), half = 0.5 * painter_.text_width(tick.label, em_);
          if (at - half < before + 0.9 * em_) return false;
          before = at + half;
        }
        return true;
      };
      layout_.x = {map, ticks_of(chart_.x, map, static_cast<int>(layout_.plot.width() / (3.2f * em_)), fit)};
      if (!chart_.x.ticks.empty()) shorten_names(layout_.x);
      if (layout_.x.ticks.major.empty() || pass == 2) break;
      const Tick& last = layout_.x.ticks.major.back();
      const double reach = map.place(last.value) + 0.5 * painter_.text_width(last.label, em_) - right_edge;
      if (reach <= 0 || !plain_right) break;
      layout_.plot.max.x = std::max(layout_.plot.min.x + 1, std::floor(layout_.plot.max.x - static_cast<float>(reach)));
    }
    // What still reaches out loses its label.
    for (Tick& tick : layout_.x.ticks.major) {
      const double at = layout_.x.map.place(tick.value), half = 0.5 * painter_.text_width(tick.label, em_);
      const double limit = plain_right ? right_edge : layout_.outer.max.x - 0.2f * em_;
      if (at - half < left_edge - 0.5 || at + half > limit + 0.5) tick.label.clear();
    }
  }

  void shorten_names(PlacedAxis& axis) const {
    auto& ticks = axis.ticks.major;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      double room = layout_.plot.width();
      if (k > 0) room = std::min(room, std::abs(axis.map.place(ticks[k].value) - axis.map.place(ticks[k - 1].value)));
      if (k + 1 < ticks.size())
        room = std::min(room, std::abs(axis.map.place(ticks[k + 1].value) - axis.map.place(ticks[k].value)));
      ticks[k].label =
          shortened(ticks[k].label, static_cast<float>(room) - 0.6f * em_, em_, FontWeight::regular, painter_);
    }
  }

  void place_axis_texts() {
    const Box& plot = layout_.plot;
    for (const Tick& tick : layout_.x.ticks.major) {
      add_text({.at = {static_cast<float>(layout_.x.map.place(tick.value)), plot.max.y + 1.4f * em_},
                .text = tick.label,
                .size = em_,
                .role = TextRole::muted,
                .align = TextAlign::centre});
    }
    if (has_title(chart_.x)) {
      const std::string title = axis_title(chart_.x.title, chart_.x.unit, layout_.x.ticks.exponent);
      add_text({.at = {plot.centre().x, plot.max.y + 3.0f * em_},
                .text = shortened(title,
                                  std::min(2 * std::min(plot.centre().x - layout_.outer.min.x,
                                                        layout_.outer.max.x - plot.centre().x) -
                                               em_,
                                           free_.width()),
                                  em_, FontWeight::regular, painter_),
                .size = em_,
                .align = TextAlign::centre});
    }
    place_vertical(chart_.y, layout_.y, plot.min.x, -1);
    float edge = plot.max.x;
    if (layout_.right) {
      place_vertical(*chart_.right, *layout_.right, edge, 1);
      edge += axis_width(*chart_.right, *layout_.right);
    }
    if (layout_.color) {
      layout_.color_bar = {{edge + 1.1f * em_, plot.min.y}, {edge + bar_width(), plot.max.y}};
      place_vertical(chart_.color_bar->axis, *layout_.color, layout_.color_bar.max.x, 1);
      edge = layout_.color_bar.max.x + axis_width(chart_.color_bar->axis, *layout_.color);
    }
  }

  /// Labels and title of a vertical axis at `x`; direction -1: to its left.
  void place_vertical(const Axis& axis, const PlacedAxis& placed, float x, float direction) {
    for (const Tick& tick : placed.ticks.major) {
      add_text({.at = {x + direction * 0.6f * em_, static_cast<float>(placed.map.place(tick.value)) + 0.36f * em_},
                .text = tick.label,
                .size = em_,
                .role = TextRole::muted,
                .align = direction < 0 ? TextAlign::right : TextAlign::left});
    }
    if (!has_title(axis)) return;
    const std::string title = axis_title(axis.title, axis.unit, placed.ticks.exponent);
    const std::string cut = shortened(title, free_.height(), em_, FontWeight::regular, painter_);
    const float width = axis_width(axis, placed), half = 0.5f * painter_.text_width(cut, em_);
    const float y =
        std::clamp(layout_.plot.centre().y, free_.min.y + half, std::max(free_.min.y + half, free_.max.y - half));
    add_text({.at = {direction < 0 ? x - width + 0.85f * em_ : x + width - 0.3f * em_, y},
              .text = cut,
              .size = em_,
              .align = TextAlign::centre,
              .quarter_turns = 1});
  }

  void place_cell_texts() {
    for (const Cell& cell : chart_.cells) {
      if (cell.text.empty()) continue;
      const double x0 = layout_.x.map.place(cell.x_min), x1 = layout_.x.map.place(cell.x_max);
      const double y0 = layout_.y.map.place(cell.y_max), y1 = layout_.y.map.place(cell.y_min);
      const PlacedText text =
          placed_text({.at = {static_cast<float>(0.5 * (x0 + x1)), static_cast<float>(0.5 * (y0 + y1)) + 0.34f * em_},
                       .text = cell.text,
                       .size = 0.92f * em_,
                       .role = lightness(cell.fill) > 60 ? TextRole::on_light : TextRole::on_dark,
                       .align = TextAlign::centre},
                      painter_);
      const bool fits = text.box.width() + 0.4 * em_ <= x1 - x0 && text.box.height() <= y1 - y0;
      if (fits && layout_.plot.contains(text.box.min) && layout_.plot.contains(text.box.max))
        layout_.texts.push_back(text);
    }
  }

  const Chart& chart_;
  const ChartTheme& theme_;
  const Painter& painter_;
  float em_;
  Box free_;
  ChartLayout layout_;
};

/// The corner that was asked for, or the best one.
Point2 corner_of(LegendPlace place, const ChartLayout& layout, Point2 size, const ChartTheme& theme, double& covered) {
  const Point2 best = best_corner(layout, size, theme, covered);
  if (place == LegendPlace::automatic) return best;
  const float inset = 0.6f * theme.font_size;
  const bool left = place == LegendPlace::top_left || place == LegendPlace::bottom_left;
  const bool top = place == LegendPlace::top_left || place == LegendPlace::top_right;
  return {left ? layout.plot.min.x + inset : layout.plot.max.x - inset - size.x,
          top ? layout.plot.min.y + inset : layout.plot.max.y - inset - size.y};
}

}  // namespace

const AxisMap& ChartLayout::vertical(const Chart& chart, std::size_t series_index) const {
  return right && chart.series[series_index].right_axis ? right->map : y.map;
}

Point2 ChartLayout::place(const Chart& chart, PointId point) const {
  const Series& values = chart.series[point.series];
  return {static_cast<float>(x.map.place(values.x[point.index])),
          static_cast<float>(vertical(chart, point.series).place(values.y[point.index]))};
}

ChartLayout lay_out(const Chart& chart, const ChartTheme& theme, Point2 min, Point2 max, const Painter& painter) {
  const auto arrange = [&](LegendPlace place) { return Arranger(chart, theme, {min, max}, painter).arrange(place); };
  const LegendPlace wish = chart.legend;
  const bool outside = wish == LegendPlace::outside_right || wish == LegendPlace::above || wish == LegendPlace::below;
  if (wish == LegendPlace::none || outside) return arrange(wish);

  ChartLayout inside = arrange(LegendPlace::none);
  const float em = theme.font_size;
  std::vector<LegendEntry> entries = legend_entries(chart, theme, 0.62f * inside.plot.width(), painter);
  if (wish != LegendPlace::automatic) cap_legend(entries, legend_rows(inside.plot.height() - em, theme));
  if (entries.empty()) return inside;
  const Point2 size = legend_size(entries, 1, theme);
  double covered = 0;
  const Point2 at = corner_of(wish, inside, size, theme, covered);
  const bool fits = size.x <= 0.65f * inside.plot.width() && size.y <= inside.plot.height() - em;
  if (wish == LegendPlace::automatic && (!fits || covered > 0 || !chart.cells.empty())) {
    const float width = max.x - min.x - 1.5f * em, height = max.y - min.y;
    const auto whole = legend_entries(chart, theme, width, painter);
    const float rows = legend_size(whole, legend_columns(whole, width, theme), theme).y / height;
    const bool wide = width >= 38 * em, cells = !chart.cells.empty();
    const float most_rows = covered > 0.1 ? 0.3f : 0.22f;
    if (!(wide && cells) && height >= 12 * em && rows < most_rows) return arrange(LegendPlace::above);
    if (wide) return arrange(LegendPlace::outside_right);
  }
  if (!fits) return inside;
  inside.legend.covers_plot = true;
  place_legend(std::move(entries), at, 1, theme, inside.legend);
  // A note that a wished-for corner hides is better left out than half seen.
  std::erase_if(inside.texts, [&](const PlacedText& text) { return text.box.overlaps(inside.legend.box); });
  return inside;
}

}  // namespace pf
