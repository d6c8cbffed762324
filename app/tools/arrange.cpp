// Arrange: select a thing of the scene in the view; drag it, turn it by the round knob, scale it by the square one.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/outline/items.hpp"
#include "app/outline/outlines.hpp"
#include "app/tools/edit_tools.hpp"
#include "app/widgets/units.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

namespace {

constexpr float slop = 3;  ///< pixels that a press may move and still be a click
constexpr double degrees = 180 / std::numbers::pi;
constexpr double turn_snap = 15, scale_snap = 0.1;  ///< [degrees], of the whole

double distance(Point2 a, Point2 b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y));
}

class ArrangeTool final : public Tool {
 public:
  bool press(const ViewMouse& mouse, AppContext& context) override {
    moved_ = false;
    if (!context.selected_item || !item_shape(context.scene, *context.selected_item)) select(mouse, context);
    grip_ = grip_at(mouse, context);
    if (grip_ == Grip::none) {
      select(mouse, context);
      grip_ = grip_at(mouse, context);
    }
    if (grip_ == Grip::none) return false;  // the camera's
    item_ = *context.selected_item;
    shape_ = before_ = *item_shape(context.scene, item_);
    from_ = mouse.on_plane(around(before_, context.scene).centre);
    pressed_at_ = mouse.pixel;
    return true;
  }

  void drag(const ViewMouse& mouse, AppContext& context) override {
    if (grip_ == Grip::none) return;
    moved_ |= distance(mouse.pixel, pressed_at_) > static_cast<double>(slop);
    if (!moved_) return;
    shape_ = before_;
    const Around middle = around(before_, context.scene);
    const Vec3 to = mouse.on_plane(middle.centre);
    if (grip_ == Grip::move) move(to - from_, mouse, context);
    if (grip_ == Grip::turn) turn(middle.centre, to, mouse);
    if (grip_ == Grip::scale) scale(middle.centre, to, mouse);
  }

  void release(const ViewMouse&, AppContext& context) override {
    if (moved_ && grip_ != Grip::none && !(shape_ == before_)) put(context);
    grip_ = Grip::none;
  }

  void click(const ViewMouse& mouse, AppContext& context) override { select(mouse, context); }
  bool wheel(float, const ViewMouse&, AppContext&) override { return false; }
  void cancel(AppContext&) override { grip_ = Grip::none; }

  void draw(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) override {
    em_ = map.em();
    if (!context.selected_item) return;
    const Shape* shape = item_shape(context.scene, *context.selected_item);
    if (!shape) return;
    const bool held = grip_ != Grip::none && moved_ && item_ == *context.selected_item;
    const Shape& shown = held ? shape_ : *shape;
    knobs_ = knobs_of(shown, map, context.scene);
    if (held)
      draw_lines(painter, map, shape_lines(shape_, context.scene, 1e3 * context.scene.grid.spacing), {1, 1, 1, 1});
    if (!knobs_) return;
    const float em = map.em();
    painter.ring(knobs_->centre, knobs_->radius, {0, 0, 0, 0.4F}, 0.16F * em);
    painter.ring(knobs_->centre, knobs_->radius, {1, 1, 1, 0.8F}, 0.08F * em);
    knob(painter, knobs_->turn, true, mouse && over(*mouse, knobs_->turn));
    knob(painter, knobs_->scale, false, mouse && over(*mouse, knobs_->scale));
    if (held && mouse) label(painter, mouse->pixel, told_);
  }

 private:
  enum class Grip { none, move, turn, scale };
  struct Knobs {
    Point2 centre, turn, scale;
    float radius;
  };

  bool over(const ViewMouse& mouse, Point2 at) const {
    return distance(mouse.pixel, at) < 0.7 * static_cast<double>(em_);
  }

  static std::optional<Knobs> knobs_of(const Shape& shape, const ViewMap& map, const Scene& scene) {
    const Around middle = around(shape, scene);
    const auto c = map.to_pixel(middle.centre);
    if (!c) return std::nullopt;
    const auto r = static_cast<float>(middle.radius / map.metres_per_pixel(middle.centre)) + 0.8F * map.em();
    const float s = r * std::numbers::sqrt2_v<float> / 2;
    return Knobs{*c, {c->x, c->y - r}, {c->x + s, c->y + s}, r};
  }

  void knob(Painter& painter, Point2 at, bool round, bool hot) const {
    const float r = (hot ? 0.48F : 0.38F) * em_, i = 0.65F * r;
    if (round) {
      painter.circle(at, r, {0, 0, 0, 0.6F});
      painter.circle(at, i, {1, 1, 1, 1});
    } else {
      painter.rectangle({at.x - r, at.y - r}, {at.x + r, at.y + r}, {0, 0, 0, 0.6F}, 0.1F * em_);
      painter.rectangle({at.x - i, at.y - i}, {at.x + i, at.y + i}, {1, 1, 1, 1}, 0.1F * em_);
    }
  }

  void label(Painter& painter, Point2 cursor, const std::string& text) const {
    if (text.empty()) return;
    const float pad = 0.35F * em_, width = painter.text_width(text, em_);
    const Point2 low{cursor.x + 1.2F * em_, cursor.y - 1.7F * em_};
    painter.rectangle(low, {low.x + width + 2 * pad, low.y + em_ + 2 * pad}, {0, 0, 0, 0.72F}, 0.25F * em_);
    painter.text({low.x + pad, low.y + pad + 0.8F * em_}, text, em_, {1, 1, 1, 1});
  }

