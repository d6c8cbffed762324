// A chart of core/charts inside a panel: drawn by ImGui, zoomed and panned by the mouse, exported by its menu.
#pragma once

#include <string>

#include "app/context.hpp"
#include "app/panels/runs.hpp"
#include "core/charts/chart.hpp"

namespace pf::app {

/// Fills the rest of the current window. Wheel zooms about the mouse (Shift: in time only), drag pans, double
/// click shows all again, right click exports. `stem` begins the exported files' names.
void plot(AppContext& context, const char* stem, Chart chart, PlotView& view);

}  // namespace pf::app
