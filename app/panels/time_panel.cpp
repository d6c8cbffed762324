// Time: the step, how it is taken, and how it compares with what an explicit method could do.
#include <cmath>

#include "app/panels/limits.hpp"
#include "app/panels/memory.hpp"
#include "app/panels/panels.hpp"
#include "app/widgets/setting_widget.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"

namespace pf::app {

namespace {

void compare_with_explicit(const Scene& scene, const Snapshot* snapshot) {
  if (scene.time.control == "adaptive") return;  // the strip under the time line says what is taken
  // The state's own, where it is known; until then that of the undeformed material.
  const bool known = snapshot && snapshot->stable_step > 0 && std::isfinite(snapshot->stable_step);
  const auto limit = known ? std::optional(snapshot->stable_step) : explicit_limit(scene);
  if (!limit) return;
  const double ratio = scene.time.step / *limit;
  const bool explicit_step = scene.integrator.type == "symplectic_euler";
  property("Step / explicit limit", quantity(ratio, "", 3));
  tooltip(
      known
          ? "Time step over 2 / w_max, w_max the grid's highest frequency as it stands: explicit steps are stable up "
            "to "
            "about 1. Worked out anew every 50 steps."
          : "c dt / dx: how many cells a pressure wave crosses in one step. Explicit steps are stable up to about 1.");
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

/// Of the newest step: how far particles went, and whether its equations are solved.
void judge_step(const AppContext& context) {
  const Snapshot* const snapshot = context.snapshot.get();
  if (!snapshot || snapshot->report.step == 0) return;
  const StepReport& report = snapshot->report;
  property("CFL number", quantity(report.cfl, "", 2));
  tooltip(
      "v dt / dx: how many cells the fastest particle crossed in the last step. Beyond about 1 the weights, which are "
      "those "
      "of the step's beginning, no longer fit.");
  if (!report.newton.empty()) {
    const bool converged = report.residual <= context.scene.solver.newton_tolerance;
    property("Residual left", quantity(report.residual, "", 2));
    tooltip(converged ? "Below the tolerance: the step's equations are solved."
                      : "Above the tolerance: rounding leaves no lower energy to be found.");
    if (!converged)
      warning("Not converged: above the tolerance of " + quantity(context.scene.solver.newton_tolerance, "", 2) + ".");
  }
  gap();
}

}  // namespace

bool wants_stable_step(const AppContext& context) {
  const int open = context.memory ? context.memory->open_left : -1;
  const auto& all = panels();
  int left = 0;
  for (const Panel& panel : all)
    if (panel.dock == Dock::left && left++ == open) return panel.draw == draw_time_panel;
  return false;
}

void draw_time_panel(AppContext& context) {
  setting_widget(context, "/time/step");
  compare_with_explicit(context.scene, context.snapshot.get());
  judge_step(context);
  setting_widget(context, "/integrator/type");
  setting_widget(context, "/integrator/spectral_radius");
  setting_widget(context, "/time/control");
  setting_widget(context, "/time/tolerance");
  setting_widget(context, "/time/end");
  if (foldable("Advanced")) {
    setting_widget(context, "/time/frame");
    setting_widget(context, "/integrator/mass");
    setting_widget(context, "/integrator/ghost_penalty");
  }
}

}  // namespace pf::app
