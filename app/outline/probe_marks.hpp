// Where the probes are, in the colours of their curves.
#pragma once

#include "app/tools/tool.hpp"

namespace pf::app {

/// While the probe tool is in hand or a probe is selected.
void draw_probes(Painter& painter, const ViewMap& map, const AppContext& context);

}  // namespace pf::app
