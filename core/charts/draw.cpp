#include "core/charts/draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/charts/placing.hpp"

namespace pf {
namespace {

Color with_alpha(Color color, float alpha) {
  return {color.r, color.g, color.b, color.a * alpha};
}
/// Thin lines along pixel centres stay sharp.
float crisp(double pixel) {
  return static_cast<float>(std::floor(pixel)) + 0.5f;
}

Color series_color(const Chart& chart, const ChartTheme& theme, std::size_t index) {
  const Series& series = chart.series[index];
  if (series.ink) return theme.text;
  if (series.color) return *series.color;
  if (series.color_index) return theme.series[*series.color_index % theme.series.size()];
  if (series.pinned) return theme.pinned;
  const auto before = std::count_if(chart.series.begin(), chart.series.begin() + static_cast<std::ptrdiff_t>(index),
                                    [](const Series& s) { return !s.pinned && !s.ink && !s.color && !s.color_index; });
  return theme.series[static_cast<std::size_t>(before) % theme.series.size()];
}

Color text_color(const ChartTheme& theme, TextRole role) {
  if (role == TextRole::muted) return theme.muted;
  if (role == TextRole::on_light) return {0.08f, 0.09f, 0.1f};
  if (role == TextRole::on_dark) return {1, 1, 1};
  return theme.text;
}

class Drawing {
 public:
  Drawing(const Chart& chart, const ChartTheme& theme, const ChartLayout& layout, Painter& painter)
      : chart_(chart), theme_(theme), layout_(layout), painter_(painter), plot_(layout.plot), em_(theme.font_size) {}

  void all() {
    if (theme_.surface.a > 0) painter_.rectangle(layout_.outer.min, layout_.outer.max, theme_.surface);
    painter_.push_clip(plot_.min, plot_.max);
    grid();
    for (const Cell& c : chart_.cells) cell(c);
    for (std::size_t k = 0; k < chart_.bands.size(); ++k) band(k);
    for (const ReferenceLine& line : chart_.references) reference(line);
    painter_.pop_clip();
    axes();
    painter_.push_clip({plot_.min.x - 5, plot_.min.y - 5}, {plot_.max.x + 5, plot_.max.y + 5});
    for (const bool pinned : {true, false}) {
      for (std::size_t k = 0; k < chart_.series.size(); ++k) {
        if (chart_.series[k].pinned == pinned) series(k);
      }
    }
    if (chart_.mark_pareto) pareto();
    painter_.pop_clip();
    for (const PlacedTriangle& triangle : layout_.triangles) {
      const Point2 outline[] = {triangle.corners[0], triangle.corners[1], triangle.corners[2], triangle.corners[0]};
      painter_.polygon(triangle.corners, with_alpha(theme_.muted, 0.12f));
      painter_.polyline(outline, theme_.muted, 1);
    }
    if (layout_.color) color_bar();
    for (const PlacedText& t : layout_.texts) text(t);
    legend();
  }

 private:
  void line(Point2 a, Point2 b, Color color, float width = 1, float dash = 0) {
    const Point2 points[] = {a, b};
    painter_.polyline(points, color, width, dash);
  }
  void horizontal(double y, Color color) { line({plot_.min.x, crisp(y)}, {plot_.max.x, crisp(y)}, color); }
  void vertical(double x, Color color) { line({crisp(x), plot_.min.y}, {crisp(x), plot_.max.y}, color); }
  void text(const PlacedText& t) {
    painter_.text(t.at, t.text, t.size, text_color(theme_, t.role), t.align, t.weight, t.quarter_turns);
  }

  void grid() {
    const auto lines = [&](const std::vector<Tick>& ticks, const AxisMap& map, Color color, bool upright) {
      for (const Tick& tick : ticks)
        upright ? vertical(map.place(tick.value), color) : horizontal(map.place(tick.value), color);
    };
    const bool named = !chart_.x.ticks.empty();
    lines(layout_.x.ticks.minor, layout_.x.map, theme_.minor_grid, true);
    lines(layout_.y.ticks.minor, layout_.y.map, theme_.minor_grid, false);
    if (!named) lines(layout_.x.ticks.major, layout_.x.map, theme_.grid, true);
    lines(layout_.y.ticks.major, layout_.y.map, theme_.grid, false);
  }

