// One setting of a study: run it, look at it, say what kind of run it was.
#pragma once

#include <atomic>

#include "core/simulation.hpp"
#include "core/studies/reference.hpp"
#include "core/studies/row.hpp"
#include "core/studies/study.hpp"

namespace pf {

struct MeasureSettings {
  int samples = 1;
  int threads = 1;
  int repeat = 1;  ///< timed runs, the measured one among them
  double timeout_s = 600;
  StudyThresholds thresholds;
};

/// Runs the scene to its end and measures it. Nothing throws for what is wrong with the run: the row says it.
/// `reference` may be nullptr. `cancelled` tells whether the run was given up for `cancel`; the row is then nothing.
///
/// Energy at play: kinetic and elastic energy at the beginning plus the largest change of potential energy, or what of
/// all three the reference has at most; where these are zero, the largest kinetic energy. Energy gained (lost): how far
/// the total rose above (fell below) what it should be, at worst: what the reference has at that time, or else what it
/// was at first, where nothing outside does work.
StudyRow measure_run(const Scene& scene, const Reference* reference, const MeasureSettings& settings,
                     const std::atomic<bool>* cancel, bool& cancelled);

/// What kind of run the numbers of a row tell of, for a run that came to its end.
RunClass classify(const StudyRow& row, const StudyThresholds& thresholds);

/// Does nothing outside do work on the bodies: no load, no moving constraint or boundary, no manufactured force?
bool conserves_energy(const Scene& scene);
/// Is momentum kept but for gravity: the above, and nothing holds a body?
bool conserves_momentum(const Scene& scene);

}  // namespace pf
