// Which particles of a 3D body no eye outside of it can see. Internal to render/.
#pragma once

#include <cstdint>
#include <vector>

#include "core/snapshot.hpp"

namespace pf {

/// One flag a particle: 1 where the grid cell around it and its 26 neighbours are all at least three quarters full, so
/// that at least a cell of material hides it from every side. Empty where that cannot be told cheaply.
std::vector<std::uint8_t> hidden_particles(const Snapshot& snapshot);

}  // namespace pf