  void axes() {
    const float length = 0.3f * em_, bottom = crisp(plot_.max.y), left = crisp(plot_.min.x) - 1;
    line({left, bottom}, {plot_.max.x, bottom}, theme_.axis);
    line({left, plot_.min.y}, {left, bottom}, theme_.axis);
    for (const Tick& tick : layout_.x.ticks.major) {
      const float x = crisp(layout_.x.map.place(tick.value));
      line({x, bottom}, {x, bottom + length}, theme_.axis);
    }
    for (const Tick& tick : layout_.y.ticks.major) {
      const float y = crisp(layout_.y.map.place(tick.value));
      line({left - length, y}, {left, y}, theme_.axis);
    }
    if (!layout_.right) return;
    const float right = crisp(plot_.max.x);
    line({right, plot_.min.y}, {right, bottom}, theme_.axis);
    for (const Tick& tick : layout_.right->ticks.major) {
      const float y = crisp(layout_.right->map.place(tick.value));
      line({right, y}, {right + length, y}, theme_.axis);
    }
  }

  void hatch(const Box& box, Hatch kind, Color fill) {
    if (kind == Hatch::none || box.width() <= 0 || box.height() <= 0) return;
    const Color ink = lightness(fill) > 55 ? Color{0, 0, 0, 0.42f} : Color{1, 1, 1, 0.55f};
    painter_.push_clip(box.min, box.max);
    constexpr float spacing = 7;
    if (kind == Hatch::dotted) {
      for (float y = std::floor(box.min.y / spacing) * spacing; y < box.max.y + spacing; y += spacing) {
        for (float x = std::floor(box.min.x / spacing) * spacing; x < box.max.x + spacing; x += spacing) {
          painter_.circle({x, y}, 1.1f, ink);
        }
      }
    }
    for (float y = std::ceil(box.min.y / spacing) * spacing; kind == Hatch::horizontal && y < box.max.y; y += spacing) {
      line({box.min.x, crisp(y)}, {box.max.x, crisp(y)}, ink);
    }
    const auto stripes = [&](bool rising) {
      // Lines x + y = const (rising) or x - y = const, at multiples of the spacing so that neighbours join.
      const float step = spacing * 1.41421356f, h = box.height();
      const float first = rising ? box.min.x + box.min.y : box.min.x - box.max.y;
      const float last = rising ? box.max.x + box.max.y : box.max.x - box.min.y;
      for (float c = std::ceil(first / step) * step; c <= last; c += step) {
        const float x = rising ? c - box.max.y : c + box.min.y;
        line({x, rising ? box.max.y : box.min.y}, {x + h, rising ? box.min.y : box.max.y}, ink);
      }
    };
    if (kind == Hatch::rising || kind == Hatch::crossed) stripes(true);
    if (kind == Hatch::falling || kind == Hatch::crossed) stripes(false);
    painter_.pop_clip();
  }

  void cell(const Cell& c) {
    // Edges on whole pixels: neighbours neither overlap nor leave a seam.
    const auto edge = [](double pixel) { return static_cast<float>(std::round(std::clamp(pixel, -1e6, 1e6))); };
    const AxisMap &x = layout_.x.map, &y = layout_.y.map;
    const Box box{{edge(x.place(c.x_min)), edge(y.place(c.y_max))}, {edge(x.place(c.x_max)), edge(y.place(c.y_min))}};
    const Box shown{{std::max(box.min.x, plot_.min.x), std::max(box.min.y, plot_.min.y)},
                    {std::min(box.max.x, plot_.max.x), std::min(box.max.y, plot_.max.y)}};
    if (!(shown.width() > 0 && shown.height() > 0)) return;
    painter_.rectangle(shown.min, shown.max, c.fill);
    hatch(shown, c.hatch, c.fill);
  }

  Color band_color(std::size_t index) const {
    return chart_.bands[index].color.value_or(with_alpha(theme_.series[index % theme_.series.size()], 0.18f));
  }

