// A chart of core/charts inside a panel: drawn by ImGui, zoomed and panned by the mouse, exported by its menu.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/context.hpp"
#include "app/panels/runs.hpp"
#include "core/charts/chart.hpp"
#include "core/charts/image.hpp"
#include "core/charts/layout.hpp"

namespace pf::app {

/// What the mouse points at: a point of a series, or a cell.
struct PlotTarget {
  std::optional<PointId> point;
  std::optional<std::size_t> cell;
};

/// How a plot differs from one over time.
struct PlotLook {
  bool own_legend = false;  ///< its legend stays in it
  std::string title;        ///< of what is exported; "": the scene's name
  std::string subtitle;     ///< of what is exported
  ImageText about;          ///< written into exported files; empty: the scene's
  /// Says what is under the mouse, in a tooltip; empty: the series' label and values.
  std::function<void(const PlotTarget&)> hover;
  std::function<void(const PlotTarget&)> click;
  /// Paints over the chart.
  std::function<void(const ChartLayout&, const ChartTheme&, Painter&)> overlay;
};

/// Fills the rest of the current window. Wheel zooms about the mouse (Shift: in time only), drag pans, double
/// click shows all again, right click exports. `stem` begins the exported files' names.
void plot(AppContext& context, const char* stem, Chart chart, PlotView& view, const PlotLook& look = {});

}  // namespace pf::app
