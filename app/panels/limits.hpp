// The explicit limit: what the time step is compared with.
#pragma once

#include <optional>

#include "core/scene/scene.hpp"

namespace pf::app {

/// Speed of pressure waves in the undeformed material [m/s].
double wave_speed(const Material& material);
/// The fastest of the materials that the scene's bodies are made of [m/s]; nothing without a body.
std::optional<double> fastest_wave(const Scene& scene);
/// dx / c: an explicit step longer than about this is unstable [s].
std::optional<double> explicit_limit(const Scene& scene);

}  // namespace pf::app
