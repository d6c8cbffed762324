#include "app/gl_view.hpp"

#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/compare/desk.hpp"
#include "app/imgui_painter.hpp"
#include "app/inside/marks.hpp"
#include "app/inside/overlay.hpp"
#include "app/inside/slow_overlay.hpp"
#include "app/inside/step_player.hpp"
#include "app/outline/outlines.hpp"
#include "app/outline/probe_marks.hpp"
#include "app/theme.hpp"
#include "render/overlay.hpp"

namespace pf::app {
namespace {

constexpr float click_slop = 3;                        // pixels that a click may wander
constexpr std::chrono::milliseconds still_after{250};  // a picture that stays is worth its full quality
constexpr double zoom_a_notch = 1.15;
constexpr double radians_per_pixel = 0.008;

}  // namespace

/// The current camera for tools.
class CameraMap : public ViewMap {
 public:
  explicit CameraMap(const GlView& view) : view_(view) {}
  std::optional<Point2> to_pixel(const Vec3& point) const override { return view_.to_window(point); }
  double metres_per_pixel(const Vec3& at) const override {
    if (const auto* flat = std::get_if<Camera2D>(&view_.camera_))
      return view_.pixels_per_unit_ / flat->pixels_per_metre;
    const auto& orbit = std::get<OrbitCamera>(view_.camera_);
    const double depth = (at - orbit.eye()).dot(orbit.forward());
    return view_.pixels_per_unit_ / orbit.pixels_per_metre(view_.size_) * std::max(depth, 0.0) / orbit.distance;
  }
  float em() const override { return ImGui::GetFontSize(); }

