#include "render/color_bar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/charts/colormap.hpp"
#include "core/charts/ticks.hpp"

namespace pf {

namespace {

constexpr float margin = 12, padding = 12, text_size = 12, title_size = 13, bar_width = 14, tick_gap = 7;
constexpr float histogram_width = 22, lying_histogram = 14, lowest_with_lying_counts = 260;
constexpr float narrowest_beside_axes = 340;
constexpr float lying_height = 10, lying_padding = 9;  // of the bar that lies, and of its panel

struct Box {
  Point2 min, max;
};

/// The legend stands in the upper right corner. Where it lies, it is in the lower one: beside the axes, or above them.
Box place(const OverlayInfo& info, Point2 min, Point2 max, float width, float height) {
  float bottom = min.y + margin + height;
  if (legend_lies(min, max))
    bottom = max.y - margin - ((info.axes || info.scale_bar) && max.x - min.x < narrowest_beside_axes ? 56.f : 0.f);
  return {{max.x - margin - width, bottom - height}, {max.x - margin, bottom}};
}

void draw_categories(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max) {
  constexpr float row = 20;
  // More names than fit end with how many are missing.
  const float height = max.y - min.y;
  const float room = legend_lies(min, max) ? 0.45f * height - 2 * padding - title_size : height - 2 * margin - 100;
  const auto most = static_cast<std::size_t>(std::max(1.f, room / row));
  std::vector<std::string> names = info.material_names;
  if (names.empty()) return;
  const bool cut = names.size() > most;
  if (cut) {
    const std::size_t missing = names.size() - most + 1;
    names.resize(most - 1);
    names.push_back("and " + std::to_string(missing) + " more");
  }
  const std::string title(field_info(info.field).label);
  float width = painter.text_width(title, title_size, FontWeight::bold);
  for (const std::string& name : names) width = std::max(width, 20 + painter.text_width(name, text_size));
  const Box box =
      place(info, min, max, width + 2 * padding, 2 * padding + title_size + row * static_cast<float>(names.size()) + 2);
  painter.rectangle(box.min, box.max, theme.panel, 6);
  const float x = box.min.x + padding;
  float y = box.min.y + padding + title_size - 2;
  painter.text({x, y}, title, title_size, theme.text, TextAlign::left, FontWeight::bold);
  for (std::size_t k = 0; k < names.size(); ++k) {
    y += row;
    const bool rest = cut && k + 1 == names.size();
    if (!rest) painter.rectangle({x, y - 10}, {x + 12, y + 2}, categorical_color(k), 3);
    painter.text({rest ? x : x + 20, y}, names[k], text_size, rest ? theme.text_muted : theme.text);
  }
}

void draw_gradient(const OverlayInfo& info, Painter& painter, const Box& bar, bool lies) {
  const ColormapKind kind =
      map_of(info.scale) == FieldScale::diverging ? ColormapKind::diverging : ColormapKind::sequential;
  // Each band reaches to the bar's end and is covered by the next: no seams between antialiased edges.
  constexpr int bands = 96;
  for (int k = 0; k < bands; ++k) {
    const float share = static_cast<float>(k) / bands;
    const Point2 from = lies ? Point2{bar.min.x + share * (bar.max.x - bar.min.x), bar.min.y}
                             : Point2{bar.min.x, bar.min.y + share * (bar.max.y - bar.min.y)};
    const double u = (k + 0.5) / bands;
    painter.rectangle(from, bar.max, sample(kind, lies ? u : 1 - u));
  }
}

/// Counts as lengths to the right of the bar or, where it lies, above it; square roots, so that few show beside many.
void draw_histogram(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, const Box& bar, bool lies) {
  const float most = *std::max_element(info.histogram.begin(), info.histogram.end());
  if (!(most > 0)) return;
  const auto bins = static_cast<float>(info.histogram.size());
  const float wide = (lies ? bar.max.x - bar.min.x : bar.max.y - bar.min.y) / bins;
  const float longest = lies ? lying_histogram : histogram_width;
  for (std::size_t k = 0; k < info.histogram.size(); ++k) {
    if (!(info.histogram[k] > 0)) continue;
    const float from = wide * static_cast<float>(k),
                length = std::max(1.f, longest * std::sqrt(info.histogram[k] / most));
    const Box count = lies ? Box{{bar.min.x + from, bar.min.y - 2 - length}, {bar.min.x + from + wide, bar.min.y - 2}}
                           : Box{{bar.max.x + 2, bar.max.y - from - wide}, {bar.max.x + 2 + length, bar.max.y - from}};
    painter.rectangle(count.min, count.max, theme.text_muted);
  }
}

/// At least two, and one near the upper end, else nobody could tell how much a colour means.
TickSet ticks_of(const OverlayInfo& info, float length, float apart) {
  const auto fit = [](const std::vector<Tick>&) { return true; };
  TickSet ticks;
  for (int most = std::clamp(static_cast<int>(length / apart), 2, 7); most <= 7; ++most) {
    ticks = info.scale == ColorScale::logarithmic ? logarithmic_ticks(info.range.min, info.range.max, most, fit)
                                                  : linear_ticks(info.range.min, info.range.max, most, fit);
    const auto& major = ticks.major;
    const bool ends = !major.empty() && map_position(major.back().value, info.range, info.scale) > 0.75;
    const bool full = static_cast<float>(major.size()) * 0.6f * apart > length;
    if (major.size() > 1 && (ends || full)) break;
  }
  return ticks;
}

/// All sizes of the bar and what is beside it.
struct BarLayout {
  TickSet ticks;
  std::string title;
  bool lies = false;
  bool counts = true;  ///< there is room for a histogram
  bool beside = true;  ///< the title runs up beside the bar, else it lies above
  Box panel, bar;
};

std::string title_of(const OverlayInfo& info, const TickSet& ticks) {
  const FieldInfo& field = field_info(info.field);
  return axis_title(info.field_label.empty() ? std::string(field.label) : info.field_label, std::string(field.unit),
                    ticks.exponent);
}

BarLayout lay_out_lying(const OverlayInfo& info, Painter& painter, Point2 min, Point2 max) {
  BarLayout l;
  l.lies = true;
  const float length = std::clamp(0.34f * (max.x - min.x), 100.f, 200.f);
  l.ticks = ticks_of(info, length, 45);
  l.title = title_of(info, l.ticks);
  const float inside = std::max(length, painter.text_width(l.title, title_size)), sides = lying_padding + 5;
  l.counts = !info.histogram.empty() && max.y - min.y >= lowest_with_lying_counts;
  const float counts = l.counts ? lying_histogram + 2 : 0;
  l.panel = place(info, min, max, inside + 2 * sides,
                  2 * lying_padding + title_size + 6 + counts + lying_height + tick_gap + text_size);
  const float top = l.panel.min.y + lying_padding + title_size + 6 + counts;
  l.bar = {{l.panel.min.x + sides, top}, {l.panel.max.x - sides, top + lying_height}};
  return l;
}

std::optional<BarLayout> lay_out(const OverlayInfo& info, Painter& painter, Point2 min, Point2 max) {
  if (legend_lies(min, max)) return lay_out_lying(info, painter, min, max);
  const float room = max.y - min.y - 2 * margin - 2 * padding;
  float height = std::min(room, std::clamp(0.36f * (max.y - min.y), 70.f, 260.f));
  BarLayout l;
  l.ticks = ticks_of(info, height, 34);
  l.title = title_of(info, l.ticks);
  float labels = 0;
  for (const Tick& t : l.ticks.major) labels = std::max(labels, painter.text_width(t.label, text_size));
  const float counts = info.histogram.empty() ? 0 : histogram_width + 2;
  const float title_width = painter.text_width(l.title, title_size);
  const float scale_width = bar_width + tick_gap + labels + counts;
  l.beside = title_width <= height;
  const float width = l.beside ? scale_width + title_size + 8 : std::max(title_width, scale_width);
  const float above = l.beside ? 0 : title_size + 12;
  height = std::min(height, room - above);
  if (height < 3 * text_size) return std::nullopt;  // better none than one that cannot be read
  l.panel = place(info, min, max, width + 2 * padding, height + above + 2 * padding);
  const float right = l.panel.max.x - padding - counts, top = l.panel.min.y + padding + above;
  l.bar = {{right - bar_width, top}, {right, top + height}};
  return l;
}

void draw_tick(const Tick& t, const OverlayInfo& info, const RenderTheme& theme, Painter& painter, const BarLayout& l) {
  const Box& bar = l.bar;
  const auto u = static_cast<float>(map_position(t.value, info.range, info.scale));
  if (l.lies) {
    const float x = bar.min.x + u * (bar.max.x - bar.min.x);
    const std::array mark{Point2{x, bar.max.y}, Point2{x, bar.max.y + 4}};
    painter.polyline(mark, theme.text_muted, 1);
    painter.text({x, bar.max.y + tick_gap + 0.8f * text_size}, t.label, text_size, theme.text, TextAlign::centre);
    return;
  }
  const float y = bar.max.y - u * (bar.max.y - bar.min.y);
  const std::array mark{Point2{bar.min.x - 4, y}, Point2{bar.min.x, y}};
  painter.polyline(mark, theme.text_muted, 1);
  painter.text({bar.min.x - tick_gap, y + 0.36f * text_size}, t.label, text_size, theme.text, TextAlign::right);
}

void draw_scalar(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max) {
  const auto l = lay_out(info, painter, min, max);
  if (!l) return;
  const Box& bar = l->bar;
  painter.rectangle(l->panel.min, l->panel.max, theme.panel, 6);
  if (l->lies)
    painter.text({bar.min.x, l->panel.min.y + lying_padding + title_size - 2}, l->title, title_size, theme.text);
  else if (l->beside)
    painter.text({l->panel.min.x + padding + 0.75f * title_size, 0.5f * (bar.min.y + bar.max.y)}, l->title, title_size,
                 theme.text, TextAlign::centre, FontWeight::regular, 1);
  else
    painter.text({l->panel.max.x - padding, bar.min.y - 14}, l->title, title_size, theme.text, TextAlign::right);
  draw_gradient(info, painter, bar, l->lies);
  if (!info.histogram.empty() && l->counts) draw_histogram(info, theme, painter, bar, l->lies);
  for (const Tick& t : l->ticks.major) draw_tick(t, info, theme, painter, *l);
}

}  // namespace

void draw_color_bar(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max) {
  if (field_info(info.field).scale == FieldScale::categorical)
    draw_categories(info, theme, painter, min, max);
  else if (info.range.max > info.range.min)
    draw_scalar(info, theme, painter, min, max);
}

std::optional<BarPlace> color_bar_place(const OverlayInfo& info, Painter& painter, Point2 min, Point2 max) {
  if (!info.color_bar || max.y - min.y <= lowest_with_legend || !(info.range.max > info.range.min) ||
      info.scale == ColorScale::categorical)
    return std::nullopt;
  const auto l = lay_out(info, painter, min, max);
  if (!l) return std::nullopt;
  return BarPlace{l->bar.min, l->bar.max, l->panel.min, l->panel.max, l->lies};
}

}  // namespace pf
