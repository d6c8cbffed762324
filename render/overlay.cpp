#include "render/overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "core/charts/ticks.hpp"
#include "render/color_bar.hpp"
#include "render/cross_layer.hpp"

namespace pf {

namespace {

constexpr float margin = 12, text_size = 13, small_size = 12, title_size = 16;

/// Text that stays readable on whatever is below: a soft rim of the background's colour.
void text_with_rim(Painter& painter, const RenderTheme& theme, Point2 at, std::string_view text, float size,
                   Color color, TextAlign align = TextAlign::left, FontWeight weight = FontWeight::regular) {
  Color rim = theme.background_bottom;
  rim.a = 0.35f;
  for (const auto& [dx, dy] : {std::pair{-1.f, 0.f}, {1.f, 0.f}, {0.f, -1.f}, {0.f, 1.f}, {-1.f, -1.f}, {1.f, 1.f}})
    painter.text({at.x + dx, at.y + dy}, text, size, rim, align, weight);
  painter.text(at, text, size, color, align, weight);
}

void line_with_rim(Painter& painter, const RenderTheme& theme, std::span<const Point2> points, Color color,
                   float width) {
  Color rim = theme.background_bottom;
  rim.a = 0.6f;
  painter.polyline(points, rim, width + 2);
  painter.polyline(points, color, width);
}

void arrow(Painter& painter, const RenderTheme& theme, Point2 from, Point2 to, Color color, float width = 1.6f) {
  const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length < 2) return;
  const float ux = dx / length, uy = dy / length, head = std::min(7.f, 0.5f * length);
  const Point2 neck{to.x - 0.8f * head * ux, to.y - 0.8f * head * uy};
  const std::array line{from, neck};
  line_with_rim(painter, theme, line, color, width);
  const Point2 base{to.x - head * ux, to.y - head * uy};
  const float half = 0.42f * head;
  const std::array tip{to, Point2{base.x - half * uy, base.y + half * ux},
                       Point2{base.x + half * uy, base.y - half * ux}};
  painter.polygon(tip, color);
}

void draw_title(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min) {
  const bool titled = !info.title.empty();
  if (!titled && !info.clock) return;
  constexpr float padding = 10, between = 20;
  const std::string clock = info.clock ? clock_text(info) : "";
  const float width =
      std::max(painter.text_width(info.title, title_size, FontWeight::bold), painter.text_width(clock, text_size));
  const float height = (titled ? title_size : 0) + (titled && info.clock ? between : info.clock ? text_size : 0);
  const Point2 corner{min.x + margin, min.y + margin};
  painter.rectangle(corner, {corner.x + width + 2 * padding, corner.y + height + 2 * padding - 3}, theme.panel, 6);
  Point2 at{corner.x + padding, corner.y + padding - 2};
  if (titled) {
    at.y += title_size;
    painter.text(at, info.title, title_size, theme.text, TextAlign::left, FontWeight::bold);
  }
  if (!info.clock) return;
  at.y += titled ? between : text_size;
  painter.text(at, clock, text_size, theme.text_muted);
}

/// Directions of the world's axes on the screen, y downwards, and their depth towards the eye.
struct Axis {
  Point2 direction;
  double towards_eye;
  const char* name;
  Color color;
};
std::vector<Axis> axes_on_screen(const Camera& camera) {
  constexpr Color red{0.93f, 0.33f, 0.36f, 1}, green{0.45f, 0.74f, 0.32f, 1}, blue{0.32f, 0.57f, 0.95f, 1};
  const auto* orbit = std::get_if<OrbitCamera>(&camera);
  if (!orbit) return {{{1, 0}, 0, "x", red}, {{0, -1}, 0, "y", green}};
  std::vector<Axis> axes;
  const std::array names{"x", "y", "z"};
  const std::array colors{red, green, blue};
  const Vec3 right = orbit->right(), up = orbit->up(), forward = orbit->forward();
  for (std::size_t a = 0; a < 3; ++a)
    axes.push_back({{static_cast<float>(right[a]), static_cast<float>(-up[a])}, -forward[a], names[a], colors[a]});
  std::sort(axes.begin(), axes.end(), [](const Axis& l, const Axis& r) { return l.towards_eye < r.towards_eye; });
  return axes;
}

constexpr float axis_length = 30;

/// Returns the x where the next thing may begin.
float draw_axes(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max) {
  const bool flat = std::holds_alternative<Camera2D>(info.camera);
  const Point2 origin = flat ? Point2{min.x + margin + 4, max.y - margin - 4}
                             : Point2{min.x + margin + axis_length + 6, max.y - margin - axis_length - 6};
  for (const Axis& axis : axes_on_screen(info.camera)) {
    const Point2 tip{origin.x + axis_length * axis.direction.x, origin.y + axis_length * axis.direction.y};
    arrow(painter, theme, origin, tip, axis.color, 2);
    const Point2 name{origin.x + (axis_length + 9) * axis.direction.x,
                      origin.y + (axis_length + 9) * axis.direction.y + 4};
    text_with_rim(painter, theme, name, axis.name, small_size, theme.text, TextAlign::centre);
  }
  return origin.x + axis_length + 30;
}

/// At the camera's focus in 3D.
double painted_units_per_metre(const OverlayInfo& info) {
  const auto* flat = std::get_if<Camera2D>(&info.camera);
  const double pixels_per_metre =
      flat ? flat->pixels_per_metre : std::get<OrbitCamera>(info.camera).pixels_per_metre(info.size);
  return pixels_per_metre / info.pixel_scale;
}

float draw_scale_bar(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, float x, float y,
                     float longest) {
  const double units_per_metre = painted_units_per_metre(info);
  const RoundLength length = round_length(static_cast<double>(longest) / units_per_metre);
  const auto width = static_cast<float>(length.metres * units_per_metre);
  const std::array bar{Point2{x, y - 5}, Point2{x, y}, Point2{x + width, y}, Point2{x + width, y - 5}};
  line_with_rim(painter, theme, bar, theme.text, 1.6f);
  text_with_rim(painter, theme, {x + 0.5f * width, y - 9}, length.text, small_size, theme.text, TextAlign::centre);
  return x + std::max(width, painter.text_width(length.text, small_size)) + 32;
}

/// 1, 2 or 5 times a power of ten.
double round_below(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1);
}

