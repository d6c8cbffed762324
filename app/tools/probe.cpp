// Probe: a click on the material follows the particle there; the drawer plots what it goes through.
#include <cmath>

#include "app/outline/items.hpp"
#include "app/theme.hpp"
#include "app/tools/edit_tools.hpp"
#include "app/tools/tool.hpp"

namespace pf::app {

namespace {

class ProbeTool final : public Tool {
 public:
  bool press(const ViewMouse& mouse, AppContext& context) override {
    held_ = probe_at(mouse, context) || particle(mouse, context);
    return held_;
  }
  void drag(const ViewMouse&, AppContext&) override {}
  void release(const ViewMouse&, AppContext&) override { held_ = false; }
  bool wheel(float, const ViewMouse&, AppContext&) override { return false; }
  void cancel(AppContext&) override { held_ = false; }

  void click(const ViewMouse& mouse, AppContext& context) override {
    if (const auto probe = probe_at(mouse, context)) {
      context.selected_item = SceneItem{ItemKind::probe, *probe};
      context.show_plot("Probes");
      return;
    }
    const auto p = particle(mouse, context);
    if (!p) return;
    std::vector<Edit> edits = added(context.scene, ItemKind::probe);
    const auto d = static_cast<std::size_t>(context.scene.dimension);
    nlohmann::json at = nlohmann::json::array();
    for (std::size_t a = 0; a < d; ++a) at.push_back(context.snapshot->X[d * *p + a]);
    edits.back().value["at"] = at;
    if (!edit_scene(context, edits)) return;
    context.selected_item = SceneItem{ItemKind::probe, context.scene.probes.size() - 1};
    context.show_plot("Probes");
  }

  void draw(Painter&, const ViewMap&, const ViewMouse*, const AppContext&) override {}

 private:
  /// Index into the snapshot; nothing beside the material, or while its reference positions are still on their way.
  static std::optional<std::size_t> particle(const ViewMouse& mouse, const AppContext& context) {
    if (!context.snapshot || context.snapshot->X.size() != context.snapshot->x.size()) return std::nullopt;
    const Snapshot& s = *context.snapshot;
    if (mouse.particle && *mouse.particle < s.particles) return mouse.particle;
    if (mouse.dimension == 3) return std::nullopt;
    std::optional<std::size_t> nearest;  // between particles is material, too
    double best = 0.75 * s.spacing;
    for (std::size_t p = 0; p < s.particles; ++p) {
      const double away = std::hypot(s.x[2 * p] - mouse.origin.x(), s.x[2 * p + 1] - mouse.origin.y());
      if (!(away < best)) continue;
      best = away;
      nearest = p;
    }
    return nearest;
  }
  /// The probe under the mouse.
  static std::optional<std::size_t> probe_at(const ViewMouse& mouse, const AppContext& context) {
    if (!context.snapshot) return std::nullopt;
    const double reach = std::max(0.35 * context.snapshot->spacing, 6 * mouse.metres_per_pixel);
    for (const ProbeReading& reading : context.snapshot->probes)
      if (reading.probe < context.scene.probes.size() && (mouse.on_plane(reading.x) - reading.x).norm() < reach)
        return reading.probe;
    return std::nullopt;
  }

  bool held_ = false;
};

}  // namespace

std::unique_ptr<Tool> make_probe_tool() {
  return std::make_unique<ProbeTool>();
}

}  // namespace pf::app
