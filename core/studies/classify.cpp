// Which kind of run a row tells of, and what a scene should keep.
#include <algorithm>

#include "core/studies/measure.hpp"

namespace pf {

namespace {

bool moves(const FormulaVector& velocity) {
  return std::any_of(velocity.begin(), velocity.end(),
                     [](const Formula& f) { return !f.is_number() || f.number != 0; });
}

}  // namespace

RunClass classify(const StudyRow& row, const StudyThresholds& thresholds) {
  // Comparisons with NaN are false: what is not known does not count.
  if (row.energy_gained > thresholds.blown_up) return RunClass::blown_up;
  if (row.energy_gained > thresholds.growing) return RunClass::growing;
  if (row.stress_noise > thresholds.noisy) return RunClass::noisy;
  if (row.energy_lost > thresholds.damped) return RunClass::damped;
  return RunClass::good;
}

bool conserves_energy(const Scene& scene) {
  const auto still = [](const auto& things) {
    return std::none_of(things.begin(), things.end(), [](const auto& thing) { return moves(thing.velocity); });
  };
  const bool rubs =
      std::any_of(scene.boundaries.begin(), scene.boundaries.end(), [](const Boundary& b) { return b.friction > 0; });
  return scene.loads.empty() && scene.body_force.empty() && !scene.manufactured && !rubs && scene.events.empty() &&
         still(scene.constraints) && still(scene.boundaries);
}

bool conserves_momentum(const Scene& scene) {
  return conserves_energy(scene) && scene.constraints.empty() && scene.boundaries.empty();
}

}  // namespace pf