/// "20 kPa".
std::string with_prefix(double value, const char* unit) {
  constexpr std::array prefixes{std::pair{1e9, "G"},  std::pair{1e6, "M"},  std::pair{1e3, "k"}, std::pair{1.0, ""},
                                std::pair{1e-3, "m"}, std::pair{1e-6, "µ"}, std::pair{1e-9, "n"}};
  for (const auto& [size, prefix] : prefixes)
    if (value >= 0.999 * size) return number_text(value / size, 1) + " " + prefix + unit;
  return number_text(value, 1) + " " + unit;
}

/// An arrow of at most 70 units and what it stands for. Returns the x where the next thing may begin.
float draw_arrow_key(double units_each, Color color, const std::function<std::string(double)>& words,
                     const RenderTheme& theme, Painter& painter, float x, float y) {
  if (!(units_each > 0)) return x;
  const double value = round_below(70 / units_each);
  const auto length = static_cast<float>(value * units_each);
  arrow(painter, theme, {x, y - 2}, {x + length, y - 2}, color);
  const std::string text = words(value);
  text_with_rim(painter, theme, {x, y - 11}, text, small_size, theme.text);
  return x + std::max(length, painter.text_width(text, small_size)) + 32;
}

void draw_cross_key(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, float x, float y) {
  const double units_per_pascal = info.cross_pixels_per_pascal / info.pixel_scale;
  if (!(units_per_pascal > 0)) return;
  const double stress = round_below(40 / units_per_pascal);
  const auto length = static_cast<float>(stress * units_per_pascal);
  std::string text = with_prefix(stress, "Pa");
  float at = x;
  for (const auto& [color, name] : {std::pair{tension_color(theme), std::string("tension")},
                                    {compression_color(theme), std::string("compression")}}) {
    const std::array line{Point2{at, y - 2}, Point2{at + length, y - 2}};
    line_with_rim(painter, theme, line, color, 2.4f);
    const std::string words = name == "tension" ? text.append(" ").append(name) : name;
    text_with_rim(painter, theme, {at, y - 11}, words, small_size, theme.text);
    at += std::max(length, painter.text_width(words, small_size)) + 16;
  }
}

}  // namespace

