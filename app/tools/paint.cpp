// Paint: what the brush goes over becomes another material of the scene, deformed as it is.
#include <imgui.h>

#include "app/outline/items.hpp"
#include "app/tools/edit_tools.hpp"
#include "app/tools/strokes.hpp"
#include "app/tools/sweep.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/charts/colormap.hpp"

namespace pf::app {

namespace {

class PaintTool final : public Tool {
 public:
  bool press(const ViewMouse& mouse, AppContext& context) override {
    if (!context.snapshot || context.scene.materials.size() < 2) return false;
    const auto at = place(mouse, context);
    if (!at) return false;
    if (context.view.field != Field::material) {
      context.view.field = Field::material;
      context.notify("Coloured by material, so that what is painted shows.");
    }
    ++gesture_;
    last_ = at;
    send(*at, context);
    return true;
  }
  void drag(const ViewMouse& mouse, AppContext& context) override {
    if (!last_ || !context.snapshot) return;
    const auto at = place(mouse, context);
    if (at && (*at - *last_).norm() > 0.25 * brush_.radius(*context.snapshot)) send(*at, context);
  }
  void release(const ViewMouse& mouse, AppContext& context) override {
    if (last_ && context.snapshot)
      if (const auto at = place(mouse, context); at && *at != *last_) send(*at, context);
    last_.reset();
  }
  void click(const ViewMouse&, AppContext&) override {}
  bool wheel(float notches, const ViewMouse&, AppContext&) override {
    if (last_) brush_.turn(notches);
    return last_.has_value();
  }
  void cancel(AppContext&) override { last_.reset(); }

  bool has_options() const override { return true; }
  void draw_options(AppContext& context) override {
    const auto& materials = context.scene.materials;
    if (materials.size() < 2) {
      muted("This scene has one material only.");
      if (text_button("Add another")) edit_scene(context, added(context.scene, ItemKind::material));
      return;
    }
    const std::size_t now = chosen(context);
    swatch(now, ImGui::GetFrameHeight());
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (ImGui::BeginCombo("##material", materials[now].name.c_str())) {
      for (std::size_t k = 0; k < materials.size(); ++k) {
        swatch(k, ImGui::GetTextLineHeight());
        if (ImGui::Selectable(materials[k].name.c_str(), now == k)) material_ = materials[k].name;
      }
      ImGui::EndCombo();
    }
    brush_.draw_size();
    const StrokeSums* sums = context.snapshot ? &context.snapshot->report.strokes : nullptr;
    if (sums == nullptr || sums->painted == 0) return;
    if (context.status.stroke_is_newest && text_button("Take back the last stroke")) context.undo();
  }

  void draw(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) override {
    if (!context.snapshot || mouse == nullptr || context.scene.materials.size() < 2) return;
    const Color color = categorical_color(chosen(context));
    if (mouse->dimension == 2)
      brush_.draw(painter, map, *context.snapshot, mouse->origin, last_ ? 1 : 0.75F, color);
    else if (last_)
      brush_.draw(painter, map, *context.snapshot, *last_, 1, color);
  }

 private:
  /// The material's colour, at the left of a line that is so high.
  static void swatch(std::size_t material, float height) {
    const Color c = categorical_color(material);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = 0.9F * ImGui::GetFontSize(), y = at.y + (height - side) / 2;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + side, y + side},
                                              ImGui::GetColorU32({c.r, c.g, c.b, 1}), 0.2F * side);
    ImGui::Dummy({side, height});
    ImGui::SameLine();
  }
  /// Index of the material to paint with: until one is chosen, the one that is selected, or the second.
  std::size_t chosen(const AppContext& context) const {
    const auto& materials = context.scene.materials;
    for (std::size_t k = 0; k < materials.size(); ++k)
      if (materials[k].name == material_) return k;
    const auto& item = context.selected_item;
    return item && item->kind == ItemKind::material && item->index < materials.size() ? item->index : 1;
  }
  /// In 2D the mouse, wherever it is once a stroke is under way; in 3D the surface under it.
  std::optional<Vec3> place(const ViewMouse& mouse, const AppContext& context) const {
    if (mouse.dimension == 2) return last_ ? mouse.origin : touched(mouse, context);
    return met_first(mouse, *context.snapshot, 0.6 * context.snapshot->spacing);
  }
  void send(const Vec3& at, AppContext& context) {
    const double radius = brush_.radius(*context.snapshot);
    // Over a gap, or round an edge, there is nothing between two places of a surface.
    const bool leaps = context.scene.dimension == 3 && (at - *last_).norm() > 4 * radius;
    const Shape shape = swept_balls(leaps ? at : *last_, at, radius);
    context.session.stroke({"paint", shape, context.scene.materials[chosen(context)].name}, gesture_);
    last_ = at;
  }

  std::optional<Vec3> last_;  ///< while a stroke is under way: up to here it is done
  std::string material_;      ///< as it was chosen; "": not yet
  std::uint64_t gesture_ = 0;
  Brush brush_{1.5};
};

}  // namespace

std::unique_ptr<Tool> make_paint_tool() {
  return std::make_unique<PaintTool>();
}

}  // namespace pf::app
