// Draw: a box, a ball or a polygon becomes a body and enters the running simulation.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/outline/items.hpp"
#include "app/outline/outlines.hpp"
#include "app/tools/edit_tools.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

enum class Form { box, ball, polygon };

nlohmann::json array_of(const Vec3& v, int dimension) {
  nlohmann::json a = nlohmann::json::array();
  for (int k = 0; k < dimension; ++k) a.push_back(v[k]);
  return a;
}

class DrawTool final : public Tool {
 public:
  explicit DrawTool(Form form) : form_(form) {}

  bool press(const ViewMouse& mouse, AppContext& context) override {
    if (!context.snapshot) return false;
    to_ = at(mouse, context);
    if (form_ == Form::polygon) {
      if (mouse.dimension == 3) {
        context.notify("Polygons are drawn in 2D; in 3D draw a box or a ball.");
        return true;
      }
      corner(mouse, context);
    } else {
      from_ = to_;
      held_ = true;
    }
    return true;
  }

  void drag(const ViewMouse& mouse, AppContext& context) override { to_ = at(mouse, context); }

  void release(const ViewMouse&, AppContext& context) override {
    if (held_ && size() > 0) make(context);
    held_ = false;
  }

  void click(const ViewMouse&, AppContext&) override {}
  bool wheel(float, const ViewMouse&, AppContext&) override { return false; }
  void cancel(AppContext&) override {
    held_ = false;
    corners_.clear();
  }

  void draw(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) override {
    if (!context.snapshot) return;
    const float em = map.em();
    if (!held_ && mouse) to_ = at(*mouse, context);
    if (held_ && size() > 0) {
      Shape shape;
      shape.type = form_ == Form::box ? "box" : "ball";
      const auto [low, high] = corners();
      shape.min = low;
      shape.max = high;
      shape.center = from_;
      shape.radius = size();
      draw_lines(painter, map, shape_lines(shape, context.scene, 0), {1, 1, 1, 1});
    }
    if (!corners_.empty()) {
      std::vector<Vec3> line = corners_;
      if (mouse) line.push_back(to_);
      draw_lines(painter, map, {line}, {1, 1, 1, 1});
      if (const auto first = map.to_pixel(corners_.front()); first && corners_.size() > 2) {
        painter.ring(*first, 0.5F * em, {0, 0, 0, 0.6F}, 0.24F * em);
        painter.ring(*first, 0.5F * em, {1, 1, 1, 1}, 0.12F * em);
      }
    }
    // Where a press would begin: snapped, so it may be beside the mouse.
    if (mouse && !held_)
      if (const auto here = map.to_pixel(to_)) {
        painter.circle(*here, 0.24F * em, {0, 0, 0, 0.6F});
        painter.circle(*here, 0.15F * em, {1, 1, 1, 1});
      }
  }

 private:
  /// Half cells, unless Ctrl is held.
  static Vec3 at(const ViewMouse& mouse, const AppContext& context) {
    const Bounds all = bodies_bounds(context.scene);
    Vec3 p = mouse.on_plane((all.min + all.max) / 2);
    if (!mouse.ctrl) p = snapped(p, context.scene.grid.spacing / 2);
    if (mouse.dimension == 2) p.z() = 0;
    return p;
  }

  /// Radius, or the shorter side.
  double size() const {
    const Vec3 d = (to_ - from_).cwiseAbs();
    return form_ == Form::ball ? d.norm() : std::min(d.x(), d.y());
  }
  std::pair<Vec3, Vec3> corners() const {
    Vec3 low = from_.cwiseMin(to_), high = from_.cwiseMax(to_);
    const double depth = std::min(high.x() - low.x(), high.y() - low.y());
    low.z() = from_.z() - depth / 2;
    high.z() = from_.z() + depth / 2;
    return {low, high};
  }

  void make(AppContext& context) {
    const int d = context.scene.dimension;
    nlohmann::json shape{{"type", form_ == Form::box ? "box" : "ball"}};
    if (form_ == Form::box) {
      const auto [low, high] = corners();
      shape["min"] = array_of(low, d);
      shape["max"] = array_of(high, d);
    } else {
      shape["center"] = array_of(from_, d);
      shape["radius"] = size();
    }
    enter(shape, context);
  }

  void corner(const ViewMouse& mouse, AppContext& context) {
    const double near = 8 * mouse.metres_per_pixel;
    if (corners_.size() > 2 && (to_ - corners_.front()).norm() < std::max(near, 1e-9)) {
      nlohmann::json shape{{"type", "polygon"}, {"points", nlohmann::json::array()}};
      for (const Vec3& p : corners_) shape["points"].push_back(array_of(p, 2));
      corners_.clear();
      return enter(shape, context);
    }
    if (corners_.empty() || (to_ - corners_.back()).norm() > 0) corners_.push_back(to_);
  }

  static void enter(const nlohmann::json& shape, AppContext& context) {
    const Scene& scene = context.scene;
    std::string material = scene.materials.front().name;
    if (const auto& item = context.selected_item; item && exists(scene, *item)) {
      if (item->kind == ItemKind::material) material = scene.materials[item->index].name;
      if (item->kind == ItemKind::body) material = scene.bodies[item->index].material;
    }
    if (edit_scene(context, added_body(scene, shape, material)))
      context.selected_item = SceneItem{ItemKind::body, context.scene.bodies.size() - 1};
  }

  Form form_;
  bool held_ = false;
  Vec3 from_ = Vec3::Zero(), to_ = Vec3::Zero();
  std::vector<Vec3> corners_;
};

}  // namespace

std::unique_ptr<Tool> make_box_tool() {
  return std::make_unique<DrawTool>(Form::box);
}
std::unique_ptr<Tool> make_ball_tool() {
  return std::make_unique<DrawTool>(Form::ball);
}
std::unique_ptr<Tool> make_polygon_tool() {
  return std::make_unique<DrawTool>(Form::polygon);
}

}  // namespace pf::app
