// The panels by name; panels.cpp puts them in the table. A new panel: one file, one line here, one there.
#pragma once

#include "app/context.hpp"

namespace pf::app {

void draw_scene_panel(AppContext& context);
void draw_outline_panel(AppContext& context);
void draw_material_panel(AppContext& context);
void draw_time_panel(AppContext& context);
void draw_transfer_panel(AppContext& context);
void draw_solver_panel(AppContext& context);
void draw_view_panel(AppContext& context);

void draw_lesson_panel(AppContext& context);  // app/lessons/panel.cpp
void draw_phase_panel(AppContext& context);   // app/inside/phase_panel.cpp

/// Whether the time panel is open: it compares the time step with what an explicit one could be.
bool wants_stable_step(const AppContext& context);

void draw_particle_panel(AppContext& context);
void draw_node_panel(AppContext& context);

void draw_energy_plot(AppContext& context);
void draw_balance_plot(AppContext& context);
void draw_momentum_plot(AppContext& context);
void draw_probe_plot(AppContext& context);
void draw_convergence_plot(AppContext& context);
void draw_phases_plot(AppContext& context);
void draw_compare_panel(AppContext& context);  // app/compare/panel.cpp
void draw_advice_panel(AppContext& context);   // app/advice/panel.cpp
void draw_studies_panel(AppContext& context);

}  // namespace pf::app
