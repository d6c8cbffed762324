#include "app/panels/panels.hpp"

#include "app/compare/desk.hpp"

namespace pf::app {

namespace {

bool always(const AppContext&) {
  return true;
}
bool moves(const AppContext& c) {
  return c.scene.integrator.type != "quasi_static";
}
bool solves(const AppContext& c) {
  return c.scene.integrator.type != "symplectic_euler";
}
bool probed(const AppContext& c) {
  return !c.scene.probes.empty();
}
bool in_lesson(const AppContext& c) {
  return c.lesson != nullptr;
}
bool not_comparing(const AppContext& c) {
  return !comparing(c);
}
bool slow(const AppContext& c) {
  return c.slow != nullptr;
}
// While a step is played slowly its own panel has their numbers.
bool selected(const AppContext& c) {
  return c.selected_particle.has_value() && !slow(c) && !comparing(c);
}
bool node_selected(const AppContext& c) {
  return c.selected_node.has_value() && !slow(c) && !comparing(c);
}

}  // namespace

const std::vector<Panel>& panels() {
  static const std::vector<Panel> table{
      {"Scene", Dock::left, always, draw_scene_panel},
      {"Material", Dock::left, always, draw_material_panel},
      {"Time", Dock::left, always, draw_time_panel},
      {"Transfer", Dock::left, moves, draw_transfer_panel},
      {"Solver", Dock::left, solves, draw_solver_panel},
      {"View", Dock::left, always, draw_view_panel},
      {"Outline", Dock::left, always, draw_outline_panel},
      {"Lesson", Dock::right, in_lesson, draw_lesson_panel},
      {"One step", Dock::right, slow, draw_phase_panel},
      {"Particle", Dock::right, selected, draw_particle_panel},
      {"Node", Dock::right, node_selected, draw_node_panel},
      {"Energy", Dock::bottom, always, draw_energy_plot},
      {"Energy balance", Dock::bottom, always, draw_balance_plot},
      {"Momentum", Dock::bottom, always, draw_momentum_plot},
      {"Probes", Dock::bottom, probed, draw_probe_plot},
      {"Convergence", Dock::bottom, solves, draw_convergence_plot},
      {"Time by phase", Dock::bottom, always, draw_phases_plot},
      {"Compare", Dock::bottom, always, draw_compare_panel},
      {"Advice", Dock::bottom, not_comparing, draw_advice_panel},
      {"Studies", Dock::bottom, always, draw_studies_panel},
  };
  return table;
}

}  // namespace pf::app
