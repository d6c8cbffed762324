#include "app/panels/limits.hpp"

#include <algorithm>
#include <vector>

#include "core/materials/law.hpp"

namespace pf::app {

double wave_speed(const Material& material) {
  std::vector<double> parameters;
  for (const auto& [key, value] : material.parameters) parameters.push_back(value);
  return make_law<3>(material.model, parameters)->wave_speed(material.density);
}

std::optional<double> fastest_wave(const Scene& scene) {
  std::optional<double> fastest;
  for (const Material& material : scene.materials) {
    const bool used = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                  [&](const Body& b) { return b.material == material.name; });
    if (used) fastest = std::max(fastest.value_or(0), wave_speed(material));
  }
  return fastest;
}

std::optional<double> explicit_limit(const Scene& scene) {
  const auto c = fastest_wave(scene);
  if (!c || !(*c > 0)) return std::nullopt;
  return scene.grid.spacing / *c;
}

}  // namespace pf::app
