// The list beside a plot: its legend with switches and newest values, and the pinned runs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/context.hpp"

namespace pf::app {

/// Whether list and plot stand side by side; in a narrower drawer the plot gets all of it and its own legend.
bool room_for_list();
/// Starts the list at the left of a plot; when true, end_run_list puts the cursor where the plot goes. Without the
/// room it is behind the button "Curves"; false: closed.
bool begin_run_list();
void end_run_list();

/// A curve's colour, name and newest value; with `on` a switch for it.
void legend_entry(const AppContext& context, std::size_t color_index, std::string_view label, std::string_view value,
                  bool* on = nullptr, bool dashed = false);
/// The Pin button as a tab at the right end of the plots' tabs, and the width it needs.
void pin_tab(AppContext& context);
float pin_width();
/// This run and the pinned ones with what sets them apart, and a cross to unpin each.
void pinned_runs(AppContext& context);

}  // namespace pf::app