  void band(std::size_t index) {
    const Band& b = chart_.bands[index];
    const std::size_t count = std::min({b.x.size(), b.low.size(), b.high.size()});
    const auto pixel = [&](std::size_t k, double value) {
      const double y = layout_.y.map.place(value);
      return Point2{static_cast<float>(layout_.x.map.place(b.x[k])),
                    static_cast<float>(std::isnan(y) ? plot_.max.y
                                                     : std::clamp<double>(y, plot_.min.y - 1e4, plot_.max.y + 1e4))};
    };
    std::vector<Point2> outline;
    for (std::size_t k = 0; k < count; ++k) outline.push_back(pixel(k, b.high[k]));
    for (std::size_t k = count; k-- > 0;) outline.push_back(pixel(k, b.low[k]));
    std::erase_if(outline, [](Point2 p) { return !std::isfinite(p.x); });
    if (outline.size() > 2) painter_.polygon(outline, band_color(index));
  }

  void reference(const ReferenceLine& r) {
    const AxisMap& map =
        r.vertical ? layout_.x.map : (r.right_axis && layout_.right ? layout_.right->map : layout_.y.map);
    const double at = map.place(r.at);
    if (!std::isfinite(at) || std::abs(at) > 1e6) return;
    if (r.vertical) {
      line({crisp(at), plot_.max.y}, {crisp(at), plot_.min.y}, theme_.muted, 1, 4);
    } else {
      line({plot_.min.x, crisp(at)}, {plot_.max.x, crisp(at)}, theme_.muted, 1, 4);
    }
  }

  void mark(Point2 at, MarkShape shape, Color color, float r) {
    switch (shape) {
      case MarkShape::circle:
        return painter_.circle(at, r, color);
      case MarkShape::square:
        return painter_.rectangle({at.x - 0.9f * r, at.y - 0.9f * r}, {at.x + 0.9f * r, at.y + 0.9f * r}, color);
      case MarkShape::triangle: {
        const Point2 p[] = {
            {at.x, at.y - 1.25f * r}, {at.x + 1.1f * r, at.y + 0.75f * r}, {at.x - 1.1f * r, at.y + 0.75f * r}};
        return painter_.polygon(p, color);
      }
      case MarkShape::diamond: {
        const Point2 p[] = {
            {at.x, at.y - 1.3f * r}, {at.x + 1.3f * r, at.y}, {at.x, at.y + 1.3f * r}, {at.x - 1.3f * r, at.y}};
        return painter_.polygon(p, color);
      }
      case MarkShape::cross: {
        const float a = 0.9f * r;
        line({at.x - a, at.y - a}, {at.x + a, at.y + a}, color, theme_.line_width);
        return line({at.x - a, at.y + a}, {at.x + a, at.y - a}, color, theme_.line_width);
      }
    }
  }
  float mark_radius(const Series& s) const { return (s.pinned ? 1.3f : 1.75f) * theme_.line_width + 0.1f * em_; }

  void error_bars(std::size_t index, Color color) {
    const Series& s = chart_.series[index];
    const AxisMap &x = layout_.x.map, &y = layout_.vertical(chart_, index);
    const auto bar = [&](double x0, double y0, double x1, double y1) {
      const auto bounded = [](double v, float low, float high) {
        return static_cast<float>(std::clamp<double>(v, low - 9, high + 9));
      };
      if (std::isnan(x0 + y0 + x1 + y1)) return;
      const Point2 a{bounded(x0, plot_.min.x, plot_.max.x), bounded(y0, plot_.min.y, plot_.max.y)};
      const Point2 b{bounded(x1, plot_.min.x, plot_.max.x), bounded(y1, plot_.min.y, plot_.max.y)};
      const float cap = 0.22f * em_;
      const Point2 across = x0 == x1 ? Point2{cap, 0} : Point2{0, cap};
      line(a, b, color, 1.2f);
      for (const Point2 end : {a, b})
        line({end.x - across.x, end.y - across.y}, {end.x + across.x, end.y + across.y}, color, 1.2f);
    };
    for (std::size_t k = 0; k < std::min(s.x.size(), s.y.size()); ++k) {
      const double px = x.place(s.x[k]), py = y.place(s.y[k]);
      if (k < s.y_low.size() && k < s.y_high.size()) bar(px, y.place(s.y_low[k]), px, y.place(s.y_high[k]));
      if (k < s.x_low.size() && k < s.x_high.size()) bar(x.place(s.x_low[k]), py, x.place(s.x_high[k]), py);
    }
  }

