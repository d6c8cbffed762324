// What a slowly played step shows over the view: who gives what to whom, and what is not balanced yet.
#pragma once

#include "app/context.hpp"
#include "app/tools/tool.hpp"

namespace pf::app {

void draw_slow_step(Painter& painter, const ViewMap& map, const AppContext& context);
/// Length of its arrows of forces [m/N]; 0 while none are shown.
double slow_force_scale(const StepPlayer& player);

}  // namespace pf::app
