// Time: the step, how it is taken, and how it compares with what an explicit method could do.
#include "app/panels/limits.hpp"
#include "app/panels/panels.hpp"
#include "app/widgets/setting_widget.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

void compare_with_explicit(const Scene& scene) {
  if (scene.time.control == "adaptive") return;  // the strip under the time line says what is taken
  const auto limit = explicit_limit(scene);
  if (!limit) return;
  const double ratio = scene.time.step / *limit;
  const bool explicit_step = scene.integrator.type == "symplectic_euler";
  property("Step / explicit limit", quantity(ratio, "", 3));
  tooltip("c dt / dx: how many cells a pressure wave crosses in one step. Explicit steps are stable up to about 1.");
  if (explicit_step && ratio > 1)
    warning("Longer than an explicit step may be: expect it to blow up. Stay below " + quantity(*limit, "s", 2) + ".");
  else if (explicit_step)
    muted("Within the explicit limit of about " + quantity(*limit, "s", 2) + ".");
  else if (ratio > 1)
    muted("An explicit method would need " + quantity(ratio, "", 2) + " times as many steps.");
  else
    muted("An explicit step would be stable here, and cheaper.");
  gap();
}

}  // namespace

void draw_time_panel(AppContext& context) {
  setting_widget(context, "/time/step");
  compare_with_explicit(context.scene);
  setting_widget(context, "/integrator/type");
  setting_widget(context, "/integrator/spectral_radius");
  setting_widget(context, "/time/control");
  setting_widget(context, "/time/tolerance");
  setting_widget(context, "/time/end");
  if (foldable("Advanced")) {
    setting_widget(context, "/time/frame");
    setting_widget(context, "/integrator/mass");
  }
}

}  // namespace pf::app
