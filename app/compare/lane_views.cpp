#include "app/compare/lane_views.hpp"

#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/gl_view.hpp"
#include "app/imgui_painter.hpp"
#include "app/theme.hpp"
#include "app/widgets/units.hpp"
#include "core/charts/png_painter.hpp"
#include "core/charts/theme.hpp"
#include "render/overlay.hpp"

namespace pf::app {
namespace {

constexpr float gap_between = 2;  // pixels

/// What the colours mean while lanes are coloured by it.
constexpr const char* distance_label = "Distance from lane 1";

std::string distance_words(const LaneFrame& lane, std::size_t index) {
  if (!lane.failure.empty()) return "stands still: " + lane.failure;
  if (index == 0) return "the others are measured against this one";
  if (!lane.distance) return "other particles than in lane 1";
  return quantity(lane.distance->rms, "m", 3) + " from lane 1, at most " + quantity(lane.distance->max, "m", 3);
}

/// Shortened to `width`.
std::string fitted(Painter& painter, std::string text, float size, float width) {
  if (painter.text_width(text, size) <= width) return text;
  while (text.size() > 4 && painter.text_width(text + "…", size) > width) {
    text.pop_back();
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
  }
  return text + "…";
}

/// Scale, axes and a second line of text beside the picture, not over it.
bool roomy(Point2 low, Point2 high) {
  return high.y - low.y > 11 * base_em && high.x - low.x > 13 * base_em;
}
constexpr float head_height = 2.85F * base_em, brief_head_height = 1.95F * base_em;

Color text_color(Theme theme) {
  return palette(theme).text;
}

/// The lane's number in its colour, its name, and how far it has come away from the first.
/// `detailed`: where there is room for it. `clock`: said before that, where it is not empty.
void draw_head(Painter& painter, const LaneFrame& lane, std::size_t index, Theme theme, Point2 corner, float width,
               bool detailed, const std::string& clock = {}) {
  constexpr float em = base_em;
  const ChartTheme colors = theme == Theme::dark ? dark_theme() : light_theme();
  const float left = corner.x + 2.5F * em, room = width - 3.2F * em;
  const std::string name = fitted(painter, lane.name, em, room);
  const std::string said = (clock.empty() ? "" : clock + ", ") + distance_words(lane, index);
  const std::string words = detailed ? fitted(painter, said, 0.85F * em, room) : "";
  const float wide = std::max(painter.text_width(name, em, FontWeight::bold), painter.text_width(words, 0.85F * em));
  Color back = palette(theme).window;
  back.a = 0.9F;
  painter.rectangle({corner.x + 0.3F * em, corner.y + 0.35F * em},
                    {left + wide + 0.5F * em, corner.y + (detailed ? head_height : brief_head_height)}, back,
                    0.4F * em);
  const Point2 centre{corner.x + 1.3F * em, corner.y + (detailed ? 1.35F : 1.15F) * em};
  painter.circle(centre, 0.72F * em, colors.series[index]);
  painter.text({centre.x, centre.y + 0.36F * em}, std::to_string(index + 1), em,
               theme == Theme::dark ? Color{0, 0, 0, 1} : Color{1, 1, 1, 1}, TextAlign::centre, FontWeight::bold);
  painter.text({left, corner.y + (detailed ? 1.3F : 1.5F) * em}, name, em, text_color(theme), TextAlign::left,
               FontWeight::bold);
  if (detailed)
    painter.text({left, corner.y + 2.4F * em}, words, 0.85F * em,
                 lane.failure.empty() ? palette(theme).muted : palette(theme).error);
}

}  // namespace

std::vector<Rect> lane_cells(const Rect& view, std::size_t lanes, float aspect) {
  std::size_t best = 1;
  float largest = 0;
  for (std::size_t columns = 1; columns <= lanes; ++columns) {
    const std::size_t rows = (lanes + columns - 1) / columns;
    const float width = view.width / static_cast<float>(columns), height = view.height / static_cast<float>(rows);
    const float scale = std::min(width, height * aspect);
    if (scale > 1.02F * largest) {
      largest = scale;
      best = columns;
    }
  }
  const std::size_t rows = (lanes + best - 1) / best;
  const float width = std::floor((view.width - gap_between * static_cast<float>(best - 1)) / static_cast<float>(best));
  const float height =
      std::floor((view.height - gap_between * static_cast<float>(rows - 1)) / static_cast<float>(rows));
  std::vector<Rect> cells;
  for (std::size_t k = 0; k < lanes; ++k) {
    const std::size_t row = k / best, column = k % best;
    cells.push_back({view.x + static_cast<float>(column) * (width + gap_between),
                     view.y + static_cast<float>(row) * (height + gap_between), width, height});
  }
  return cells;
}

Rect LaneViews::place(const Rect& view, std::size_t lanes, float aspect, Point2 mouse) {
  cells_ = lane_cells(view, lanes, aspect);
  for (const Rect& cell : cells_)
    if (cell.contains(mouse.x, mouse.y)) return cell;
  return cells_.front();
}

ViewMargins LaneViews::margins(int dimension, float overlay_scale) const {
  return lane_margins(dimension, {cells_.front().width / overlay_scale, cells_.front().height / overlay_scale});
}

ViewMargins lane_margins(int dimension, Point2 size) {
  ViewMargins m = overlay_margins(dimension, static_cast<double>(size.x), static_cast<double>(size.y));
  const bool room = roomy({0, 0}, size);
  if (!room) m = {12, 12, 0, 12};
  m.top = static_cast<double>(room ? head_height : brief_head_height) + 6;
  return m;
}

void LaneViews::forget() {
  range_.reset();
  ranged_.reset();
}

RenderOptions LaneViews::options(const AppContext& context, const CompareDesk& desk, float pixel_scale) {
  RenderOptions o = render_options(context, pixel_scale);
  if (o.range || !desk.frame) return o;
  const ColorScale scale = color_scale(o);
  const bool other = ranged_field_ != o.field || ranged_scale_ != scale;
  if (other) range_.reset();
  if (ranged_ != desk.frame || other) {
    ranged_ = desk.frame;
    ranged_field_ = o.field;
    ranged_scale_ = scale;
    constexpr std::size_t enough = 10000;
    std::vector<float> values;
    for (const LaneFrame& lane : desk.frame->lanes) {
      if (!lane.snapshot) continue;
      const auto& all = lane.snapshot->field[static_cast<std::size_t>(o.field)];
      const std::size_t stride = all.size() / enough + 1;
      for (std::size_t k = 0; k < all.size(); k += stride) values.push_back(all[k]);
    }
    if (!values.empty()) range_.update(values, field_info(o.field), scale);
  }
  if (scale != ColorScale::categorical) o.range = range_.range();
  return o;
}

void LaneViews::draw(const AppContext& context, const CompareDesk& desk, const Camera& camera, float pixels_per_unit,
                     float framebuffer_height, float overlay_scale) {
  while (views_.size() < cells_.size()) views_.push_back(std::make_unique<View>());
  if (!desk.frame) return;
  const auto whole = [](float v) { return static_cast<int>(std::lround(v)); };
  const RenderOptions options = this->options(context, desk, pixels_per_unit * overlay_scale);
  for (std::size_t k = 0; k < cells_.size() && k < desk.frame->lanes.size(); ++k) {
    const auto& snapshot = desk.frame->lanes[k].snapshot;
    if (!snapshot) continue;
    View& view = *views_[k];
    const ViewSize size{std::max(1, whole(cells_[k].width * pixels_per_unit)),
                        std::max(1, whole(cells_[k].height * pixels_per_unit))};
    if (!view.target || view.target->size() != size) {
      view.target.emplace(size, 1);
      view.shown.reset();
    }
    const Shown wanted{snapshot, options, camera};
    const bool anew = view.shown != wanted;
    if (anew) {
      view.target->bind();
      view.renderer.draw(*snapshot, options, camera, {0, 0, size});
      view.shown = wanted;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);  // the window's
    view.target->copy_to(whole(cells_[k].x * pixels_per_unit),
                         whole(framebuffer_height - cells_[k].bottom() * pixels_per_unit), anew);
  }
}

void LaneViews::draw_overlay(const AppContext& context, const CompareDesk& desk, const Camera& camera,
                             float pixels_per_unit, float overlay_scale, ImDrawList& list) const {
  if (!desk.frame) return;
  const RenderOptions options = render_options(context, pixels_per_unit * overlay_scale);
  ImGuiPainter painter(list, overlay_scale);
  for (std::size_t k = 0; k < cells_.size() && k < desk.frame->lanes.size() && k < views_.size(); ++k) {
    const LaneFrame& lane = desk.frame->lanes[k];
    const Rect& cell = cells_[k];
    const Point2 low{cell.x / overlay_scale, cell.y / overlay_scale},
        high{cell.right() / overlay_scale, cell.bottom() / overlay_scale};
    painter.push_clip(low, high);
    if (lane.snapshot && views_[k]->target) {
      OverlayInfo info =
          OverlayInfo::of(*lane.snapshot, views_[k]->renderer, options, camera, views_[k]->target->size());
      info.clock = false;
      if (desk.difference) info.field_label = distance_label;
      info.scale_bar = info.axes = k == 0 && roomy(low, high);
      info.color_bar = high.x - low.x > 24 * base_em || (k + 1 == cells_.size() && roomy(low, high));
      pf::draw_overlay(info, options.theme, painter, low, high);
    }
    draw_head(painter, lane, k, context.view.theme, low, high.x - low.x, roomy(low, high));
    painter.pop_clip();
  }
}

Image LaneViews::picture(const AppContext& context, const CompareDesk& desk, const GlView& view,
                         const PictureRequest& request, float pixels_per_unit, float overlay_scale) {
  // Everything in pixels of the picture from here on; the lanes' cells begin in its corner.
  const Rect& shown = cells_.front();
  float right = 0;
  for (const Rect& cell : cells_) right = std::max(right, cell.right());
  Rect whole{0, 0, right - shown.x, cells_.back().bottom() - shown.y};
  const float wanted = request.as_view ? pixels_per_unit : std::max(1.0F, 1600.0F / whole.width);
  std::vector<Rect> cells;
  if (request.size.width > 0) {
    whole.width = static_cast<float>(request.size.width);
    whole.height = static_cast<float>(request.size.height);
    cells = lane_cells(whole, cells_.size(), shown.width / shown.height);
  } else {
    for (const Rect& cell : cells_)
      cells.push_back({std::round(wanted * (cell.x - shown.x)), std::round(wanted * (cell.y - shown.y)),
                       std::round(wanted * cell.width), std::round(wanted * cell.height)});
    whole.width = std::round(wanted * whole.width);
    whole.height = std::round(wanted * whole.height);
  }
  const Rect& first = cells.front();
  const float finer = std::min(first.width / shown.width, first.height / shown.height);
  const ViewSize size{static_cast<int>(first.width), static_cast<int>(first.height)};
  const float scale = finer * overlay_scale;
  const Camera closer =
      view.picture_camera(size, lane_margins(context.scene.dimension, {first.width / scale, first.height / scale}),
                          static_cast<double>(scale));
  RenderOptions options = this->options(context, desk, scale);
  options.best_quality = true;
  options.transparent = request.transparent;
  options.selected.reset();
  Color behind = palette(context.view.theme).border;
  if (request.transparent) behind.a = 0;
  Image image(static_cast<int>(whole.width), static_cast<int>(whole.height), behind);
  OffscreenTarget target(size);
  for (std::size_t k = 0; k < cells.size() && k < desk.frame->lanes.size(); ++k) {
    const LaneFrame& lane = desk.frame->lanes[k];
    if (!lane.snapshot) continue;
    target.bind();
    views_[k]->renderer.draw(*lane.snapshot, options, closer, {0, 0, size});
    Image part = target.read();
    if (request.transparent) part.unpremultiply();
    if (request.overlay) write_over(part, context, desk, k, options, closer);
    const int x0 = static_cast<int>(cells[k].x), y0 = static_cast<int>(cells[k].y);
    for (int y = 0; y < part.height && y0 + y < image.height; ++y) {
      const auto bytes = static_cast<std::size_t>(4 * std::min(part.width, image.width - x0));
      std::memcpy(image.at(x0, y0 + y), part.at(0, y), bytes);
    }
  }
  return image;
}

void LaneViews::write_over(Image& part, const AppContext& context, const CompareDesk& desk, std::size_t k,
                           const RenderOptions& options, const Camera& camera) const {
  const LaneFrame& lane = desk.frame->lanes[k];
  OverlayInfo info = OverlayInfo::of(*lane.snapshot, views_[k]->renderer, options, camera, {part.width, part.height});
  info.step = -1;  // each lane has its own
  const std::string clock = k == 0 ? clock_text(info) : "";
  info.clock = false;  // it is in the head
  if (desk.difference) info.field_label = distance_label;
  info.scale_bar = info.axes = k == 0;
  PngPainter painter(part, options.pixel_scale);
  const Point2 end{static_cast<float>(part.width) / options.pixel_scale,
                   static_cast<float>(part.height) / options.pixel_scale};
  pf::draw_overlay(info, options.theme, painter, {0, 0}, end);
  draw_head(painter, lane, k, context.view.theme, {0, 0}, end.x, true, clock);
}

}  // namespace pf::app
