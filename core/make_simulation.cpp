// The only place that switches on the dimension.
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "core/bases/basis.hpp"
#include "core/scene/sampling.hpp"
#include "core/scene/scene_io.hpp"
#include "core/simulation.hpp"
#include "core/step/simulation_of.hpp"

namespace pf {

namespace {

std::string gigabytes(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g GB", bytes / 1e9);
  return text;
}

double machine_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

}  // namespace

double estimated_memory(const Scene& scene) {
  const int d = scene.dimension;
  double total = 0;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const double particles = estimated_particles(scene, k);
    const double per_cell = std::pow(scene.bodies[k].particles_per_axis, d);
    // Particle arrays, order and a snapshot; what a step changes of them or the tangents, in one memory; places in
    // cells.
    const double vectors = 8.0 * d * 4 + 8.0 * d * d * 2.5 + 76;
    const double lanes = per_cell < lane_count<3> ? lane_count<3> / per_cell : 1.5;
    const double solve = lanes * 8.0 * d + std::max(lanes * 4.0 * d * d * (d * d + 1) / 2.0, 8.0 * (3 * d + 2 * d * d));
    // About a dozen vectors of d components a node, and the block diagonal.
    const double nodes = (12.0 * 8 * d + 8.0 * d * d + 64) * 2 / per_cell;
    total += particles * (vectors + solve + nodes);
  }
  return total;
}

namespace {

void refuse_beyond_memory(const Scene& scene) {
  const double needed = estimated_memory(scene), available = machine_memory();
  if (needed < 0.9 * available) return;
  throw InputError("", {{"/grid/spacing", "a scene that would need about " + gigabytes(needed) + " of memory",
                         "at most " + gigabytes(0.9 * available) +
                             " on this machine: a larger spacing, smaller bodies or fewer particles_per_axis",
                         0}});
}

}  // namespace

std::unique_ptr<Simulation> make_simulation(const Scene& scene, const SimulationOptions& options) {
  try {
    refuse_beyond_memory(scene);
    if (scene.dimension == 2) return std::make_unique<SimulationOf<2>>(scene, options);
    return std::make_unique<SimulationOf<3>>(scene, options);
  } catch (const InputError& error) {
    if (!error.file().empty() || options.file.empty()) throw;
    throw InputError(options.file, error.problems());
  }
}

}  // namespace pf
