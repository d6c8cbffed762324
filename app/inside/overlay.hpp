// Drawn over the view for those who look inside: shape functions of a particle or of the point under the mouse, the
// selected node, where the residual is largest, and a step that is played slowly.
#pragma once

#include "app/context.hpp"
#include "app/tools/tool.hpp"

namespace pf::app {

/// `mouse` is absent while the cursor is elsewhere.
void draw_inside(Painter& painter, const ViewMap& map, const ViewMouse* mouse, const AppContext& context);

/// Selects the node nearest to the mouse: in 2D of all nodes, in 3D of those about the particle under the mouse.
/// False where there is none.
bool select_node(const ViewMouse& mouse, AppContext& context);

}  // namespace pf::app