  Grip grip_at(const ViewMouse& mouse, const AppContext& context) const {
    if (!context.selected_item) return Grip::none;
    const Shape* shape = item_shape(context.scene, *context.selected_item);
    if (!shape) return Grip::none;
    if (knobs_ && over(mouse, knobs_->turn)) return Grip::turn;
    if (knobs_ && over(mouse, knobs_->scale)) return Grip::scale;
    return holds(*shape, mouse, context) ? Grip::move : Grip::none;
  }

  /// Whether the mouse is over the shape where it stands at t = 0, or in 3D over the ball about it, or over its body.
  static bool holds(const Shape& shape, const ViewMouse& mouse, const AppContext& context) {
    const Scene& scene = context.scene;
    const double reach = 4 * mouse.metres_per_pixel;
    if (scene.dimension == 2) {
      const double d = make_solid(shape, 2, scene.constants)->distance(mouse.origin);
      return shape.type == "half_space" ? std::abs(d) < 2 * reach : d < reach;
    }
    const Around middle = around(shape, scene);
    return (mouse.on_plane(middle.centre) - middle.centre).norm() < middle.radius;
  }

  static void select(const ViewMouse& mouse, AppContext& context) {
    const Scene& scene = context.scene;
    context.selected_item.reset();
    // What is small and lies over others first: loads, supports, then bodies, then walls.
    for (const ItemKind kind : {ItemKind::body, ItemKind::load, ItemKind::constraint, ItemKind::boundary}) {
      const bool body = kind == ItemKind::body;
      if (body && context.snapshot && mouse.particle && *mouse.particle < context.snapshot->body.size()) {
        context.selected_item = SceneItem{kind, context.snapshot->body[*mouse.particle]};
        return;
      }
      if (scene.dimension == 3 && kind == ItemKind::boundary) continue;
      for (std::size_t i = 0; i < group_of(kind).count(scene); ++i)
        if (holds(*item_shape(scene, {kind, i}), mouse, context)) {
          context.selected_item = SceneItem{kind, i};
          return;
        }
    }
  }

  void move(const Vec3& by, const ViewMouse& mouse, const AppContext& context) {
    const Vec3 step = mouse.ctrl ? by : snapped(by, context.scene.grid.spacing / 2);
    shape_.translate = before_.translate + step;
    if (context.scene.dimension == 2) shape_.translate.z() = 0;
    told_ = quantity(step.x(), "m", 3) + ", " + quantity(step.y(), "m", 3);
    if (context.scene.dimension == 3) told_ += ", " + quantity(step.z(), "m", 3);
  }

  void turn(const Vec3& centre, const Vec3& to, const ViewMouse& mouse) {
    const Vec3 axis = -mouse.forward;
    const Vec3 a = (from_ - centre), b = (to - centre);
    double angle = std::atan2(axis.dot(a.cross(b)), a.dot(b)) * degrees;
    if (!mouse.ctrl) angle = turn_snap * std::round(angle / turn_snap);
    if (mouse.dimension == 2) {
      shape_.rotate_degrees = before_.rotate_degrees + angle;
    } else {
      const Eigen::AngleAxisd whole(
          Eigen::AngleAxisd(angle / degrees, axis) *
          Eigen::AngleAxisd(before_.rotate_degrees / degrees, before_.rotate_axis.normalized()));
      shape_.rotate_axis = whole.axis();
      shape_.rotate_degrees = whole.angle() * degrees;
    }
    told_ = quantity(angle, "", 3) + "\u00b0";
  }

  void scale(const Vec3& centre, const Vec3& to, const ViewMouse& mouse) {
    double factor = before_.scale * (to - centre).norm() / std::max((from_ - centre).norm(), 1e-12);
    if (!mouse.ctrl) factor = scale_snap * std::round(factor / scale_snap);
    shape_.scale = std::max(factor, mouse.ctrl ? 0.01 : scale_snap);
    told_ = "\u00d7 " + quantity(shape_.scale, "", 3);
  }

  void put(AppContext& context) {
    const std::string at = item_pointer(context.scene, item_) + "/" + group_of(item_.kind).shape;
    const int d = context.scene.dimension;
    nlohmann::json translate = nlohmann::json::array();
    for (int k = 0; k < d; ++k) translate.push_back(shape_.translate[k]);
    nlohmann::json turned = shape_.rotate_degrees;
    if (d == 3)
      turned = {{"axis", {shape_.rotate_axis.x(), shape_.rotate_axis.y(), shape_.rotate_axis.z()}},
                {"angle", shape_.rotate_degrees}};
    std::vector<Edit> edits;
    if (shape_.translate != before_.translate) edits.push_back({at + "/translate", translate});
    if (shape_.scale != before_.scale) edits.push_back({at + "/scale", shape_.scale});
    if (shape_.rotate_degrees != before_.rotate_degrees || shape_.rotate_axis != before_.rotate_axis)
      edits.push_back({at + "/rotate", turned});
    edit_scene(context, edits);
  }

  Grip grip_ = Grip::none;
  bool moved_ = false;
  SceneItem item_;
  Shape before_, shape_;
  Vec3 from_ = Vec3::Zero();
  Point2 pressed_at_;
  std::string told_;
  std::optional<Knobs> knobs_;  ///< as drawn last
  float em_ = 15;
};

}  // namespace

std::unique_ptr<Tool> make_arrange_tool() {
  return std::make_unique<ArrangeTool>();
}

}  // namespace pf::app
