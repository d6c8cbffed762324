// The three docks, filled from the table panels(). The window decides where they are; it begins an ImGui window
// of the right size and calls one of these in it.
#pragma once

#include "app/context.hpp"

namespace pf::app {

/// The settings, one panel open at a time. Call inside a window about 18 em wide; scrolls by itself.
void draw_left_column(AppContext& context);
/// Whether the right column has anything to show (a particle is selected).
bool has_inspector(const AppContext& context);
/// Whether that is text and formulae, which need more room than numbers do.
bool has_wide_inspector(const AppContext& context);
void draw_inspector(AppContext& context);
/// The plots as tabs, filling the window.
void draw_bottom_drawer(AppContext& context);

}  // namespace pf::app