 private:
  const GlView& view_;
};

RenderOptions render_options(const AppContext& context, float pixel_scale) {
  const ViewState& view = context.view;
  RenderOptions o;
  o.field = view.field;
  if (view.lock_range) o.range = ValueRange{view.range_min, view.range_max};
  o.logarithmic = view.log_colors;
  o.symmetric = view.symmetric;
  o.stress_crosses = view.show_crosses && !context.slow;
  o.particles = view.show_particles;
  o.deformed = view.deformed_particles;
  o.grid = view.show_grid;
  o.velocities = view.show_velocities;
  o.bent_grid = view.show_bent_grid;
  o.bent_magnification = view.bent_magnification;
  o.boundaries = o.regions = view.show_boundaries;
  o.selected = context.selected_particle;
  if (context.slow) {
    o.grid = o.velocities = o.bent_grid = true;
    o.bent_magnification = 1;  // the player's snapshots are magnified already
    const PhaseKind kind = context.slow->phase().kind;
    o.velocities = kind == PhaseKind::give || kind == PhaseKind::guess;
  }
  if (comparing(context) && context.compare->difference) {
    o.field = Field::error;
    o.range.reset();
    o.logarithmic = false;
    o.symmetric.reset();
  }
  o.pixel_scale = pixel_scale;
  o.theme = view.theme == Theme::dark ? RenderTheme::dark() : RenderTheme::light();
  return o;
}

GlView::GlView() {
  for (const ToolInfo& info : tools()) tools_.push_back(info.make());
}

void GlView::place(const Rect& where, float pixels_per_unit, float framebuffer_height,
                   const std::optional<ViewMargins>& margins) {
  where_ = where;
  margins_ = margins;
  pixels_per_unit_ = pixels_per_unit;
  framebuffer_height_ = framebuffer_height;
  const auto pixels = [&](float units) { return std::max(1, static_cast<int>(std::lround(units * pixels_per_unit))); };
  size_ = {pixels(where.width), pixels(where.height)};
}

float GlView::overlay_scale() const {
  return ImGui::GetFontSize() / base_em;
}

ViewMargins GlView::margins() const {
  const double scale = static_cast<double>(overlay_scale() * pixels_per_unit_);
  const ViewMargins m = margins_ ? *margins_ : overlay_margins(dimension_, size_.width / scale, size_.height / scale);
  // The content keeps at least so much of each side.
  constexpr double least = 0.35;
  const auto shrunk = [&](double both, double side) {
    return both > 0 ? scale * std::min(1.0, (1 - least) * side / (scale * both)) : scale;
  };
  const double across = shrunk(m.left + m.right, size_.width), along = shrunk(m.top + m.bottom, size_.height);
  return settled(m.scaled(across, along), camera_, fitted_, size_);
}

void GlView::follow_camera(const Snapshot& snapshot) {
  const bool other_kind = snapshot.dimension != dimension_;
  if (fit_wanted_ || other_kind) {
    fitted_ = scene_bounds(snapshot);
    dimension_ = snapshot.dimension;
    fitted_size_ = fitted_.size().maxCoeff();
    fit_wanted_ = false;
    follow_size_ = true;
    camera_ = fitted_camera(dimension_, fitted_, size_);
    std::visit([&](auto& camera) { camera.fit(fitted_, size_, margins()); }, camera_);
  } else if (follow_size_) {
    // Bodies that move out of sight take the view with them; not while the mouse pulls at them.
    const bool moved = !shown_ || shown_->snapshot.get() != &snapshot;
    const ViewBounds body = moved && !held_ ? particle_bounds(snapshot) : fitted_;
    if (!in_sight(body)) fitted_ = widened(fitted_, body, fitted_size_);
    std::visit([&](auto& camera) { camera.fit(fitted_, size_, margins()); }, camera_);
  }
}

bool GlView::in_sight(const ViewBounds& bounds) const {
  const ViewMargins m = margins();
  for (int corner = 0; corner < 8; ++corner) {
    const auto end = [&](int axis) { return corner >> axis & 1 ? bounds.max[axis] : bounds.min[axis]; };
    const auto pixel = to_pixel(camera_, {end(0), end(1), end(2)}, size_);
    if (!pixel || pixel->x() < m.left - 1 || pixel->x() > size_.width - m.right + 1 || pixel->y() < m.top - 1 ||
        pixel->y() > size_.height - m.bottom + 1)
      return false;
  }
  return true;
}

void GlView::draw(const AppContext& context) {
  if (!context.snapshot || where_.empty()) return;
  follow_camera(*context.snapshot);
  if (!target_ || target_->size() != size_) {
    target_.emplace(size_, 1);
    shown_.reset();
  }
  Shown wanted{context.snapshot, render_options(context, pixels_per_unit_ * overlay_scale()), camera_};
  if (shown_) wanted.options.in_motion = shown_->options.in_motion;
  // While the next scene is being built, this one's picture deserves no more work.
  if (shown_ != wanted || context.status.state == RunState::loading) changed_at_ = Clock::now();
  wanted.options.in_motion = software() && dimension_ == 3 && Clock::now() < changed_at_ + still_after;
  const bool anew = shown_ != wanted;
  if (anew) {
    target_->bind();
    renderer_.draw(*wanted.snapshot, wanted.options, camera_, {0, 0, size_});
    shown_ = wanted;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);  // the window's
  const auto whole = [](float v) { return static_cast<int>(std::lround(v)); };
  target_->copy_to(whole(where_.x * pixels_per_unit_), whole(framebuffer_height_ - where_.bottom() * pixels_per_unit_),
                   anew);
}

void GlView::aim(const AppContext& context) {
  if (context.snapshot && !where_.empty()) follow_camera(*context.snapshot);
}

std::optional<double> GlView::refines_in() const {
  if (!shown_ || !shown_->options.in_motion) return std::nullopt;
  return std::max(0.0, std::chrono::duration<double>(changed_at_ + still_after - Clock::now()).count());
}

std::optional<Point2> GlView::to_window(const Vec3& point) const {
  const auto pixel = to_pixel(camera_, point, size_);
  if (!pixel) return std::nullopt;
  return Point2{where_.x + static_cast<float>(pixel->x()) / pixels_per_unit_,
                where_.y + static_cast<float>(pixel->y()) / pixels_per_unit_};
}

Vec<2> GlView::to_view_pixel(Point2 window) const {
  return {static_cast<double>((window.x - where_.x) * pixels_per_unit_),
          static_cast<double>((window.y - where_.y) * pixels_per_unit_)};
}

ViewMouse GlView::mouse_now(const AppContext& context, bool pick) const {
  const ImGuiIO& io = ImGui::GetIO();
  ViewMouse m;
  m.dimension = dimension_;
  m.pixel = {io.MousePos.x, io.MousePos.y};
  m.shift = io.KeyShift;
  m.ctrl = io.KeyCtrl;
  m.alt = io.KeyAlt;
  const Vec<2> pixel = to_view_pixel(m.pixel);
  if (const auto* flat = std::get_if<Camera2D>(&camera_)) {
    m.origin = flat->to_world(pixel, size_);
    m.metres_per_pixel = pixels_per_unit_ / flat->pixels_per_metre;
  } else {
    const auto& orbit = std::get<OrbitCamera>(camera_);
    m.origin = orbit.eye();
    m.direction = orbit.ray(pixel, size_);
    m.forward = orbit.forward();
    m.metres_per_pixel = pixels_per_unit_ / orbit.pixels_per_metre(size_);
  }
  if (pick && context.snapshot)
    m.particle = pick_particle(*context.snapshot, camera_, size_, pixel, 6.0 * static_cast<double>(pixels_per_unit_));
  return m;
}

void GlView::begin_run(AppContext& context) {
  cancel_tool(context);
  renderer_.forget_range();
  shown_.reset();
}

void GlView::cancel_tool(AppContext& context) {
  if (!tools_.empty()) tools_[tool_]->cancel(context);
  held_ = false;
  if (drag_ == Drag::tool) drag_ = Drag::none;
}

void GlView::choose_tool(AppContext& context) {
  for (std::size_t k = 0; k < tools().size(); ++k) {
    if (context.tool != tools()[k].key || k == tool_) continue;
    cancel_tool(context);
    tool_ = k;
  }
}

void GlView::handle_mouse(AppContext& context) {
  choose_tool(context);
  const ImGuiIO& io = ImGui::GetIO();
  if (drag_ != Drag::none) handle_hold(context);
  const bool over = where_.contains(io.MousePos.x, io.MousePos.y) && !io.WantCaptureMouse;
  if (drag_ == Drag::none && over && context.snapshot) handle_press(context);
  if (io.MouseWheel != 0 && (over || held_)) handle_wheel(context, io.MouseWheel);
}

void GlView::handle_press(AppContext& context) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool left = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  const bool middle = ImGui::IsMouseClicked(ImGuiMouseButton_Middle);
  const bool right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (!left && !middle && !right) return;
  pressed_at_ = {io.MousePos.x, io.MousePos.y};
  moved_ = false;
  const bool flat = dimension_ == 2;
  if (left) {
    held_ = !tools_.empty() && !comparing(context) && tools_[tool_]->press(mouse_now(context, true), context);
    // Beside the material the left button moves the camera, as laptops have no middle one.
    drag_ = held_ ? Drag::tool : flat || io.KeyShift ? Drag::pan : Drag::orbit;
  } else {
    drag_ = flat || middle || io.KeyShift ? Drag::pan : Drag::orbit;
  }
}

