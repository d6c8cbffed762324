// Pin: a click holds the grid nodes about it, and the material with them, until a click lets them go.
#include <string>

#include "app/outline/items.hpp"
#include "app/tools/edit_tools.hpp"
#include "app/tools/strokes.hpp"

namespace pf::app {

namespace {

bool is_pin(const Constraint& c) {
  return c.region.type == "ball" && std::all_of(c.fix.begin(), c.fix.end(), [](bool fixed) { return fixed; }) &&
         std::all_of(c.velocity.begin(), c.velocity.end(),
                     [](const Formula& f) { return f.is_number() && f.number == 0; });
}

class PinTool final : public Tool {
 public:
  bool press(const ViewMouse& mouse, AppContext& context) override {
    held_ = touched(mouse, context);
    return held_.has_value();
  }
  void drag(const ViewMouse&, AppContext&) override {}
  void release(const ViewMouse&, AppContext&) override { held_.reset(); }

  void click(const ViewMouse& mouse, AppContext& context) override {
    if (!context.snapshot) return;
    if (const auto pin = pin_at(mouse, context)) {
      edit_scene(context, deleted(context.scene, {ItemKind::constraint, *pin}));
      return;
    }
    const auto at = touched(mouse, context);
    if (!at) return;
    const int d = context.scene.dimension;
    const nlohmann::json pin{{"region", ball_json(*at, brush_.radius(*context.snapshot), d)},
                             {"fix", nlohmann::json(std::vector<bool>(static_cast<std::size_t>(d), true))}};
    edit_scene(context, {{"/constraints/-", pin}});
  }

  bool wheel(float notches, const ViewMouse&, AppContext&) override {
    if (held_) brush_.turn(notches);
    return held_.has_value();
  }
  void cancel(AppContext&) override { held_.reset(); }

  void draw(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) override {
    if (!context.snapshot) return;
    for (const Constraint& c : context.scene.constraints)
      if (is_pin(c)) draw_head(painter, map, c.region.center + c.region.translate);
    if (held_)
      brush_.draw(painter, map, *context.snapshot, *held_, 1);
    else if (mouse && mouse->dimension == 2)
      brush_.draw(painter, map, *context.snapshot, mouse->origin, 0.55F);
  }

 private:
  static void draw_head(Painter& painter, const ViewMap& map, const Vec3& at) {
    const auto centre = map.to_pixel(at);
    if (!centre) return;
    painter.circle(*centre, 0.42F * map.em(), {0, 0, 0, 0.6F});
    painter.circle(*centre, 0.3F * map.em(), {1, 0.62F, 0.2F, 1});
  }

  /// The pin under the mouse, the newest first.
  static std::optional<std::size_t> pin_at(const ViewMouse& mouse, const AppContext& context) {
    const auto& all = context.scene.constraints;
    for (std::size_t k = all.size(); k-- > 0;) {
      if (!is_pin(all[k])) continue;
      const Vec3 centre = all[k].region.center + all[k].region.translate;
      if ((mouse.on_plane(centre) - centre).norm() < all[k].region.radius) return k;
    }
    return std::nullopt;
  }

  std::optional<Vec3> held_;
  Brush brush_{1.5};
};

}  // namespace

std::unique_ptr<Tool> make_pin_tool() {
  return std::make_unique<PinTool>();
}

}  // namespace pf::app
