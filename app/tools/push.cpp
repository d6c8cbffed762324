// Push: a rigid ball follows the mouse. It is a wall of the running scene alone: the scene that is edited never has
// it, but what it does is among the live changes of the run, which replay.
#include <algorithm>

#include "app/tools/edit_tools.hpp"
#include "app/tools/strokes.hpp"
#include "core/params/problem.hpp"
#include "core/scene/scene_io.hpp"

namespace pf::app {

namespace {

class PushTool final : public Tool {
 public:
  bool press(const ViewMouse& mouse, AppContext& context) override {
    if (!context.snapshot) return false;
    const Bounds all = middle(*context.snapshot);
    const auto at = touched(mouse, context);
    from_ = at ? *at : mouse.on_plane((all.min + all.max) / 2);
    to_ = from_;
    const nlohmann::json wall{{"shape", ball_json(from_, brush_.radius(*context.snapshot), context.scene.dimension)},
                              {"contact", "separate"}};
    try {
      pushing_ = edited(context.scene, std::vector<Edit>{{"/boundaries/-", wall}});
    } catch (const InputError&) {
      context.notify("This scene has as many walls as there can be.");
      return false;
    }
    velocity_ = Vec3::Zero();
    held_ = true;
    context.session.edit(pushing_);
    return true;
  }

  void drag(const ViewMouse& mouse, AppContext& context) override {
    if (!held_ || !context.snapshot) return;
    to_ = mouse.on_plane(from_);
    // After the mouse, as fast as half a cell a step.
    const double dt = context.scene.time.step, slack = std::max(3 * dt, 0.03);
    const double fastest = 0.5 * context.snapshot->spacing / dt;
    Vec3 v = (to_ - centre(*context.snapshot)) / slack;
    if (v.norm() > fastest) v *= fastest / v.norm();
    if ((v - velocity_).norm() <= 1e-3 * fastest && v.norm() > 0) return;
    velocity_ = v;
    FormulaVector& formulas = pushing_.boundaries.back().velocity;
    for (std::size_t a = 0; a < formulas.size(); ++a) formulas[a] = {v[static_cast<int>(a)], ""};
    context.session.edit(pushing_);
  }

  void release(const ViewMouse&, AppContext& context) override { cancel(context); }
  void click(const ViewMouse&, AppContext&) override {}
  bool wheel(float notches, const ViewMouse&, AppContext&) override {
    if (held_) brush_.turn(notches);  // of the next ball: this one is as hard as a wall
    return held_;
  }
  void cancel(AppContext& context) override {
    if (held_) context.session.edit(context.scene);
    held_ = false;
  }

  void draw(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) override {
    if (!context.snapshot) return;
    if (!held_) {
      if (mouse && mouse->dimension == 2) brush_.draw(painter, map, *context.snapshot, mouse->origin, 0.55F);
      return;
    }
    const Vec3 now = centre(*context.snapshot);
    brush_.draw(painter, map, *context.snapshot, now, 1);
    const auto a = map.to_pixel(now), b = map.to_pixel(to_);
    if (!a || !b) return;
    const std::array way{*a, *b};
    painter.polyline(way, {1, 1, 1, 0.8F}, 0.1F * map.em(), 0.3F * map.em());
  }

 private:
  struct Bounds {
    Vec3 min, max;
  };
  static Bounds middle(const Snapshot& s) {
    Bounds b{Vec3::Zero(), Vec3::Zero()};
    const auto d = static_cast<std::size_t>(s.dimension);
    for (std::size_t p = 0; p < s.particles; ++p)
      for (std::size_t a = 0; a < d; ++a) {
        const int k = static_cast<int>(a);
        const double x = s.x[d * p + a];
        b.min[k] = p == 0 ? x : std::min(b.min[k], x);
        b.max[k] = p == 0 ? x : std::max(b.max[k], x);
      }
    return b;
  }
  Vec3 centre(const Snapshot& s) const {
    const std::size_t ball = pushing_.boundaries.size() - 1;
    return s.boundary_displacement.size() > ball ? Vec3(from_ + s.boundary_displacement[ball]) : from_;
  }

  bool held_ = false;
  Scene pushing_;  ///< the scene with the ball
  Vec3 from_ = Vec3::Zero(), to_ = Vec3::Zero(), velocity_ = Vec3::Zero();
  Brush brush_{3};
};

}  // namespace

std::unique_ptr<Tool> make_push_tool() {
  return std::make_unique<PushTool>();
}

}  // namespace pf::app
