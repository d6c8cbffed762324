// Cut: what the brush goes over is taken out of the running simulation; the balance says what went with it.
#include <imgui.h>

#include "app/tools/edit_tools.hpp"
#include "app/tools/strokes.hpp"
#include "app/tools/sweep.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

constexpr Color red{1, 0.36F, 0.3F, 0.95F};

class CutTool final : public Tool {
 public:
  bool press(const ViewMouse& mouse, AppContext& context) override {
    if (!context.snapshot) return false;
    // In 3D a drag beside the material turns the camera.
    const auto at = mouse.dimension == 2 ? std::optional<Vec3>(mouse.origin) : touched(mouse, context);
    if (!at) return false;
    near_ = *at;
    ++gesture_;
    last_ = mouse;
    send(mouse, context);
    return true;
  }
  void drag(const ViewMouse& mouse, AppContext& context) override {
    if (!last_ || !context.snapshot) return;
    const double way = (mouse.on_plane(near_) - last_->on_plane(near_)).norm();
    if (way > 0.25 * brush_.radius(*context.snapshot)) send(mouse, context);
  }
  void release(const ViewMouse& mouse, AppContext& context) override {
    if (last_ && context.snapshot && mouse.on_plane(near_) != last_->on_plane(near_)) send(mouse, context);
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
    brush_.draw_size();
    const StrokeSums* sums = context.snapshot ? &context.snapshot->report.strokes : nullptr;
    if (sums == nullptr || sums->cut == 0) return;
    muted("Taken away: " + quantity(sums->mass, "kg", 3) + ", " + quantity(sums->energy, "J", 3));
    if (context.status.stroke_is_newest && text_button("Take back the last stroke")) context.undo();
  }

  void draw(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context) override {
    if (!context.snapshot || mouse == nullptr) return;
    if (mouse->dimension == 2 || last_)
      brush_.draw(painter, map, *context.snapshot, mouse->on_plane(near_), last_ ? 1 : 0.75F, red);
  }

 private:
  void send(const ViewMouse& mouse, AppContext& context) {
    const double radius = brush_.radius(*context.snapshot);
    const Shape shape = mouse.dimension == 2 ? swept_balls(last_->origin, mouse.origin, radius)
                                             : swept_rays(*last_, mouse, near_, radius, *context.snapshot);
    context.session.stroke({"cut", shape, ""}, gesture_);
    last_ = mouse;
  }

  std::optional<ViewMouse> last_;  ///< while a stroke is under way: up to here it is done
  Vec3 near_ = Vec3::Zero();       ///< where it began
  std::uint64_t gesture_ = 0;
  Brush brush_{1};
};

}  // namespace

std::unique_ptr<Tool> make_cut_tool() {
  return std::make_unique<CutTool>();
}

}  // namespace pf::app
