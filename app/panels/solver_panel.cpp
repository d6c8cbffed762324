// Solver: how exactly each step is solved, and how the newest one went.
#include <cctype>

#include "app/panels/panels.hpp"
#include "app/widgets/setting_widget.hpp"
#include "app/widgets/text.hpp"
#include "app/widgets/units.hpp"
#include "core/scene/choices.hpp"

namespace pf::app {

namespace {

/// `choice` as Simulation::solver_choice: the name, and after a colon why.
void tell_solver(const std::string& choice) {
  const std::size_t colon = choice.find(": ");
  const std::string name = choice.substr(0, colon);
  std::string_view label = name;
  for (const Choice& c : solver_choices())
    if (c.name == name) label = c.label;
  property("Solved by", label);
  if (colon == std::string::npos) return;
  std::string why = choice.substr(colon + 2);
  why[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(why[0])));
  muted(why + ".");
}

void newest_step(const StepReport& report, const std::string& choice) {
  heading("Newest step");
  if (!choice.empty()) tell_solver(choice);
  property("Newton iterations", std::to_string(report.newton.size()));
  property("Linear iterations", std::to_string(report.linear_iterations));
  property("Residual left", quantity(report.residual, "", 2));
  tooltip("Unbalanced force relative to the forces at work; the step is accepted below the Newton tolerance.");
  if (report.retries > 0) warning("Begun again " + std::to_string(report.retries) + " times with a smaller step.");
  property("Time taken", quantity(report.ms.total * 1e-3, "s", 3));
}

}  // namespace

void draw_solver_panel(AppContext& context) {
  setting_widget(context, "/solver/newton_tolerance");
  setting_widget(context, "/solver/linear");
  if (context.snapshot && context.snapshot->report.step > 0)
    newest_step(context.snapshot->report, context.status.solver_choice);
  if (!foldable("Advanced")) return;
  setting_widget(context, "/solver/max_newton");
  setting_widget(context, "/solver/line_search");
}

}  // namespace pf::app