void GlView::handle_hold(AppContext& context) {
  const ImGuiIO& io = ImGui::GetIO();
  moved_ |= std::hypot(io.MousePos.x - pressed_at_.x, io.MousePos.y - pressed_at_.y) > click_slop;
  const bool down = io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2];
  if (drag_ == Drag::tool) {
    Tool& tool = *tools_[tool_];
    if (io.MouseDown[0]) return tool.drag(mouse_now(context, false), context);
    tool.release(mouse_now(context, false), context);
    held_ = false;
    if (!moved_) tool.click(mouse_now(context, true), context);
    drag_ = Drag::none;
    return;
  }
  if (down) return handle_camera();
  drag_ = Drag::none;
  if (moved_ || !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
  if (comparing(context))
    select_in_lane(context);
  else if (!tools_.empty())
    tools_[tool_]->click(mouse_now(context, true), context);
}

void GlView::select_in_lane(AppContext& context) const {
  const CompareDesk& desk = *context.compare;
  if (!desk.frame || desk.under_mouse >= desk.frame->lanes.size()) return;
  const auto& snapshot = desk.frame->lanes[desk.under_mouse].snapshot;
  if (!snapshot) return;
  const ImVec2 at = ImGui::GetIO().MousePos;
  const auto particle = pick_particle(*snapshot, camera_, size_, to_view_pixel({at.x, at.y}),
                                      6.0 * static_cast<double>(pixels_per_unit_));
  context.selected_particle.reset();
  if (particle) context.selected_particle = snapshot->id[*particle];
}