  void series(std::size_t index) {
    const Series& s = chart_.series[index];
    const Color color = series_color(chart_, theme_, index);
    error_bars(index, with_alpha(color, 0.75f));
    const float width = s.pinned ? 0.8f * theme_.line_width : theme_.line_width;
    if (s.outlined)
      for (const auto& piece : layout_.series[index].lines)
        painter_.polyline(piece, with_alpha(theme_.panel, 0.9f), width + 3);
    for (const auto& piece : layout_.series[index].lines) painter_.polyline(piece, color, width, s.dashed ? 6 : 0);
    const float radius = s.style == SeriesStyle::line ? 0.5f * width : mark_radius(s);
    for (const Point2 at : layout_.series[index].marks)
      mark(at, s.style == SeriesStyle::line ? MarkShape::circle : s.mark, color, radius);
  }

  void pareto() {
    const std::vector<PointId> front = pareto_front(chart_);
    std::vector<Point2> steps;
    double lowest = std::numeric_limits<double>::infinity();
    for (const PointId id : front) {
      // Ties are ringed too; the line goes along the best of them.
      const double value = chart_.series[id.series].y[id.index];
      if (!(value < lowest)) continue;
      lowest = value;
      // Beyond the plot only the direction counts.
      Point2 p = layout_.place(chart_, id);
      p = {std::clamp(p.x, plot_.min.x - 99, plot_.max.x + 99), std::clamp(p.y, plot_.min.y - 99, plot_.max.y + 99)};
      if (!steps.empty()) steps.push_back({p.x, steps.back().y});
      steps.push_back(p);
    }
    if (steps.size() > 1) painter_.polyline(steps, theme_.text, 1, 3);
    for (const PointId id : front) {
      const Point2 p = layout_.place(chart_, id);
      if (plot_.grown(0.5f).contains(p)) {
        painter_.ring(p, mark_radius(chart_.series[id.series]) + 2.6f, theme_.text, 1.2f);
      }
    }
  }

  void color_bar() {
    const Box& bar = layout_.color_bar;
    const int rows = std::max(1, static_cast<int>(bar.height()));
    const float height = bar.height() / static_cast<float>(rows);
    for (int k = 0; k < rows; ++k) {
      const float top = bar.min.y + static_cast<float>(k) * height;
      const double t = 1 - (k + 0.5) / rows;
      painter_.rectangle({bar.min.x, top}, {bar.max.x, std::min(bar.max.y, top + height + 0.5f)},
                         sample(chart_.color_bar->map, t));
    }
    for (const Tick& tick : layout_.color->ticks.major) {
      const float y = crisp(layout_.color->map.place(tick.value));
      line({bar.max.x, y}, {bar.max.x + 0.3f * em_, y}, theme_.axis);
    }
  }

  void legend() {
    const PlacedLegend& placed = layout_.legend;
    if (placed.entries.empty()) return;
    if (placed.covers_plot) painter_.rectangle(placed.box.min, placed.box.max, theme_.panel, 0.25f * em_);
    for (const LegendEntry& entry : placed.entries) {
      swatch(entry);
      text(entry.text);
    }
  }

