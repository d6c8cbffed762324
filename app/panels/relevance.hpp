// Model no more than a scene needs: which settings have an effect in the scene at hand.
#pragma once

#include <string_view>

#include "core/scene/scene.hpp"

namespace pf::app {

/// False where changing the setting could not change the run: no flip ratio with APIC, no friction on a wall that
/// sticks, no seed for a lattice, no Newton tolerance in an explicit step.
bool scene_uses(const Scene& scene, std::string_view pointer);

}  // namespace pf::app