std::string clock_text(const OverlayInfo& info) {
  const int decimals = info.dt > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(info.dt))), 2, 7) : 3;
  std::string text = "t = " + fixed_text(info.time, decimals) + " s";
  if (info.step >= 0) text += "    step " + std::to_string(info.step);
  return text;
}

RoundLength round_length(double most) {
  if (!(most > 0) || !std::isfinite(most)) return {};
  const double power = std::pow(10.0, std::floor(std::log10(most) + 1e-9));
  const double metres = power * (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1);
  struct Unit {
    double metres;
    const char* name;
  };
  constexpr std::array units{Unit{1e3, "km"},  Unit{1, "m"},          Unit{1e-2, "cm"},
                             Unit{1e-3, "mm"}, Unit{1e-6, "\u00b5m"}, Unit{1e-9, "nm"}};
  for (const Unit& unit : units)
    if (metres >= unit.metres * (1 - 1e-9))
      return {metres, std::to_string(std::lround(metres / unit.metres)) + " " + unit.name};
  return {metres, number_text(metres, 2) + " m"};
}

OverlayInfo OverlayInfo::of(const Snapshot& snapshot, const Renderer& renderer, const RenderOptions& options,
                            const Camera& camera, ViewSize size) {
  OverlayInfo info;
  info.time = snapshot.report.time;
  info.dt = snapshot.report.dt;
  info.step = snapshot.report.step;
  info.field = options.field;
  info.range = renderer.range();
  if (snapshot.scene) info.material_names = snapshot.scene->material_names;
  info.camera = camera;
  info.size = size;
  info.pixel_scale = options.pixel_scale;
  info.arrow_pixels_per_speed = renderer.arrow_pixels_per_speed();
  info.cross_pixels_per_pascal = renderer.cross_pixels_per_pascal();
  info.scale = color_scale(options);
  return info;
}

bool legend_lies(Point2 min, Point2 max) {
  const float width = max.x - min.x, height = max.y - min.y;
  return height >= lowest_with_lying_legend && (width < 520 || height < 380);
}

ViewMargins overlay_margins(int dimension, double width, double height) {
  ViewMargins m{28, 132, 68, 66};
  if (dimension == 3) m = {28, 132, 64, 40};
  if (legend_lies({0, 0}, {static_cast<float>(width), static_cast<float>(height)}))
    m = {28, 28, 54, 92, 96 + std::min(120.0, 0.25 * width), 68 + std::clamp(0.34 * width, 160.0, 200.0), 18};
  else if (height < static_cast<double>(lowest_with_lying_legend))
    m = {130, height > static_cast<double>(lowest_with_legend) ? 140.0 : 28.0, 10, 30};  // beside the tools
  return m;
}

void draw_overlay(const OverlayInfo& info, const RenderTheme& theme, Painter& painter, Point2 min, Point2 max) {
  painter.push_clip(min, max);
  draw_title(info, theme, painter, min);
  if (info.color_bar && max.y - min.y > lowest_with_legend) draw_color_bar(info, theme, painter, min, max);
  float x = min.x + margin + 4, y = max.y - margin;
  if (info.axes) x = draw_axes(info, theme, painter, min, max);
  const float begin = x;
  if (info.scale_bar) x = draw_scale_bar(info, theme, painter, x, y, std::min(120.f, 0.25f * (max.x - min.x)));
  if (info.color_bar && legend_lies(min, max)) {  // the rest of this line is taken: above the scale bar
    x = begin;
    y -= 34;
  }
  x = draw_arrow_key(
      info.arrow_pixels_per_speed / info.pixel_scale, theme.arrow,
      [](double speed) { return number_text(speed, 1) + " m/s"; }, theme, painter, x, y);
  x = draw_arrow_key(
      info.force_metres_per_newton * painted_units_per_metre(info), info.force_color,
      [](double force) { return with_prefix(force, "N"); }, theme, painter, x, y);
  draw_cross_key(info, theme, painter, x, y);
  painter.pop_clip();
}

}  // namespace pf