  void swatch(const LegendEntry& entry) {
    const Box& box = entry.swatch;
    const Point2 middle = box.centre(), left{box.min.x, middle.y}, right{box.max.x, middle.y};
    const Box patch{{std::round(box.min.x + 0.2f * em_), std::round(box.min.y)},
                    {std::round(box.max.x - 0.2f * em_), std::round(box.max.y)}};
    switch (entry.kind) {
      case LegendEntry::Kind::series: {
        const Series& s = chart_.series[entry.index];
        const Color color = series_color(chart_, theme_, entry.index);
        if (s.style != SeriesStyle::points)
          line(left, right, color, s.pinned ? 0.8f * theme_.line_width : theme_.line_width, s.dashed ? 6 : 0);
        if (s.style != SeriesStyle::line) mark(middle, s.mark, color, mark_radius(s));
        return;
      }
      case LegendEntry::Kind::band:
        return painter_.rectangle(patch.min, patch.max, band_color(entry.index), 2);
      case LegendEntry::Kind::key:
        painter_.rectangle(patch.min, patch.max, chart_.keys[entry.index].fill);
        return hatch(patch, chart_.keys[entry.index].hatch, chart_.keys[entry.index].fill);
      case LegendEntry::Kind::pareto:
        line(left, right, theme_.text, 1, 3);
        return painter_.ring(middle, 0.32f * em_, theme_.text, 1.2f);
      case LegendEntry::Kind::more:
        return;
    }
  }

  const Chart& chart_;
  const ChartTheme& theme_;
  const ChartLayout& layout_;
  Painter& painter_;
  const Box& plot_;
  float em_;
};

}  // namespace

void draw(const Chart& chart, const ChartTheme& theme, const ChartLayout& layout, Painter& painter) {
  Drawing(chart, theme, layout, painter).all();
}

ChartLayout draw(const Chart& chart, const ChartTheme& theme, Point2 min, Point2 max, Painter& painter) {
  ChartLayout layout = lay_out(chart, theme, min, max, painter);
  draw(chart, theme, layout, painter);
  return layout;
}

void draw_hover(const Chart& chart, const ChartTheme& theme, const ChartLayout& layout, const ChartHit& hit,
                Painter& painter) {
  const Series& series = chart.series[hit.point.series];
  const Axis& y_axis = chart.right && series.right_axis ? *chart.right : chart.y;
  const auto value = [](const Axis& axis, double v, const char* otherwise) {
    std::string text = axis.title.empty() ? otherwise : axis.title;
    text += "  " + number_text(v, 5);
    return axis.unit.empty() ? text : text + " " + axis.unit;
  };
  struct Line {
    std::string text;
    FontWeight weight = FontWeight::regular;
  };
  std::vector<Line> lines;
  if (!series.label.empty()) lines.push_back({series.label, FontWeight::bold});
  lines.push_back({value(chart.x, hit.x, "x")});
  lines.push_back({value(y_axis, hit.y, "y")});
  const float em = theme.font_size, row = 1.4f * em, pad = 0.6f * em;
  float width = 0;
  for (Line& line : lines) {
    line.text = placing::shortened(line.text, layout.outer.width() - 2 * pad, em, line.weight, painter);
    width = std::max(width, painter.text_width(line.text, em, line.weight));
  }
  const Point2 size{width + 2 * pad, row * static_cast<float>(lines.size()) + pad};
  Point2 at{hit.at.x + em, hit.at.y - em - size.y};
  if (at.x + size.x > layout.outer.max.x) at.x = hit.at.x - em - size.x;
  if (at.y < layout.outer.min.y) at.y = hit.at.y + em;
  at.x = std::clamp(at.x, layout.outer.min.x, std::max(layout.outer.min.x, layout.outer.max.x - size.x));
  at.y = std::clamp(at.y, layout.outer.min.y, std::max(layout.outer.min.y, layout.outer.max.y - size.y));

  painter.circle(hit.at, 3.2f, series_color(chart, theme, hit.point.series));
  painter.ring(hit.at, 5.5f, theme.text, 1.3f);
  painter.rectangle({at.x - 1, at.y - 1}, {at.x + size.x + 1, at.y + size.y + 1}, theme.axis, 0.3f * em + 1);
  Color panel = theme.panel;
  panel.a = 1;
  painter.rectangle(at, {at.x + size.x, at.y + size.y}, panel, 0.3f * em);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    painter.text({at.x + pad, at.y + 0.5f * pad + row * static_cast<float>(k) + 1.02f * em}, lines[k].text, em,
                 theme.text, TextAlign::left, lines[k].weight);
  }
}

}  // namespace pf