void GlView::handle_camera() {
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  if (!moved_ || (delta.x == 0 && delta.y == 0)) return;
  const Vec<2> pixels{static_cast<double>(delta.x * pixels_per_unit_), static_cast<double>(delta.y * pixels_per_unit_)};
  if (auto* flat = std::get_if<Camera2D>(&camera_)) {
    flat->pan(pixels);
    follow_size_ = false;
  } else if (auto& orbit = std::get<OrbitCamera>(camera_); drag_ == Drag::orbit) {
    orbit.rotate(-radians_per_pixel * static_cast<double>(delta.x), radians_per_pixel * static_cast<double>(delta.y));
    follow_size_ = false;
  } else {
    orbit.pan(pixels, size_);
    follow_size_ = false;
  }
}

void GlView::handle_wheel(AppContext& context, float notches) {
  if (held_ && tools_[tool_]->wheel(notches, mouse_now(context, false), context)) return;
  const double factor = std::pow(zoom_a_notch, static_cast<double>(notches));
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (auto* flat = std::get_if<Camera2D>(&camera_))
    flat->zoom(factor, to_view_pixel({at.x, at.y}), size_);
  else
    std::get<OrbitCamera>(camera_).zoom(factor);
  follow_size_ = false;
}

void GlView::draw_overlay(AppContext& context, ImDrawList& list) {
  if (!context.snapshot || where_.empty()) return;
  const RenderOptions options = render_options(context, pixels_per_unit_ * overlay_scale());
  const float scale = overlay_scale();
  ImGuiPainter scaled(list, scale);
  OverlayInfo info = OverlayInfo::of(*context.snapshot, renderer_, options, camera_, size_);
  info.clock = context.view.hide_panels;  // else the bar below has it
  // In a low view there is no room for what the tool in hand offers and for the legend.
  if (where_.height < lowest_with_lying_legend * scale && tool() != nullptr && tool()->has_options())
    info.color_bar = false;
  if (context.view.show_histogram) info.histogram = counts(context, info);
  if (context.slow) {
    info.force_metres_per_newton = slow_force_scale(*context.slow);
    info.force_color = mark_red;
  }
  const Point2 low{where_.x / scale, where_.y / scale}, high{where_.right() / scale, where_.bottom() / scale};
  pf::draw_overlay(info, options.theme, scaled, low, high);
  color_bar_.draw(context, info, low, high, scale, list);
  draw_tool(context, list);
}

void GlView::draw_tool(AppContext& context, ImDrawList& list) {
  if (tools_.empty() || ((drag_ == Drag::pan || drag_ == Drag::orbit) && moved_)) return;
  const ImGuiIO& io = ImGui::GetIO();
  const bool over = where_.contains(io.MousePos.x, io.MousePos.y) && !io.WantCaptureMouse;
  const bool inside_hovers = context.view.show_shapes && over && dimension_ == 3;
  const ViewMouse mouse = mouse_now(context, inside_hovers);
  ImGuiPainter painter(list);
  painter.push_clip({where_.x, where_.y}, {where_.right(), where_.bottom()});
  const CameraMap map(*this);
  draw_selection(painter, map, context);
  draw_probes(painter, map, context);
  draw_inside(painter, map, over ? &mouse : nullptr, context);
  tools_[tool_]->draw(painter, map, over || held_ ? &mouse : nullptr, context);
  painter.pop_clip();
}

}  // namespace pf::app
