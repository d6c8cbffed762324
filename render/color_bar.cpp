#include "render/color_bar.hpp"

#include <algorithm>
#include <array>

#include "core/charts/colormap.hpp"
#include "core/charts/ticks.hpp"

namespace pf {

namespace {

constexpr float margin = 12, padding = 12, text_size = 12, title_size = 13, bar_width = 14, tick_gap = 7;

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

void draw_gradient(const FieldInfo& info, Painter& painter, const Box& bar) {
  const ColormapKind kind = info.scale == FieldScale::diverging ? ColormapKind::diverging : ColormapKind::sequential;
  // Each band reaches down to the bar's end and is covered by the next: no seams between antialiased edges.
  constexpr int bands = 96;
  for (int k = 0; k < bands; ++k) {
    const float top = bar.min.y + (bar.max.y - bar.min.y) * static_cast<float>(k) / bands;
    painter.rectangle({bar.min.x, top}, bar.max, sample(kind, 1 - (k + 0.5) / bands));
  }
}

void draw_scalar(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max) {
  const FieldInfo& field = field_info(info.field);
  const float room = max.y - top_of(info, min, max) - margin - 2 * padding;
  float height = std::min(room, std::clamp(0.36f * (max.y - min.y), 70.f, 260.f));
  const int most = std::clamp(static_cast<int>(height / 34), 2, 7);
  const auto fit = [](const std::vector<Tick>&) { return true; };
  const TickSet ticks = linear_ticks(info.range.min, info.range.max, most, fit);
  const std::string title = axis_title(info.field_label.empty() ? std::string(field.label) : info.field_label,
                                       std::string(field.unit), ticks.exponent);
  float labels = 0;
  for (const Tick& t : ticks.major) labels = std::max(labels, painter.text_width(t.label, text_size));
  // The title runs up beside the bar where it is short enough, else it lies above.
  const float title_width = painter.text_width(title, title_size), scale_width = bar_width + tick_gap + labels;
  const bool beside = title_width <= height;
  const float width = beside ? scale_width + title_size + 8 : std::max(title_width, scale_width);
  const float above = beside ? 0 : title_size + 12;
  height = std::min(height, room - above);
  if (height < 3 * text_size) return;  // better none than one that cannot be read
  const Box box = panel(theme, painter, max, top_of(info, min, max), width + 2 * padding, height + above + 2 * padding);
  const float right = box.max.x - padding, top = box.min.y + padding + above;
  if (beside)
    painter.text({box.min.x + padding + 0.75f * title_size, top + 0.5f * height}, title, title_size, theme.text,
                 TextAlign::centre, FontWeight::regular, 1);
  else
    painter.text({right, top - 14}, title, title_size, theme.text, TextAlign::right);
  const Box bar{{right - bar_width, top}, {right, top + height}};
  draw_gradient(field, painter, bar);
  for (const Tick& t : ticks.major) {
    const double u = (t.value - info.range.min) / (info.range.max - info.range.min);
    const float y = bar.max.y - static_cast<float>(u) * height;
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

}  // namespace pf
