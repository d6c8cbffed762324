// Grab: hold the material with the mouse and pull; a click selects a particle.
#pragma once

#include "app/tools/tool.hpp"

namespace pf::app {

std::unique_ptr<Tool> make_grab_tool();

}  // namespace pf::app
