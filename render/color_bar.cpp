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
constexpr float histogram_width = 22;

struct Box {
  Point2 min, max;
};

/// The legend stands beside the title, or below it where the view is narrow.
float top_of(const OverlayInfo& info, Point2 min, Point2 max) {
  return min.y + margin + (info.clock && max.x - min.x < 520 ? 64.f : 0.f);
}

/// A panel of this size at the right edge.
Box panel(const RenderTheme& theme, Painter& painter, Point2 max, float top, float width, float height) {
  const Box box{{max.x - margin - width, top}, {max.x - margin, top + height}};
  painter.rectangle(box.min, box.max, theme.panel, 6);
  return box;
}

void draw_categories(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max) {
  constexpr float row = 20;
  // More names than fit end with how many are missing.
  const float room = max.y - top_of(info, min, max) - margin - 100;
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
  const Box box = panel(theme, painter, max, top_of(info, min, max), width + 2 * padding,
                        2 * padding + title_size + row * static_cast<float>(names.size()) + 2);
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

void draw_gradient(const OverlayInfo& info, Painter& painter, const Box& bar) {
  const ColormapKind kind =
      map_of(info.scale) == FieldScale::diverging ? ColormapKind::diverging : ColormapKind::sequential;
  // Each band reaches down to the bar's end and is covered by the next: no seams between antialiased edges.
  constexpr int bands = 96;
  for (int k = 0; k < bands; ++k) {
    const float top = bar.min.y + (bar.max.y - bar.min.y) * static_cast<float>(k) / bands;
    painter.rectangle({bar.min.x, top}, bar.max, sample(kind, 1 - (k + 0.5) / bands));
  }
}

/// Counts as lengths to the right of the bar; square roots, so that few show beside many.
void draw_histogram(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, const Box& bar) {
  const float most = *std::max_element(info.histogram.begin(), info.histogram.end());
  if (!(most > 0)) return;
  const auto bins = static_cast<float>(info.histogram.size());
  const float height = (bar.max.y - bar.min.y) / bins;
  Color color = theme.text_muted;
  for (std::size_t k = 0; k < info.histogram.size(); ++k) {
    if (!(info.histogram[k] > 0)) continue;
    const float low = bar.max.y - height * static_cast<float>(k);
    const float length = std::max(1.f, histogram_width * std::sqrt(info.histogram[k] / most));
    painter.rectangle({bar.max.x + 2, low - height}, {bar.max.x + 2 + length, low}, color);
  }
}

TickSet ticks_of(const OverlayInfo& info, float height) {
  const auto fit = [](const std::vector<Tick>&) { return true; };
  const int most = std::clamp(static_cast<int>(height / 34), 2, 7);
  if (info.scale == ColorScale::logarithmic) return logarithmic_ticks(info.range.min, info.range.max, most, fit);
  return linear_ticks(info.range.min, info.range.max, most, fit);
}

/// All sizes of the bar and what is beside it.
struct BarLayout {
  TickSet ticks;
  std::string title;
  bool beside = true;  ///< the title runs up beside the bar, else it lies above
  Box panel, bar;
};
std::optional<BarLayout> lay_out(const OverlayInfo& info, Painter& painter, Point2 min, Point2 max) {
  const FieldInfo& field = field_info(info.field);
  const float room = max.y - top_of(info, min, max) - margin - 2 * padding;
  float height = std::min(room, std::clamp(0.36f * (max.y - min.y), 70.f, 260.f));
  BarLayout l;
  l.ticks = ticks_of(info, height);
  l.title = axis_title(info.field_label.empty() ? std::string(field.label) : info.field_label, std::string(field.unit),
                       l.ticks.exponent);
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
  const float top = top_of(info, min, max), panel_width = width + 2 * padding;
  l.panel = {{max.x - margin - panel_width, top}, {max.x - margin, top + height + above + 2 * padding}};
  const float right = l.panel.max.x - padding - counts;
  l.bar = {{right - bar_width, top + padding + above}, {right, top + padding + above + height}};
  return l;
}

void draw_scalar(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max) {
  const auto l = lay_out(info, painter, min, max);
  if (!l) return;
  const Box& bar = l->bar;
  painter.rectangle(l->panel.min, l->panel.max, theme.panel, 6);
  if (l->beside)
    painter.text({l->panel.min.x + padding + 0.75f * title_size, 0.5f * (bar.min.y + bar.max.y)}, l->title, title_size,
                 theme.text, TextAlign::centre, FontWeight::regular, 1);
  else
    painter.text({l->panel.max.x - padding, bar.min.y - 14}, l->title, title_size, theme.text, TextAlign::right);
  draw_gradient(info, painter, bar);
  if (!info.histogram.empty()) draw_histogram(info, theme, painter, bar);
  for (const Tick& t : l->ticks.major) {
    const auto u = static_cast<float>(map_position(t.value, info.range, info.scale));
    const float y = bar.max.y - u * (bar.max.y - bar.min.y);
    const std::array mark{Point2{bar.min.x - 4, y}, Point2{bar.min.x, y}};
    painter.polyline(mark, theme.text_muted, 1);
    painter.text({bar.min.x - tick_gap, y + 0.36f * text_size}, t.label, text_size, theme.text, TextAlign::right);
  }
}

}  // namespace

void draw_color_bar(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max) {
  if (field_info(info.field).scale == FieldScale::categorical)
    draw_categories(info, theme, painter, min, max);
  else if (info.range.max > info.range.min)
    draw_scalar(info, theme, painter, min, max);
}

std::optional<BarPlace> color_bar_place(const OverlayInfo& info, Painter& painter, Point2 min, Point2 max) {
  if (!info.color_bar || max.y - min.y <= 140 || !(info.range.max > info.range.min) ||
      info.scale == ColorScale::categorical)
    return std::nullopt;
  const auto l = lay_out(info, painter, min, max);
  if (!l) return std::nullopt;
  return BarPlace{l->bar.min, l->bar.max, l->panel.min, l->panel.max};
}

}  // namespace pf
